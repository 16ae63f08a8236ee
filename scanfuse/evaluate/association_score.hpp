#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "scanfuse/types/bearing.hpp"

namespace scanfuse::evaluate {

/// The target (Bearing::truth) that all bearings of a fix are of; empty for a ghost: bearings of
/// more than one origin, or of false alarms.
[[nodiscard]] std::optional<std::int64_t> origin_of(const BearingScan& scan, const Fix& fix);

/// How well bearings were joined, against who made them (Bearing::truth). A target counts when two
/// sensors or more saw it: one direction is no place.
struct AssociationScore {
  std::int64_t scenes = 0;
  std::int64_t targets = 0;  ///< that count
  std::int64_t fixes = 0;
  std::int64_t exact = 0;   ///< fixes of all bearings of one target and no other
  std::int64_t ghosts = 0;  ///< fixes without an origin
  double squared_ospa = 0;  ///< sum over scenes

  AssociationScore& operator+=(const AssociationScore& other);
  [[nodiscard]] double exact_rate() const;  ///< of the targets
  [[nodiscard]] double f1() const;          ///< of exact fixes
  [[nodiscard]] double ghosts_per_scene() const;
  [[nodiscard]] double ospa_m() const;  ///< root of the mean square over scenes

  /// `cutoff_m` of OSPA, of order 2, between fixes and all targets, seen or not [Schuhmacher2008].
  void add(const BearingScan& scan, std::span<const Fix> fixes,
           std::span<const Eigen::Vector3d> targets_m, double cutoff_m = 1000);
};

}  // namespace scanfuse::evaluate
