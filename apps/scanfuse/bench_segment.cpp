#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <string_view>
#include <utility>

#include "bench_rows.hpp"
#include "scanfuse/segment/score.hpp"
#include "scanfuse/segment/segmenter.hpp"
#include "scanfuse/shape/join.hpp"
#include "scanfuse/simulate/segmentation_scenes.hpp"

namespace scanfuse::app {
namespace {

using segment::ObjectScore;
using segment::Segmenter;
using segment::SegmentMethod;
using segment::SegmentOptions;

struct Share {
  int right = 0;
  int all = 0;
  void count(bool is_right) {
    right += is_right;
    ++all;
  }
  [[nodiscard]] double value() const { return all > 0 ? static_cast<double>(right) / all : 0; }
};

struct Contender {
  std::string name;
  SegmentOptions options;
  shape::JoinMethod join = shape::JoinMethod::kNone;
};

/// A way of segmentation, then of joining what it cut apart.
class Cutter {
 public:
  explicit Cutter(const Contender& contender)
      : segment_(contender.options), join_(options_of(contender), {}, {}) {}
  const Clusters& operator()(const VirtualScan& scan) { return join_(scan, segment_(scan), {}); }

 private:
  static shape::JoinOptions options_of(const Contender& contender) {
    shape::JoinOptions options;
    options.method = contender.join;
    return options;
  }
  Segmenter segment_;
  shape::ClusterJoiner join_;
};

std::vector<Contender> contenders() {
  std::vector<Contender> all;
  for (const auto& [name, method] : choices(SegmentMethod{})) {
    SegmentOptions options;
    options.method = method;
    all.push_back({name, options});
  }
  for (const auto& [name, method] :
       {std::pair{"pag", SegmentMethod::kPag}, std::pair{"surface", SegmentMethod::kSurface},
        std::pair{"breakpoint", SegmentMethod::kBreakpoint}}) {
    for (const auto join : {shape::JoinMethod::kOccluder, shape::JoinMethod::kGuo}) {
      SegmentOptions options;
      options.method = method;
      const char* how = join == shape::JoinMethod::kGuo ? "guo" : "joined";
      all.push_back({fmt::format("{} {}", name, how), options, join});
    }
  }
  SegmentOptions square;
  square.pag.cells = segment::PagCells::kSquare;
  all.push_back({"pag square", square});
  SegmentOptions notched;
  notched.pag.notch_m = segment::SurfaceOptions{}.notch_m;
  all.push_back({"pag notched", notched});
  all.push_back({"pag notched joined", notched, shape::JoinMethod::kOccluder});
  return all;
}

/// What is promised of Pag: 0.97 to 20 m, 0.95 to 50 m.
Target promised(std::string_view name, int range_m) {
  if (name != "pag" || range_m > 50) return {};
  return at_least(range_m <= 20 ? 0.97 : 0.95);
}

/// One car in free sight at each range.
void add_range_ladder(std::vector<BenchRow>& rows, const Contender& contender,
                      const SeedRange& seeds, bool stray) {
  Cutter cut(contender);
  simulate::SegmentationSceneOptions options;
  options.stray_return = stray;
  for (int range_m = 10; range_m <= 60; range_m += 10) {
    Share share;
    for (int i = 0; i < seeds.count; ++i) {
      const auto scene = simulate::range_ladder_scene(
          range_m, seeds.first + static_cast<std::uint64_t>(i), options);
      for (const ObjectScore& score : segment::score_clusters(cut(scene.scan), scene.label)) {
        share.count(score.right());
      }
    }
    rows.push_back({fmt::format("ladder/{}/{} m{}", contender.name, range_m, stray ? "/stray" : ""),
                    share.value(), "share right", promised(contender.name, range_m)});
  }
}

/// Random traffic: by range, and by class.
void add_scenes(std::vector<BenchRow>& rows, const Contender& contender, const SeedRange& seeds,
                bool stray) {
  Cutter cut(contender);
  simulate::SegmentationSceneOptions options;
  options.stray_return = stray;
  std::array<Share, 7> by_range;
  std::array<Share, 5> by_class;
  Share all;
  for (int i = 0; i < seeds.count; ++i) {
    const auto scene =
        simulate::segmentation_scene(seeds.first + static_cast<std::uint64_t>(i), options);
    for (const ObjectScore& score : segment::score_clusters(cut(scene.scan), scene.label)) {
      const auto& object = scene.objects[static_cast<std::size_t>(score.object)];
      const auto bin = static_cast<std::size_t>(object.box.centre_m.norm() / 10);
      if (object.object_class == ObjectClass::kVehicle && bin < by_range.size()) {
        by_range[bin].count(score.right());
      }
      by_class[static_cast<std::size_t>(object.object_class)].count(score.right_by_iou());
      all.count(score.right_by_iou());
    }
  }
  const char* tail = stray ? "/stray" : "";
  for (std::size_t bin = 0; bin < 6; ++bin) {
    const int upper_m = 10 * (static_cast<int>(bin) + 1);
    rows.push_back(
        {fmt::format("scenes/{}/vehicles {}-{} m{}", contender.name, upper_m - 10, upper_m, tail),
         by_range[bin].value(), "share right", promised(contender.name, upper_m)});
  }
  for (const auto c : {ObjectClass::kVehicle, ObjectClass::kPedestrian, ObjectClass::kCyclist}) {
    rows.push_back({fmt::format("scenes/{}/{} IoU >= 0.7{}", contender.name, to_string(c), tail),
                    by_class[static_cast<std::size_t>(c)].value(), "share right"});
  }
  rows.push_back({fmt::format("scenes/{}/all IoU >= 0.7{}", contender.name, tail), all.value(),
                  "share right"});
}

/// Median time of one scan of 440 beams, over 300 scenes, after a first round.
void add_speed(std::vector<BenchRow>& rows, const Contender& contender, const SeedRange& seeds) {
  using Clock = std::chrono::steady_clock;
  Cutter cut(contender);
  std::vector<double> times_us;
  for (int i = 0; i < seeds.count; ++i) {
    const auto scene = simulate::segmentation_scene(seeds.first + static_cast<std::uint64_t>(i));
    for (int repeat = 0; repeat < 5; ++repeat) {
      const auto start = Clock::now();
      const std::size_t found = cut(scene.scan).size();
      const double us = std::chrono::duration<double, std::micro>(Clock::now() - start).count();
      if (repeat > 0 && found <= scene.scan.points.size()) times_us.push_back(us);
    }
  }
  if (times_us.empty()) return;
  rows.push_back({fmt::format("speed/{}/440 beams", contender.name), median_of(std::move(times_us)),
                  "us per scan"});
}

}  // namespace

std::vector<BenchRow> bench_segment(const SeedRange& seeds) {
  std::vector<BenchRow> rows;
  for (const Contender& contender : contenders()) {
    for (const bool stray : {false, true}) {
      add_range_ladder(rows, contender, seeds, stray);
      add_scenes(rows, contender, seeds, stray);
    }
    add_speed(rows, contender, seeds);
  }
  return rows;
}

}  // namespace scanfuse::app
