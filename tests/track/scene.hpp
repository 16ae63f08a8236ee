#pragma once

#include <Eigen/Core>
#include <map>
#include <vector>

#include "scanfuse/simulate/set_pieces.hpp"
#include "scanfuse/track/tracker.hpp"

/// A world of detections without a lidar: what the tracker alone is tested on.
namespace scanfuse::track::testing {

using simulate::box_detection;
using simulate::Mover;
using simulate::play;
using simulate::SceneFrame;
using simulate::SceneOptions;
using simulate::set_pieces;
using simulate::SetPiece;

/// Counts how often the confirmed track that covers a mover changes, as CLEAR-MOT does.
class IdentityCounter {
 public:
  explicit IdentityCounter(double match_m) : match_m_(match_m) {}

  void add(const std::vector<Eigen::Vector4d>& truth, const std::vector<Track>& tracks) {
    identity_.resize(truth.size(), 0);
    std::vector<char> taken(tracks.size(), 0);
    std::vector<int> match(truth.size(), -1);
    for (int round = 0; round < 2; ++round) {  // first those that keep their track
      for (std::size_t i = 0; i < truth.size(); ++i) {
        if (match[i] < 0) match[i] = find(truth[i], round == 0 ? identity_[i] : 0, tracks, taken);
      }
    }
    for (std::size_t i = 0; i < truth.size(); ++i) {
      ++frames_;
      if (match[i] < 0) continue;
      ++covered_;
      const std::int64_t id = tracks[match[i]].id;
      if (identity_[i] != 0 && identity_[i] != id) ++changes_;
      identity_[i] = id;
    }
  }
  [[nodiscard]] int changes() const { return changes_; }
  [[nodiscard]] double coverage() const { return double(covered_) / frames_; }
  [[nodiscard]] const std::vector<std::int64_t>& identity() const { return identity_; }

 private:
  int find(const Eigen::Vector4d& truth, std::int64_t wanted, const std::vector<Track>& tracks,
           std::vector<char>& taken) const {
    int best = -1;
    double nearest = match_m_;
    for (std::size_t t = 0; t < tracks.size(); ++t) {
      if (taken[t] || tracks[t].status == TrackStatus::kTentative) continue;
      if (wanted != 0 && tracks[t].id != wanted) continue;
      const double apart = (tracks[t].box.centre_m - Eigen::Vector2d(truth(0), truth(2))).norm();
      if (apart < nearest) {
        nearest = apart;
        best = static_cast<int>(t);
      }
    }
    // Identity 0 means none yet: the first round has nothing to keep then.
    if (best >= 0) taken[best] = 1;
    return best;
  }

  double match_m_;
  std::vector<std::int64_t> identity_;
  int changes_ = 0;
  std::int64_t frames_ = 0;
  std::int64_t covered_ = 0;
};

}  // namespace scanfuse::track::testing
