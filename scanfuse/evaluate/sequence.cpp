#include "scanfuse/evaluate/sequence.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "scanfuse/core/assignment.hpp"
#include "scanfuse/evaluate/align.hpp"

namespace scanfuse::evaluate {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

Eigen::MatrixXd centre_distances(const std::vector<TruthObject>& truth,
                                 const std::vector<Track>& tracks) {
  Eigen::MatrixXd distance(static_cast<long>(truth.size()), static_cast<long>(tracks.size()));
  for (std::size_t i = 0; i < truth.size(); ++i) {
    for (std::size_t j = 0; j < tracks.size(); ++j) {
      const double d = (truth[i].position_m - tracks[j].box.centre_m).norm();
      distance(static_cast<long>(i), static_cast<long>(j)) = std::isfinite(d) ? d : kNever;
    }
  }
  return distance;
}

bool inside_region(const Eigen::Vector2d& p, const EvaluateOptions& o) {
  return p.x() >= o.region_x0_m && p.x() <= o.region_x1_m && p.y() >= o.region_y0_m &&
         p.y() <= o.region_y1_m;
}

/// Inside the part of the view that counts, from the ego vehicle.
bool inside_view(const Eigen::Vector2d& p, const ScoredFrame& frame, const EvaluateOptions& o) {
  const Eigen::Vector2d d = p - frame.viewer_m;
  const double bearing = wrap_pi(std::atan2(d.y(), d.x()) - frame.viewer_heading_rad);
  return d.norm() <= o.view_range_m && std::abs(bearing) <= o.view_half_angle_rad;
}

bool inside(const Eigen::Vector2d& p, const ScoredFrame& frame, const EvaluateOptions& options) {
  return inside_region(p, options) && inside_view(p, frame, options);
}

bool counts(const TruthObject& object, const ScoredFrame& frame, const EvaluateOptions& options) {
  if (object.visible_points && *object.visible_points < options.min_visible_points) return false;
  return inside(object.position_m, frame, options);
}

/// Drops truth that is ignored, the tracks that follow it, and other tracks outside the region.
void drop_ignored(ScoredFrame& frame, const EvaluateOptions& options) {
  Eigen::MatrixXd cost = centre_distances(frame.truth, frame.tracks);
  cost = (cost.array() <= options.match_m).select(cost, kNever);
  std::vector<int> truth_of_track(frame.tracks.size(), -1);
  const auto pairs = solve_assignment(cost);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (pairs[i] >= 0) truth_of_track[pairs[i]] = static_cast<int>(i);
  }
  std::vector<Track> kept;
  for (std::size_t j = 0; j < frame.tracks.size(); ++j) {
    const int i = truth_of_track[j];
    const bool keep = i >= 0 ? counts(frame.truth[i], frame, options)
                             : inside(frame.tracks[j].box.centre_m, frame, options);
    if (keep) kept.push_back(std::move(frame.tracks[j]));
  }
  frame.tracks = std::move(kept);
  std::erase_if(frame.truth,
                [&](const TruthObject& object) { return !counts(object, frame, options); });
}

/// `anchor` is the truth frame whose coordinate frame is used (its own, or the sequence's first).
ScoredFrame scored_frame(const StepResult* step, const TruthFrame* truth,
                         const TruthFrame* anchor) {
  ScoredFrame frame;
  frame.stamp = step != nullptr ? step->stamp : truth->stamp;
  frame.frame = step != nullptr ? step->frame : truth->frame;
  if (truth != nullptr) frame.truth = truth->objects;
  if (step == nullptr) return frame;
  const Pose2 to_from = anchor == nullptr ? Pose2{} : truth_from_output(*step, *anchor);
  if (anchor == nullptr || anchor->coordinate_frame != "ego") {
    const Pose2 ego = step->world_from_ego.planar();
    frame.viewer_m = {ego.x_m, ego.y_m};
    frame.viewer_heading_rad = ego.heading_rad;
  }
  for (const Track& track : step->tracks) {
    if (track.status != TrackStatus::kTentative) frame.tracks.push_back(moved(track, to_from));
  }
  return frame;
}

