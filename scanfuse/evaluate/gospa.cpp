#include "scanfuse/evaluate/gospa.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "scanfuse/core/assignment.hpp"

namespace scanfuse::evaluate {
namespace {

Eigen::MatrixXd cut_off_powers(const Eigen::MatrixXd& distance_m, const EvaluateOptions& o) {
  return distance_m.array().min(o.gospa_c_m).pow(o.gospa_p);
}

/// Of each id in a window of frames, where it was; index 0 is the oldest frame.
using Paths = std::map<int, std::map<std::size_t, Eigen::Vector2d>>;

double path_distance_m(const std::map<std::size_t, Eigen::Vector2d>& a,
                       const std::map<std::size_t, Eigen::Vector2d>& b, double c_m) {
  double sum = 0;
  std::size_t both = 0;
  for (const auto& [k, position] : a) {
    const auto other = b.find(k);
    if (other == b.end()) continue;
    const double d = (position - other->second).norm();
    sum += std::isfinite(d) ? std::min(d, c_m) : c_m;
    ++both;
  }
  const std::size_t either = a.size() + b.size() - both;
  return (sum + static_cast<double>(either - both) * c_m) / static_cast<double>(either);
}

double ospa2_at(const Paths& truth, const Paths& tracks, const EvaluateOptions& options) {
  Eigen::MatrixXd distance(static_cast<long>(truth.size()), static_cast<long>(tracks.size()));
  long i = 0;
  for (const auto& [truth_id, path] : truth) {
    long j = 0;
    for (const auto& [track_id, other] : tracks) {
      distance(i, j++) = path_distance_m(path, other, options.gospa_c_m);
    }
    ++i;
  }
  return ospa_m(distance, options);
}

void enter(Paths& truth, Paths& tracks, const ScoredFrame& frame, std::size_t k) {
  for (std::size_t i = 0; i < frame.truth.size(); ++i) {
    truth[frame.truth_index[i]].insert_or_assign(k, frame.truth[i].position_m);
  }
  for (std::size_t j = 0; j < frame.tracks.size(); ++j) {
    tracks[frame.track_index[j]].insert_or_assign(k, frame.tracks[j].box.centre_m);
  }
}

void leave(Paths& paths, std::size_t k) {
  for (auto it = paths.begin(); it != paths.end();) {
    it->second.erase(k);
    it = it->second.empty() ? paths.erase(it) : std::next(it);
  }
}

double mean_ospa2_m(const Sequence& sequence, const EvaluateOptions& options) {
  const auto window = static_cast<std::size_t>(options.ospa2_window_frames);
  Paths truth, tracks;
  double sum = 0;
  for (std::size_t k = 0; k < sequence.frames.size(); ++k) {
    if (k >= window) {
      leave(truth, k - window);
      leave(tracks, k - window);
    }
    enter(truth, tracks, sequence.frames[k], k);
    sum += ospa2_at(truth, tracks, options);
  }
  return sum / static_cast<double>(sequence.frames.size());
}

}  // namespace

Gospa gospa(const Eigen::MatrixXd& distance_m, const EvaluateOptions& options) {
  const Eigen::MatrixXd powers = cut_off_powers(distance_m, options);
  const double cut_power = std::pow(options.gospa_c_m, options.gospa_p);
  double missed = static_cast<double>(distance_m.rows());
  double false_tracks = static_cast<double>(distance_m.cols());
  Gospa result;
  const auto columns = solve_assignment(powers);
  for (int i = 0; i < powers.rows(); ++i) {
    if (columns[i] < 0) continue;
    if (options.gospa_alpha == 2 && !(distance_m(i, columns[i]) < options.gospa_c_m)) continue;
    result.localisation += powers(i, columns[i]);
    missed -= 1;
    false_tracks -= 1;
  }
  result.missed = missed * cut_power / options.gospa_alpha;
  result.false_tracks = false_tracks * cut_power / options.gospa_alpha;
  result.total_m =
      std::pow(result.localisation + result.missed + result.false_tracks, 1.0 / options.gospa_p);
  return result;
}

double ospa_m(const Eigen::MatrixXd& distance_m, const EvaluateOptions& options) {
  const auto larger = static_cast<double>(std::max(distance_m.rows(), distance_m.cols()));
  const auto smaller = static_cast<double>(std::min(distance_m.rows(), distance_m.cols()));
  if (larger == 0) return 0;
  const Eigen::MatrixXd powers = cut_off_powers(distance_m, options);
  double sum = std::pow(options.gospa_c_m, options.gospa_p) * (larger - smaller);
  const auto columns = solve_assignment(powers);
  for (int i = 0; i < powers.rows(); ++i) {
    if (columns[i] >= 0) sum += powers(i, columns[i]);
  }
  return std::pow(sum / larger, 1.0 / options.gospa_p);
}

SetMetrics set_metrics(const Sequence& sequence, const EvaluateOptions& options) {
  SetMetrics means;
  if (sequence.frames.empty()) return means;
  Gospa sum;
  double ospa_sum = 0;
  for (const auto& frame : sequence.frames) {
    const Gospa one = gospa(frame.distance_m, options);
    sum.total_m += one.total_m;
    sum.localisation += one.localisation;
    sum.missed += one.missed;
    sum.false_tracks += one.false_tracks;
    ospa_sum += ospa_m(frame.distance_m, options);
  }
  const auto n = static_cast<double>(sequence.frames.size());
  means.gospa_m = sum.total_m / n;
  means.localisation = sum.localisation / n;
  means.missed = sum.missed / n;
  means.false_tracks = sum.false_tracks / n;
  means.ospa_m = ospa_sum / n;
  means.ospa2_m = mean_ospa2_m(sequence, options);
  return means;
}

}  // namespace scanfuse::evaluate
