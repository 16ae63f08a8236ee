#pragma once

#include <optional>
#include <vector>

#include "scanfuse/track/options.hpp"
#include "scanfuse/track/target.hpp"

namespace scanfuse::track {

/// Targets that were given up, not reported any more, and moved on as they were last believed to
/// move: what appears where one of them should be is that one again, by its old identity.
class LostTargets {
 public:
  /// Remembers who has been confirmed and was believed to be a road user, and nothing else.
  void keep(const Target& target);
  /// Moves all on by dt_s and forgets those unseen for `lost_s`, or too vague to be told apart.
  void advance(Time stamp, double dt_s, const TrackerOptions& options);
  /// Takes out the target that the detection fits best. It is tentative as one just born, and its
  /// class must be trusted anew; what it knew of motion, size and class stays. Nothing where none
  /// is near enough or alike.
  [[nodiscard]] std::optional<Target> find(const Detection& detection,
                                           const TrackerOptions& options);
  void clear() { targets_.clear(); }

 private:
  std::vector<Target> targets_;
};

}  // namespace scanfuse::track
