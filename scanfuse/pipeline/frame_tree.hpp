#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scanfuse/pipeline/pose_buffer.hpp"
#include "scanfuse/types/ego.hpp"

namespace scanfuse::pipeline {

/// The tf tree of a recording: each frame hangs on one parent, at a pose that may change with time.
class FrameTree {
 public:
  void add(const TransformSample& sample);
  [[nodiscard]] bool empty() const { return edges_.empty(); }
  /// `frame`, its parent, and so on up to the root; only `frame` when it is not in the tree.
  /// A loop (broken data) is cut where it closes.
  [[nodiscard]] std::vector<std::string> ancestry(const std::string& frame) const;
  /// ancestor_from_frame at `stamp`; nothing when they are not connected.
  [[nodiscard]] std::optional<PoseBuffer::Found> lookup(const std::string& ancestor,
                                                        const std::string& frame, Time stamp) const;
  /// True when every moving edge between the two has a sample at or after `stamp`.
  [[nodiscard]] bool covers(const std::string& ancestor, const std::string& frame,
                            Time stamp) const;
  /// True when an edge between the two moves.
  [[nodiscard]] bool moves(const std::string& ancestor, const std::string& frame) const;
  void forget_before(Time stamp);

 private:
  struct Edge {
    std::string parent;
    PoseBuffer poses;
    bool is_static = false;
  };
  [[nodiscard]] std::vector<const Edge*> path(const std::string& ancestor,
                                              const std::string& frame) const;

  std::map<std::string, Edge> edges_;  ///< by child
};

/// Frame names lose a leading slash: tf of ROS 1 wrote them with one.
[[nodiscard]] std::string plain_frame(const std::string& name);

}  // namespace scanfuse::pipeline
