#include "learn_run.hpp"

#include <cmath>
#include <mutex>

#include "scanfuse/core/parallel.hpp"
#include "scanfuse/io/tables.hpp"
#include "scanfuse/pipeline/scan_variation.hpp"

namespace scanfuse::app {
namespace {

enum class Role { kFit, kCalibrate, kTest };

/// Two of five recordings to fit, two to calibrate, one to test; fewer than five are cut by time.
Role role_of(std::size_t recording, std::size_t recordings, double done) {
  if (recordings >= 5) {
    constexpr std::array kRoles{Role::kFit, Role::kCalibrate, Role::kFit, Role::kCalibrate,
                                Role::kTest};
    return kRoles[recording % kRoles.size()];
  }
  return done < 0.5 ? Role::kFit : done < 0.75 ? Role::kCalibrate : Role::kTest;
}

/// Truth by stamp; a table's by frame where its stamps are not the scans'.
class TruthBook {
 public:
  static Result<TruthBook> read(const std::string& recording, const std::string& table,
                                Diagnostics& diagnostics) {
    TruthBook book;
    std::vector<TruthFrame> frames;
    if (!table.empty()) {
      auto read = io::read_truth(table, &diagnostics);
      if (!read) return tl::unexpected(read.error());
      frames = std::move(*read);
    } else {
      auto reader = io::open_recording(recording);
      if (!reader) return tl::unexpected(reader.error());
      while (true) {
        auto event = (*reader)->next();
        if (!event) return tl::unexpected(event.error());
        if (!*event) break;
        if (auto* frame = std::get_if<TruthFrame>(&(*event)->payload)) {
          frames.push_back(std::move(*frame));
        }
      }
    }
    if (frames.empty()) {
      return fail(Error::Code::kNotFound,
                  "{}: holds no truth; give --truth truth.csv, or a recording written by "
                  "`scanfuse simulate`",
                  recording);
    }
    for (auto& frame : frames) {
      book.frame_of_stamp_[to_nanos(frame.stamp)] = frame.frame;
      book.by_frame_[frame.frame] = std::move(frame);
    }
    return book;
  }

  [[nodiscard]] const TruthFrame* of(const Scan& scan) const {
    const auto stamped = frame_of_stamp_.find(to_nanos(scan.stamp));
    const auto found =
        by_frame_.find(stamped != frame_of_stamp_.end() ? stamped->second : scan.frame);
    return found != by_frame_.end() ? &found->second : nullptr;
  }
  [[nodiscard]] double frames() const { return static_cast<double>(by_frame_.size()); }

 private:
  std::map<std::int64_t, std::int64_t> frame_of_stamp_;
  std::map<std::int64_t, TruthFrame> by_frame_;
};

struct Gathered {
  std::vector<pipeline::OutlineSample> outlines;
  std::vector<pipeline::TrackSample> tracks;
  evaluate::ClassScore score;
  Diagnostics diagnostics;
};

class Learning {
 public:
  Learning(const LearnRequest& request, const CommonOptions& common)
      : request_(request), common_(common) {}

  /// What the scans of one role give, of all recordings in their order.
  Result<Gathered> gather(Role role, const std::shared_ptr<const pipeline::Classes>& classes) {
    std::vector<Result<Gathered>> parts(request_.inputs.size(), Gathered{});
    parallel_for(parts.size(), common_.threads,
                 [&](std::size_t i) { parts[i] = gather_one(i, role, classes); });
    Gathered all;
    for (auto& part : parts) {
      if (!part) return tl::unexpected(part.error());
      all.outlines.insert(all.outlines.end(), part->outlines.begin(), part->outlines.end());
      all.tracks.insert(all.tracks.end(), part->tracks.begin(), part->tracks.end());
      all.score.merge(part->score);
      all.diagnostics.merge(part->diagnostics);
    }
    return all;
  }

