#pragma once

#include "scanfuse/core/random.hpp"
#include "scanfuse/types/scan.hpp"

namespace scanfuse::pipeline {

/// Makes a recording look as if another sensor had made it, so that classes are not learned by
/// heart for those that were recorded or simulated. What is done is drawn once, at the start, so
/// that a recording is one sensor's from end to end: nothing at all for one in three, else each
/// of: fewer layers, every second column, returns lost at random, more noise along the ray.
class ScanVariation {
 public:
  explicit ScanVariation(std::uint64_t seed);

  void operator()(Scan& scan);

 private:
  void leave_out_layers(Scan& scan) const;
  void leave_out_columns(Scan& scan) const;

  RandomStream random_;
  int layer_step_ = 1;   ///< every so many layers stay; where there are at least twice as many
  int column_step_ = 1;  ///< likewise of the columns
  double dropout_ = 0;
  double noise_m_ = 0;  ///< standard deviation
};

}  // namespace scanfuse::pipeline
