#include <array>
#include <cmath>
#include <filesystem>

#include "bench_rows.hpp"
#include "scanfuse/core/parallel.hpp"
#include "scanfuse/evaluate/per_class.hpp"
#include "scanfuse/io/tables.hpp"
#include "track_run.hpp"

namespace scanfuse::app {
namespace {

namespace fs = std::filesystem;

/// What two other programs reach on a recording of model cars: recall, RMSE of position and
/// velocity, ghost movers per frame. Where they come from stands in docs/real-recordings.md.
struct Peer {
  const char* name;
  std::array<double, 4> figures;
};

struct ModelCarBag {
  const char* name;
  const char* role;
  std::array<Peer, 2> peers;
};

constexpr std::array kModelCars{
    ModelCarBag{"overtake_ego",
                kReportingOnly,
                {{{"datmo", {0.893, 0.154, 0.259, 1.20}},
                  {"obstacle_detector", {1.000, 0.173, 0.251, 0.14}}}}},
    ModelCarBag{"overtake_red",
                kChoseConstants,
                {{{"datmo", {1.000, 0.144, 0.188, 1.76}},
                  {"obstacle_detector", {1.000, 0.154, 0.420, 0.06}}}}},
    ModelCarBag{"parallel",
                kReportingOnly,
                {{{"datmo", {1.000, 0.085, 0.204, 1.97}},
                  {"obstacle_detector", {1.000, 0.055, 0.439, 0.14}}}}},
};

BenchRow skipped_row(const std::string& name, const std::string& why) {
  BenchRow row{name, std::nan(""), ""};
  row.skipped = why;
  return row;
}

Result<evaluate::Evaluation> score_model_cars(const fs::path& folder, const std::string& name) {
  TrackRequest request;
  request.input = (folder / (name + ".bag")).string();
  request.preset = "vehicle-model";
  request.ego_topic = "/ego_pose";
  request.mount = {-0.12, 0, 0};
  const auto truth = io::read_truth(folder / (name + ".truth.csv"));
  if (!truth) return tl::unexpected(truth.error());
  const auto steps = track_steps(request);
  if (!steps) return tl::unexpected(steps.error());
  evaluate::EvaluateOptions scoring;
  scoring.match_m = 0.3;
  scoring.min_visible_points = 3;
  scoring.amota_levels = 0;
  return evaluate::evaluate(*steps, *truth, scoring);
}

/// Sums over recordings; a root mean square is weighted by its pairs.
struct ModelCarSums {
  double objects = 0, found = 0, frames = 0, ghosts = 0, switches = 0;
  double pairs = 0, position = 0, velocity = 0, reversed = 0;

  void add(const evaluate::Evaluation& score) {
    const auto& clear = score.clear;
    found += static_cast<double>(clear.true_positives);
    objects += static_cast<double>(clear.true_positives + clear.false_negatives);
    switches += static_cast<double>(clear.identity_switches);
    const auto n = static_cast<double>(score.frames);
    frames += n;
    ghosts += n * score.ghost_movers_per_frame.value_or(0);
    const auto p = static_cast<double>(score.rmse.pairs);
    pairs += p;
    position += p * std::pow(score.rmse.position_m.value_or(0), 2);
    velocity += p * std::pow(score.rmse.velocity_m_per_s.value_or(0), 2);
    reversed += p * score.rmse.heading_reversed_share.value_or(0);
  }
};

struct Measure {
  const char* name;
  double value;
  const char* unit;
  Target target;  ///< of all recordings together
};

std::vector<Measure> measures_of(const ModelCarSums& s) {
  return {{"recall", s.found / s.objects, "", at_least(0.985)},
          {"position RMSE", std::sqrt(s.position / s.pairs), "m", at_most(0.05)},
          {"velocity RMSE", std::sqrt(s.velocity / s.pairs), "m/s", at_most(0.18)},
          {"ghost movers", s.ghosts / s.frames, "a frame", at_most(0.15)},
          {"heading off by more than 90 deg", s.reversed / s.pairs, "share", at_most(0.03)},
          {"identity switches", s.switches, "", at_most(0)}};
}

void add_model_car_rows(const ModelCarBag& bag, const ModelCarSums& sums,
                        std::vector<BenchRow>& rows) {
  const auto measures = measures_of(sums);
  for (std::size_t k = 0; k < measures.size(); ++k) {
    BenchRow row{fmt::format("datmo {} {}", bag.name, measures[k].name), measures[k].value,
                 measures[k].unit};
    row.role = bag.role;
    if (k < bag.peers[0].figures.size()) {
      const double a = bag.peers[0].figures[k], b = bag.peers[1].figures[k];
      const bool first = k == 0 ? a >= b : a <= b;  // recall is better when larger
      row.peer = first ? a : b;
      row.peer_name = first ? bag.peers[0].name : bag.peers[1].name;
    }
    rows.push_back(std::move(row));
  }
}

Result<std::vector<BenchRow>> model_car_rows(const fs::path& folder, int threads) {
  std::array<std::optional<Result<evaluate::Evaluation>>, kModelCars.size()> scores;
  parallel_for(kModelCars.size(), threads, [&](std::size_t i) {
    const std::string name = kModelCars[i].name;
    if (fs::exists(folder / (name + ".bag"))) scores[i] = score_model_cars(folder, name);
  });
  std::vector<BenchRow> rows;
  ModelCarSums reported;
  for (std::size_t i = 0; i < kModelCars.size(); ++i) {
    const auto& bag = kModelCars[i];
    if (!scores[i]) {
      rows.push_back(skipped_row(fmt::format("datmo {}", bag.name),
                                 fmt::format("no {}/{}.bag", folder.string(), bag.name)));
      continue;
    }
    if (!*scores[i]) return tl::unexpected(scores[i]->error());
    ModelCarSums sums;
    sums.add(**scores[i]);
    add_model_car_rows(bag, sums, rows);
    if (bag.role == kReportingOnly) reported.add(**scores[i]);
  }
  if (reported.pairs == 0) return rows;
  for (const auto& measure : measures_of(reported)) {
    BenchRow row{fmt::format("datmo, recordings for reporting: {}", measure.name), measure.value,
                 measure.unit, measure.target};
    row.role = kReportingOnly;
    rows.push_back(std::move(row));
  }
  return rows;
}

/// What the camera saw, and with it whoever labelled: 40 degrees to either side.
evaluate::EvaluateOptions road_scoring(double range_m, int points) {
  evaluate::EvaluateOptions scoring;
  scoring.view_half_angle_rad = radians(40);
  scoring.view_range_m = range_m;
  scoring.min_visible_points = points;
  scoring.ghost_distance_m = 2;
  scoring.amota_levels = 0;
  return scoring;
}

class RoadRows {
 public:
  explicit RoadRows(std::string layers) : layers_(std::move(layers)) {}
  void add(const std::string& name, const std::optional<double>& value, const std::string& unit,
           Target target = {}) {
    if (!value) return;
    BenchRow row{fmt::format("kitti 0000 {}, {}", layers_, name), *value, unit, target};
    row.role = kReportingOnly;
    rows_.push_back(std::move(row));
  }
  [[nodiscard]] std::vector<BenchRow> take() { return std::move(rows_); }

