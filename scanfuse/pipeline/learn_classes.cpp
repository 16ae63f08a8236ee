#include "scanfuse/pipeline/learn_classes.hpp"

#include <algorithm>
#include <cmath>

#include "scanfuse/classify/fit_softmax.hpp"
#include "scanfuse/classify/vehicle_rules.hpp"
#include "scanfuse/pipeline/config.hpp"

namespace scanfuse::pipeline {
namespace {

constexpr double kAboutBox_m = 0.25;
constexpr double kNominalStep_s = 0.1;

/// Sizes where truth tells none.
Eigen::Vector2d usual_size(ObjectClass kind) {
  if (kind == ObjectClass::kVehicle) return {4.4, 1.8};
  if (kind == ObjectClass::kCyclist) return {1.8, 0.8};
  return {0.8, 0.8};
}

/// A truth box in the levelled sensor frame, with its motion over ground there.
struct TrueBox {
  Box2 box;
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();
  ObjectClass kind = ObjectClass::kUnknown;

  [[nodiscard]] bool holds(const PlanarPoint& p) const {
    const double t = p.time_offset_s;
    return box.contains(Eigen::Vector2d(p.x_m, p.y_m) - t * velocity);
  }
};

std::vector<TrueBox> boxes_of(const PosedScan& posed, const TruthFrame& truth) {
  const Eigen::Vector3d mount = posed.ego_from_sensor.translation_m;
  const Pose2 ego_from_level{mount.x(), mount.y(), 0};
  const Pose2 level_from_truth = truth.coordinate_frame == "ego"
                                     ? ego_from_level.inverse()
                                     : (posed.world_from_ego.planar() * ego_from_level).inverse();
  const Eigen::Rotation2Dd turn(level_from_truth.heading_rad);
  std::vector<TrueBox> boxes;
  for (const TruthObject& object : truth.objects) {
    const Eigen::Vector2d usual = usual_size(object.object_class);
    TrueBox& added = boxes.emplace_back();
    added.box.centre_m = level_from_truth * object.position_m;
    added.box.heading_rad = level_from_truth.heading_rad + object.heading_rad.value_or(0);
    added.box.length_m = object.length_m.value_or(usual.x()) + 2 * kAboutBox_m;
    added.box.width_m = object.width_m.value_or(usual.y()) + 2 * kAboutBox_m;
    added.kind = object.object_class;
    if (object.velocity_m_per_s) added.velocity = turn * *object.velocity_m_per_s;
  }
  return boxes;
}

std::optional<int> label_of(const VirtualScan& scan, std::span<const std::uint32_t> points,
                            const std::vector<TrueBox>& boxes) {
  std::size_t held = 0, most = 0;
  ObjectClass kind = ObjectClass::kUnknown;
  for (const TrueBox& box : boxes) {
    const auto inside = static_cast<std::size_t>(std::count_if(
        points.begin(), points.end(), [&](auto i) { return box.holds(scan.points[i]); }));
    held += inside;
    if (inside > most) {
      most = inside;
      kind = box.kind;
    }
  }
  if (10 * held < points.size()) return static_cast<int>(ObjectClass::kOther) - 1;
  if (2 * most < points.size() || kind == ObjectClass::kUnknown) return std::nullopt;
  return static_cast<int>(kind) - 1;
}

classify::Interval quantiles(std::vector<double> values) {
  constexpr double kTail = 0.02;
  constexpr std::size_t kLeast = 20;
  if (values.size() < kLeast) return {};
  std::sort(values.begin(), values.end());
  const auto last = static_cast<double>(values.size() - 1);
  return {values[static_cast<std::size_t>(kTail * last)],
          values[static_cast<std::size_t>((1 - kTail) * last)]};
}

classify::ClassIntervals intervals_of(std::span<const OutlineSample> samples, int label) {
  std::vector<double> l, one, l1, l2, two;
  for (const OutlineSample& s : samples) {
    if (s.label != label) continue;
    if (s.lines == 1) {
      l.push_back(s.l1_m);
      one.push_back(s.var_r_m2);
    } else if (s.lines == 2) {
      l1.push_back(s.l1_m);
      l2.push_back(s.l2_m);
      two.push_back(s.var_r_m2);
    }
  }
  classify::ClassIntervals of;
  of.l = quantiles(l);
  of.var_r_of_one = quantiles(one);
  if (classify::learned_class(label) == ObjectClass::kPedestrian) return of;  // one line [Guo]
  of.l1 = quantiles(l1);
  of.l2 = quantiles(l2);
  of.var_r_of_two = quantiles(two);
  return of;
}

void standardise(std::span<const OutlineSample> samples, classify::SoftmaxModel& model) {
  const auto count = static_cast<double>(std::max<std::size_t>(samples.size(), 1));
  for (int i = 0; i < classify::kFeatures; ++i) {
    double sum = 0, squares = 0;
    for (const auto& s : samples) sum += s.features[i];
    for (const auto& s : samples) squares += std::pow(s.features[i] - sum / count, 2);
    model.mean[i] = sum / count;
    model.scale[i] = std::max(std::sqrt(squares / count), 1e-3);
  }
}

std::vector<int> labels_of(const auto& samples) {
  std::vector<int> labels;
  for (const auto& s : samples) labels.push_back(s.label);
  return labels;
}

std::vector<float> shares_of(const auto& samples) {
  std::vector<float> shares;
  for (const auto& s : samples) shares.push_back(s.share);
  return shares;
}

/// Shares of the classes, none below a thousandth.
std::array<double, classify::kLearnedClasses> prior_of(const auto& samples) {
  std::array<double, classify::kLearnedClasses> prior{};
  double all = 0;
  for (const auto& s : samples) {
    prior[static_cast<std::size_t>(s.label)] += s.share;
    all += s.share;
  }
  for (double& p : prior) p = std::max(p / std::max(all, 1e-9), 1e-3);
  return prior;
}

OutlineSample sample_of(std::span<const Outline> outlines, std::size_t of, int label, float share,
                        const std::shared_ptr<const Classes>& classes) {
  const Outline& outline = outlines[of];
  const double by_rules = classify::vehicle_score(outline, classify::RecognizerOptions{});
  OutlineSample sample;
  sample.features = classify::features_of(outlines, of, by_rules);
  sample.label = label;
  sample.share = share;
  sample.lines = static_cast<int>(outline.lines.size());
  sample.var_r_m2 = outline.var_range_m2;
  if (!outline.lines.empty()) {
    const auto [less, more] =
        std::minmax({outline.lines.front().length_m(), outline.lines.back().length_m()});
    sample.l1_m = more;
    sample.l2_m = less;
  }
  if (classes) {
    sample.by_intervals = classify::class_by_intervals(outline, classes->recognizer.intervals);
  }
  return sample;
}

}  // namespace

std::vector<std::optional<int>> label_outlines(const Perception& perception, const PosedScan& posed,
                                               const TruthFrame& truth) {
  const auto boxes = boxes_of(posed, truth);
  const Clusters& clusters = perception.clusters();
  std::vector<std::optional<int>> labels;
  labels.reserve(clusters.size());
  for (std::size_t k = 0; k < clusters.size(); ++k) {
    labels.push_back(clusters[k].empty() ? std::nullopt
                                         : label_of(perception.virtual_scan(), clusters[k], boxes));
  }
  return labels;
}

PerceptionOptions learning_chain(const std::shared_ptr<const Classes>& classes) {
  PerceptionOptions options;
  options.classify.keep = classify::Keep::kRoadUsers;
  options.track.class_mismatch_cost = 100;
  if (!classes) return options;
  options.classify.method = classify::Method::kSoftmax;
  use_classes(options, classes);
  if (classes->belief.weights.isZero()) options.track.belief = nullptr;
  return options;
}

SampleCollector::SampleCollector(const std::shared_ptr<const Classes>& classes)
    : classes_(classes), perception_(learning_chain(classes)) {}

void SampleCollector::add(const PosedScan& posed, const TruthFrame& truth, bool keep) {
  last_ = &perception_.step(posed);
  const double dt_s = before_ ? to_seconds(posed.scan.stamp - *before_) : kNominalStep_s;
  before_ = posed.scan.stamp;
  const auto share = static_cast<float>(std::clamp(dt_s / kNominalStep_s, 0.01, 1.0));
  const auto labels = label_outlines(perception_, posed, truth);
  const int least = classify::RecognizerOptions{}.min_points;
  for (std::size_t k = 0; keep && k < labels.size(); ++k) {
    const Outline& outline = perception_.outlines()[k];
    if (!labels[k] || outline.points < least) continue;
    outlines.push_back(sample_of(perception_.outlines(), k, *labels[k], share, classes_));
  }
  if (classes_) take_tracks(labels, share, keep);
}

void SampleCollector::take_tracks(std::span<const std::optional<int>> labels, float share,
                                  bool keep) {
  for (const Track& t : last_->tracks) {
    if (t.detection < 0) continue;
    const Detection& detection = last_->detections[static_cast<std::size_t>(t.detection)];
    const Eigen::Vector2d place(t.state.mean(0), t.state.mean(2));
    const double variance = (t.state.covariance(1, 1) + t.state.covariance(3, 3)) / 2;
    auto& belief = beliefs_[t.id];
    belief.add({detection.class_probability, detection.cues, place, last_->stamp},
               classes_->belief);
    const auto& label = labels[perception_.sources()[static_cast<std::size_t>(t.detection)]];
    if (!keep || !label || belief.is_empty()) continue;
    tracks.push_back({belief.terms({place, t.speed_m_per_s, std::sqrt(std::max(variance, 0.0))}),
                      *label, share});
  }
}

classify::ClassModel fit_recognizer(std::span<const OutlineSample> samples) {
  classify::ClassModel model;
  for (int c = 0; c < 3; ++c) model.intervals[c] = intervals_of(samples, c);
  standardise(samples, model.softmax);
  Eigen::MatrixXf terms(static_cast<Eigen::Index>(samples.size()), classify::kTerms);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    terms.row(static_cast<Eigen::Index>(i)) =
        model.softmax.terms(samples[i].features).cast<float>().transpose();
  }
  const auto labels = labels_of(samples);
  const auto shares = shares_of(samples);
  classify::SoftmaxFitOptions options;
  options.l2 = 3e-5;
  options.max_iterations = 400;
  model.softmax.weights =
      fit_softmax(terms, labels, shares, classify::kLearnedClasses, options).weights;
  model.softmax.prior = prior_of(samples);
  return model;
}

double fit_recognizer_temperature(const classify::SoftmaxModel& model,
                                  std::span<const OutlineSample> samples) {
  Eigen::MatrixXd logits(static_cast<Eigen::Index>(samples.size()), classify::kLearnedClasses);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    logits.row(static_cast<Eigen::Index>(i)) =
        (model.weights * model.terms(samples[i].features)).transpose();
  }
  return classify::fit_temperature(logits, labels_of(samples));
}

Eigen::MatrixXd fit_belief(std::span<const TrackSample> samples) {
  Eigen::MatrixXf terms(static_cast<Eigen::Index>(samples.size()), track::kBeliefTerms);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    terms.row(static_cast<Eigen::Index>(i)) = samples[i].terms.cast<float>().transpose();
  }
  const auto labels = labels_of(samples);
  const auto shares = shares_of(samples);
  classify::SoftmaxFitOptions options;
  options.l2 = 1e-4;
  options.max_iterations = 400;
  return fit_softmax(terms, labels, shares, track::kBelievedClasses, options).weights;
}

}  // namespace scanfuse::pipeline
