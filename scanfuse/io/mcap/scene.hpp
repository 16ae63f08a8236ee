#pragma once

#include <deque>
#include <map>
#include <string>

#include "scanfuse/types/track.hpp"

namespace scanfuse::io::mcap {

/// Turns the tracks of each step into a foxglove.SceneUpdate in JSON: a box coloured by class
/// (paler while tentative or coasting), a label, and the trail of the last positions. A track that
/// is gone is deleted.
class SceneBuilder {
 public:
  explicit SceneBuilder(std::string frame_id) : frame_id_(std::move(frame_id)) {}
  [[nodiscard]] std::string update(const StepResult& step);

 private:
  static constexpr std::size_t kTrailPoints = 100;
  std::string frame_id_;
  std::map<std::int64_t, std::deque<Eigen::Vector3d>> trails_;  ///< of the tracks now shown
};

}  // namespace scanfuse::io::mcap