 private:
  std::string layers_;
  std::vector<BenchRow> rows_;
};

void add_class(RoadRows& rows, const std::string& name, const evaluate::ClassEvaluation& one,
               const Target& recall, const Target& precision) {
  const auto& score = one.score;
  rows.add(name + " recall", one.recall, "", recall);
  rows.add(name + " precision", one.precision, "", precision);
  rows.add(name + " HOTA", score.hota.hota, "");
  rows.add(name + " MOTA", score.clear.mota, "");
  rows.add(name + " IDF1", score.identity.idf1, "");
  rows.add(name + " identity switches", static_cast<double>(score.clear.identity_switches), "");
}

/// Of the objects of each class that any track follows, the share called by each class.
void add_confusion(RoadRows& rows, const evaluate::Evaluation& score) {
  for (const auto& [is, said] : score.confusion) {
    double all = 0;
    for (const auto& [name, count] : said) all += static_cast<double>(count);
    for (const auto& [name, count] : said) {
      rows.add(fmt::format("{} called {}", to_string(is), to_string(name)),
               static_cast<double>(count) / all, "share");
    }
  }
}

std::vector<BenchRow> road_rows(const std::string& layers, const std::vector<StepResult>& steps,
                                std::vector<TruthFrame> truth) {
  for (auto& frame : truth) frame.coordinate_frame = "ego";
  const auto near = road_scoring(30, 10);
  const auto wide = road_scoring(50, 3);
  const auto by_class = evaluate::evaluate_by_class(steps, truth, near);
  const auto to_50_m = evaluate::evaluate_by_class(steps, truth, wide);
  RoadRows rows(layers);
  for (const auto& [kind, one] : by_class) {
    const bool cars = kind == ObjectClass::kVehicle;
    add_class(rows, (cars ? "cars and vans" : std::string(to_string(kind))) + " to 30 m", one,
              cars ? at_least(0.95) : Target{}, cars ? at_least(0.80) : Target{});
  }
  if (const auto cars = to_50_m.find(ObjectClass::kVehicle); cars != to_50_m.end()) {
    add_class(rows, "cars and vans to 50 m, 3 points", cars->second, {}, {});
  }
  const auto all = evaluate::evaluate(steps, truth, near);
  add_confusion(rows, all);
  rows.add("ghost movers", all.ghost_movers_per_frame, "a frame");
  return rows.take();
}

Result<std::vector<BenchRow>> road_sequence(const fs::path& folder, const std::string& layers,
                                            const fs::path& scans) {
  TrackRequest request;
  request.input = scans.string();
  request.preset = "road-users";
  request.frame = "ego";
  request.ego_file = (folder / "ego.csv").string();
  auto truth = io::read_truth(folder / "truth_lidar_frame.csv");
  if (!truth) return tl::unexpected(truth.error());
  const auto steps = track_steps(request);
  if (!steps) return tl::unexpected(steps.error());
  return road_rows(layers, *steps, std::move(*truth));
}

}  // namespace

Result<std::vector<BenchRow>> bench_real(const RealData& data, int threads) {
  if (data.folder.empty()) {
    return std::vector{
        skipped_row("real recordings", "name their folder with --data FOLDER or in SCANFUSE_DATA")};
  }
  const fs::path road = fs::path(data.folder) / "road" / "kitti_seq0000";
  const fs::path full = data.full_scans.empty() ? road / "velodyne" : fs::path(data.full_scans);
  auto rows = model_car_rows(fs::path(data.folder) / "datmo", threads);
  if (!rows) return rows;
  const std::array layers{std::pair{"four layers", road / "scans_4layer.points.csv.xz"},
                          std::pair{"64 layers", full}};
  for (const auto& [name, scans] : layers) {
    if (!fs::exists(scans)) {
      rows->push_back(skipped_row(fmt::format("kitti 0000 {}", name),
                                  fmt::format("no {}; KITTI .bin files elsewhere are named with "
                                              "--full-scans FOLDER",
                                              scans.string())));
      continue;
    }
    const auto more = road_sequence(road, name, scans);
    if (!more) return more;
    rows->insert(rows->end(), more->begin(), more->end());
  }
  return rows;
}

}  // namespace scanfuse::app