std::vector<std::int64_t> sorted_unique(std::vector<std::int64_t> ids) {
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  return ids;
}

int index_in(const std::vector<std::int64_t>& ids, std::int64_t id) {
  return static_cast<int>(std::lower_bound(ids.begin(), ids.end(), id) - ids.begin());
}

void number_densely(Sequence& sequence) {
  for (const auto& frame : sequence.frames) {
    for (const auto& object : frame.truth) sequence.truth_ids.push_back(object.id);
    for (const auto& track : frame.tracks) sequence.track_ids.push_back(track.id);
  }
  sequence.truth_ids = sorted_unique(std::move(sequence.truth_ids));
  sequence.track_ids = sorted_unique(std::move(sequence.track_ids));
  for (auto& frame : sequence.frames) {
    for (const auto& object : frame.truth) {
      frame.truth_index.push_back(index_in(sequence.truth_ids, object.id));
    }
    for (const auto& track : frame.tracks) {
      frame.track_index.push_back(index_in(sequence.track_ids, track.id));
    }
  }
}

}  // namespace

Pose2 truth_from_output(const StepResult& step, const TruthFrame& truth) {
  if (truth.coordinate_frame == step.coordinate_frame) return {};
  const Pose2 world_from_ego = step.world_from_ego.planar();
  return truth.coordinate_frame == "ego" ? world_from_ego.inverse() : world_from_ego;
}

Track moved(const Track& track, const Pose2& to_from) {
  if (to_from.x_m == 0 && to_from.y_m == 0 && to_from.heading_rad == 0) return track;
  Track out = track;
  out.box.centre_m = to_from * track.box.centre_m;
  out.box.heading_rad = wrap_pi(track.box.heading_rad + to_from.heading_rad);
  const double c = std::cos(to_from.heading_rad), s = std::sin(to_from.heading_rad);
  Eigen::Matrix4d turn;  // of the state x, vx, y, vy
  turn << c, 0, -s, 0, 0, c, 0, -s, s, 0, c, 0, 0, s, 0, c;
  out.state.mean = turn * track.state.mean;
  out.state.mean[0] += to_from.x_m;
  out.state.mean[2] += to_from.y_m;
  out.state.covariance = turn * track.state.covariance * turn.transpose();
  return out;
}

Sequence make_sequence(std::span<const StepResult> steps, std::span<const TruthFrame> truth,
                       const EvaluateOptions& options) {
  const auto [step_of_truth, by_frame] = align_in_time(steps, truth);
  const TruthFrame* first = truth.empty() ? nullptr : truth.data();
  std::vector<char> seen(steps.size(), 0);
  Sequence sequence;
  for (std::size_t k = 0; k < truth.size(); ++k) {
    const int i = step_of_truth[k];
    if (i >= 0) seen[i] = 1;
    sequence.frames.push_back(scored_frame(i < 0 ? nullptr : &steps[i], &truth[k], &truth[k]));
  }
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (seen[i] != 0 || options.unlisted_frames == UnlistedFrames::kSkip) continue;
    sequence.frames.push_back(scored_frame(&steps[i], nullptr, first));
  }
  const auto key = [numbered = by_frame](const ScoredFrame& f) {
    return std::pair(numbered ? f.frame : 0, f.stamp);
  };
  std::stable_sort(sequence.frames.begin(), sequence.frames.end(),
                   [&](const auto& a, const auto& b) { return key(a) < key(b); });
  for (auto& frame : sequence.frames) {
    drop_ignored(frame, options);
    frame.distance_m = centre_distances(frame.truth, frame.tracks);
  }
  number_densely(sequence);
  return sequence;
}

}  // namespace scanfuse::evaluate
