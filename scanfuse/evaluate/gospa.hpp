#pragma once

#include <optional>

#include "scanfuse/evaluate/sequence.hpp"

namespace scanfuse::evaluate {

/// GOSPA of one frame and its parts. `total_m` is (localisation + missed + false_tracks)^(1/p); the
/// parts are in m^p.
struct Gospa {
  double total_m = 0;
  double localisation = 0;
  double missed = 0;        ///< c^p / alpha each
  double false_tracks = 0;  ///< c^p / alpha each
};

/// From the distances of a truth x tracks matrix [Rahmathullah2017, def. 1]:
///
///   gospa^p = min over assignments of sum min(d, c)^p + c^p / alpha (cardinality difference)
///
/// For alpha = 2 a pair at c or more counts as one miss and one false track [Rahmathullah2017,
/// prop. 1]; for other alpha it stays in the localisation part. Two empty sets are 0 apart.
[[nodiscard]] Gospa gospa(const Eigen::MatrixXd& distance_m, const EvaluateOptions& options);

/// OSPA of one frame [Schuhmacher2008]: the p-th power mean over the larger set, cut off at c.
[[nodiscard]] double ospa_m(const Eigen::MatrixXd& distance_m, const EvaluateOptions& options);

/// Means over frames; none without frames.
struct SetMetrics {
  std::optional<double> gospa_m;
  std::optional<double> localisation;
  std::optional<double> missed;
  std::optional<double> false_tracks;
  std::optional<double> ospa_m;
  std::optional<double> ospa2_m;
};

/// OSPA(2) [Beard2017] at each frame compares whole tracks over the latest `ospa2_window_frames`
/// frames: two tracks are as far apart as the mean over the frames where either exists of min(c,
/// d), c where only one does; on these distances OSPA with the same c and p. Mean over frames.
[[nodiscard]] SetMetrics set_metrics(const Sequence& sequence, const EvaluateOptions& options);

}  // namespace scanfuse::evaluate
