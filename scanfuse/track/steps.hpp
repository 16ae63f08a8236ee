#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "scanfuse/associate/associate.hpp"
#include "scanfuse/associate/position_grid.hpp"
#include "scanfuse/track/measure.hpp"

/// One scan of the tracker is these functions in this order: predict, gated candidates,
/// (associate), update and miss, birth, death.
namespace scanfuse::track {

/// Memory of the steps that is kept from scan to scan: grown once, nothing is allocated.
struct Workspace {
  associate::PositionGrid grid{1};
  std::vector<associate::Candidate> candidates;
  std::vector<char> superfluous;
  std::vector<Gaussian<kStates>> mixed;
};

/// Moves every target on by dt_s >= 0: constant velocity with white acceleration.
void predict(std::vector<Target>& targets, double dt_s, const TrackerOptions& options);

/// The pairs inside the gate. Cost with the Mahalanobis distance m^2: m^2 + ln det S, the part of
/// -2 ln N(z; H x, S) that differs between pairs; without ln det S a vague track takes everything
/// around it. With the euclidean distance, the distance in metres [Lu2018, eq. 5]. The result
/// stands in `workspace`.
[[nodiscard]] std::span<const associate::Candidate> gated_candidates(
    std::span<const Target> targets, std::span<const Detection> detections,
    const TrackerOptions& options, Workspace& workspace);

/// The same of one pair; nothing outside the gate.
[[nodiscard]] std::optional<double> pair_cost(const Target& target, const Detection& detection,
                                              const TrackerOptions& options);

/// Learned classes waver between small ones from scan to scan; only a vehicle is another thing.
[[nodiscard]] bool are_alike(const Target& target, const Detection& detection);

/// The cost from which a pair is not made, for the distance in use.
[[nodiscard]] double unassigned_cost(const TrackerOptions& options);

/// What each target is believed to be when every detection in its gate may be its own, with the
/// probabilities b of `shares` (b_0: none is), x_d the belief after the update by detection d:
///
///   x = sum b_d x_d + b_0 x-      P = sum b_d (P_d + (x_d - x)(x_d - x)') + b_0 (...)
///
/// the mixture of [Fortmann1983] with the spread of its means. The result stands in `workspace`.
[[nodiscard]] std::span<const Gaussian<kStates>> mixed_states(
    std::span<const Target> targets, std::span<const Detection> detections,
    std::span<const associate::Candidate> candidates, const associate::Marginals& shares,
    const TrackerOptions& options, Workspace& workspace);

/// Folds into a target what the likeliest detection says of all but the state, which is `mixed`.
void update_mixed(Target& target, const Gaussian<kStates>& mixed, const Detection& detection,
                  int index, Time stamp, double dt_s, const TrackerOptions& options);

/// Folds the assigned detection into a target.
void update(Target& target, const Detection& detection, int index, Time stamp, double dt_s,
            const TrackerOptions& options);

/// A scan went by without the target, `dt_s` after the last one. Was it hidden, that is no evidence
/// of its absence: it does not use up the time unseen that the target has earned.
void miss(Target& target, double dt_s, bool is_hidden);

/// Tentative until `confirm_hits` of the last `confirm_window` scans hit it.
void promote(Target& target, const TrackerOptions& options);

/// A target from one detection.
[[nodiscard]] Target birth(const Detection& detection, int index, std::int64_t id, Time stamp,
                           double dt_s, const TrackerOptions& options);

/// Reads the extent and the place of the centre anew from a detection, after the heading was turned
/// by a quarter; velocity stays.
void reseat(Target& target, const Detection& detection, const TrackerOptions& options);

/// Whether a detection belongs to a confirmed target that already took another one: a part of it.
[[nodiscard]] bool is_part_of(const Detection& detection, std::span<const Target> targets);

/// Whether its place is known no better than `coast_sigma_m`.
[[nodiscard]] bool is_vague(const Target& target, const TrackerOptions& options);

/// Whether a target is given up: tentative and no longer able to be confirmed, or unseen too long.
/// A confirmed target earns its time unseen by having been seen; time hidden is free.
[[nodiscard]] bool is_over(const Target& target, Time stamp, const TrackerOptions& options);

/// Removes the younger of two targets that lie in one another and move alike.
void merge_duplicates(std::vector<Target>& targets, Workspace& workspace);

}  // namespace scanfuse::track