 private:
  Result<Gathered> gather_one(std::size_t i, Role role,
                              const std::shared_ptr<const pipeline::Classes>& classes) const {
    const std::size_t n = request_.inputs.size();
    Gathered out;
    if (n >= 5 && role_of(i, n, 0) != role) return out;
    const std::string& input = request_.inputs[i];
    const auto truth = TruthBook::read(
        input, request_.truths.empty() ? std::string() : request_.truths[i], out.diagnostics);
    if (!truth) return tl::unexpected(truth.error());
    auto reader = io::open_recording(input);
    if (!reader) return tl::unexpected(reader.error());
    pipeline::FeedOptions feed_options;
    if (!request_.ego.empty()) {
      auto ego = io::read_ego(request_.ego);
      if (!ego) return tl::unexpected(ego.error());
      feed_options.ego = std::move(*ego);
    }
    pipeline::ScanFeed feed(std::move(*reader), std::move(feed_options));
    pipeline::SampleCollector collector(classes);
    pipeline::ScanVariation vary(i);
    double done = 0;
    while (!interrupted) {
      auto posed = feed.next();
      if (!posed) return tl::unexpected(posed.error());
      if (!*posed) break;
      (void)feed.take_truth();
      if (request_.vary && role != Role::kTest) vary((*posed)->scan);
      const TruthFrame* frame = truth->of((*posed)->scan);
      if (frame == nullptr) continue;
      const bool keep = role_of(i, n, done++ / truth->frames()) == role;
      collector.add(**posed, *frame, keep);
      if (keep && role == Role::kTest) out.score.add(collector.last(), *frame);
    }
    if (done == 0 && !interrupted) {
      return fail(Error::Code::kNotFound, "{}: no scan in it that the truth speaks of", input);
    }
    out.outlines = std::move(collector.outlines);
    out.tracks = std::move(collector.tracks);
    out.diagnostics.merge(feed.diagnostics());
    return out;
  }

  const LearnRequest& request_;
  const CommonOptions& common_;
};

int most_likely(const ClassProbabilities& p) {
  int best = 0;
  for (int c = 1; c < classify::kLearnedClasses; ++c) {
    if (p[c + 1] > p[best + 1]) best = c;
  }
  return best;
}

void score_outlines(const Gathered& test, LearnOutcome& outcome) {
  for (const auto& sample : test.outlines) {
    const auto p = outcome.classes.recognizer.softmax(sample.features);
    const int said = most_likely(p);
    outcome.outlines.add(p[said + 1], said == sample.label);
    ++outcome.softmax[sample.label][said];
    const int by_intervals = sample.by_intervals ? static_cast<int>(*sample.by_intervals) - 1
                                                 : classify::kLearnedClasses;
    ++outcome.intervals[sample.label][by_intervals];
  }
}

Result<void> every_class_in(const std::vector<pipeline::OutlineSample>& samples) {
  std::array<int, classify::kLearnedClasses> count{};
  for (const auto& s : samples) ++count[s.label];
  for (int c = 0; c < classify::kLearnedClasses; ++c) {
    if (count[c] >= 20) continue;
    return fail(Error::Code::kNotFound,
                "{} labelled outlines of class {} are too few to learn from; give more recordings",
                count[c], to_string(classify::learned_class(c)));
  }
  return {};
}

}  // namespace

Result<LearnOutcome> run_learn(const LearnRequest& request, const CommonOptions& common) {
  Learning learning(request, common);
  LearnOutcome outcome;
  outcome.cut_by_time = request.inputs.size() < 5;
  auto fit = learning.gather(Role::kFit, nullptr);
  if (!fit) return tl::unexpected(fit.error());
  if (interrupted) return outcome;
  if (auto enough = every_class_in(fit->outlines); !enough) return tl::unexpected(enough.error());
  outcome.fit_outlines = std::ssize(fit->outlines);
  outcome.diagnostics = std::move(fit->diagnostics);
  outcome.classes.recognizer = pipeline::fit_recognizer(fit->outlines);
  outcome.classes.belief.prior = outcome.classes.recognizer.softmax.prior;
  outcome.classes.belief.weights.setZero();
  fit->outlines.clear();

  auto rough = std::make_shared<pipeline::Classes>(outcome.classes);
  const auto calibration = learning.gather(Role::kCalibrate, rough);
  if (!calibration) return tl::unexpected(calibration.error());
  if (interrupted) return outcome;
  outcome.calibration_outlines = std::ssize(calibration->outlines);
  outcome.calibration_tracks = std::ssize(calibration->tracks);
  outcome.classes.recognizer.softmax.temperature = pipeline::fit_recognizer_temperature(
      outcome.classes.recognizer.softmax, calibration->outlines);
  outcome.classes.belief.weights = pipeline::fit_belief(calibration->tracks);

  const auto test =
      learning.gather(Role::kTest, std::make_shared<pipeline::Classes>(outcome.classes));
  if (!test) return tl::unexpected(test.error());
  outcome.test_outlines = std::ssize(test->outlines);
  score_outlines(*test, outcome);
  outcome.tracks = test->score;
  return outcome;
}

}  // namespace scanfuse::app
