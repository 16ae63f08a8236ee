#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "scanfuse/types/track.hpp"
#include "scanfuse/types/truth.hpp"

namespace scanfuse::evaluate {

/// How often what is said with a probability is right.
struct Reliability {
  static constexpr int kBins = 10;
  std::array<double, kBins> said{};   ///< sums of the probability
  std::array<double, kBins> right{};  ///< how many were right
  std::array<double, kBins> count{};

  void add(double probability, bool is_right);
  void merge(const Reliability& other);
  /// Mean of |right - said| over all, by bins of equal width [Guo2017]; none without any.
  [[nodiscard]] std::optional<double> expected_calibration_error() const;
};

/// How well tracks are told apart by class, against range from the sensor.
///
/// - Recall: of the objects that showed at least 3 returns in 4 of 5 scans of the last second, the
///   share that a confirmed track of their class follows now. Misses count.
/// - Recall of those followed: of these objects only those that a track a second old or older
///   follows, tentative or confirmed, right class or not.
/// - Precision: of the confirmed tracks a second old or older said to be of a class, the share that
///   follows an object of it.
/// - Clutter: confirmed tracks said to be a road user that follow no object at all, per scan.
/// - Confusion and reliability: of all tracks a second old or older, tentative ones included; what
///   follows no object is `other`.
/// A track follows an object when its centre is within 1 m of the object's box or 2 m of its
/// centre; one to one, the nearest first.
class ClassScore {
 public:
  static constexpr double kBin_m = 5;
  static constexpr std::array kRanges_m{20.0, 40.0, 50.0};  ///< what tables tell: up to there
  static constexpr int kRangeBins = 12;                     ///< to 60 m

  struct Counts {
    std::array<std::int64_t, kRangeBins> objects{}, found{}, said{}, right{};
    /// Why objects were not found: no track at all, one that is tentative, one of another class.
    std::array<std::int64_t, kRangeBins> untracked{}, tentative{}, misnamed{};
    /// Of the objects, those that a track a second old or older follows, and of these the found.
    std::array<std::int64_t, kRangeBins> followed{}, named{};
  };

  /// Scans of one recording in order; a new one begins with `start_recording`.
  void add(const StepResult& step, const TruthFrame& truth);
  void start_recording();
  void merge(const ClassScore& other);

  /// Up to a range; none without any.
  [[nodiscard]] std::optional<double> precision(ObjectClass kind, double range_m) const;
  [[nodiscard]] std::optional<double> recall(ObjectClass kind, double range_m) const;
  [[nodiscard]] std::optional<double> recall_of_followed(ObjectClass kind, double range_m) const;
  [[nodiscard]] std::optional<double> clutter_per_scan() const;
  /// The same of tracks a second old or older.
  [[nodiscard]] std::optional<double> old_clutter_per_scan() const;
  /// Of these, second tracks: near an object that another track follows.
  [[nodiscard]] std::optional<double> old_seconds_per_scan() const;
  [[nodiscard]] const Counts& counts(ObjectClass kind) const {
    return counts_[static_cast<std::size_t>(kind)];
  }
  /// [truth][said]
  [[nodiscard]] const std::array<std::array<std::int64_t, kObjectClasses>, kObjectClasses>&
  confusion() const {
    return confusion_;
  }
  [[nodiscard]] const Reliability& reliability() const { return reliability_; }
  [[nodiscard]] std::int64_t scans() const { return scans_; }

 private:
  struct Watch {
    Time since;
    std::deque<std::pair<Time, bool>> seen;  ///< of the last second
  };
  void count_objects(const StepResult& step, const TruthFrame& truth,
                     std::span<const int> track_of_object);
  void count_tracks(const StepResult& step, const TruthFrame& truth,
                    std::span<const int> object_of_track);

  std::array<Counts, kObjectClasses> counts_{};
  std::array<std::array<std::int64_t, kObjectClasses>, kObjectClasses> confusion_{};
  Reliability reliability_;
  std::int64_t scans_ = 0;
  std::int64_t clutter_ = 0;
  std::int64_t old_clutter_ = 0;
  std::int64_t old_seconds_ = 0;
  std::map<std::int64_t, Watch> objects_;
  std::map<std::int64_t, Time> born_;
};

}  // namespace scanfuse::evaluate
