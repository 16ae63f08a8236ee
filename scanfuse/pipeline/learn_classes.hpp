#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "scanfuse/pipeline/classes.hpp"
#include "scanfuse/types/truth.hpp"

namespace scanfuse::pipeline {

/// The row of the learned class of each outline of the last step: the object whose box holds at
/// least half of its points (moved on to when its beams were fired, 0.25 m about; where truth tells
/// no size, points near its centre), `other` where boxes hold less than a tenth, else none: mixed,
/// or of a class that is not learned.
[[nodiscard]] std::vector<std::optional<int>> label_outlines(const Perception& perception,
                                                             const PosedScan& posed,
                                                             const TruthFrame& truth);

/// One labelled outline.
struct OutlineSample {
  classify::Features features{};
  int label = 0;
  float share = 1;  ///< less for sensors that look more than ten times a second
  int lines = 0;
  double l1_m = 0, l2_m = 0, var_r_m2 = 0;  ///< of [Guo], l1 >= l2
  std::optional<ObjectClass> by_intervals;  ///< by the intervals of the chain's model
};

/// One track at one scan that saw it.
struct TrackSample {
  track::BeliefTerms terms;
  int label = 0;
  float share = 1;
};

/// The chain that samples are drawn with: of `road-users`, by rules where `classes` is null, with
/// tracks that sum scores where the belief is not learned yet (all weights zero).
[[nodiscard]] PerceptionOptions learning_chain(const std::shared_ptr<const Classes>& classes);

/// Draws samples from one recording, scan after scan.
class SampleCollector {
 public:
  explicit SampleCollector(const std::shared_ptr<const Classes>& classes);

  /// `keep` false: the scan moves the tracks on, its samples are left out.
  void add(const PosedScan& posed, const TruthFrame& truth, bool keep);

  std::vector<OutlineSample> outlines;
  std::vector<TrackSample> tracks;  ///< none without classes

  [[nodiscard]] const Perception& perception() const { return perception_; }
  [[nodiscard]] const StepResult& last() const { return *last_; }

 private:
  void take_tracks(std::span<const std::optional<int>> labels, float share, bool keep);

  std::shared_ptr<const Classes> classes_;
  Perception perception_;
  const StepResult* last_ = nullptr;
  std::optional<Time> before_;
  std::map<std::int64_t, track::ClassBelief> beliefs_;
};

/// Intervals and softmax weights from labelled outlines. Intervals are the 2 % and 98 % quantiles.
[[nodiscard]] classify::ClassModel fit_recognizer(std::span<const OutlineSample> samples);

/// The temperature, from outlines that served no fit.
[[nodiscard]] double fit_recognizer_temperature(const classify::SoftmaxModel& model,
                                                std::span<const OutlineSample> samples);

/// The weights of the belief, from tracks by a recogniser that was not fitted to them.
[[nodiscard]] Eigen::MatrixXd fit_belief(std::span<const TrackSample> samples);

}  // namespace scanfuse::pipeline
