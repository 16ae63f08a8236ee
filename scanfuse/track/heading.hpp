#pragma once

#include "scanfuse/track/measure.hpp"

namespace scanfuse::track {

/// Direction of motion and its variance; how far it can be trusted follows from speed over its
/// deviation.
struct Course {
  double direction_rad = 0;
  double variance_rad2 = 0;
  double speed_m_per_s = 0;
  bool reliable = false;  ///< the object does move, not only its estimate
};

[[nodiscard]] Course course_of(const Gaussian<kStates>& state);

/// Whether its heading is where it goes, since its box tells none: pedestrians and what is unknown.
[[nodiscard]] bool follows_its_course(const Target& target);

/// Turns the belief on by its yaw rate. An object at rest is believed to keep its heading.
void predict_heading(Target& target, double dt_s);

/// Folds in the heading of a detected box, already turned to the nearest of two or four.
void update_heading(Target& target, const Measurement& measurement);

/// Lets motion speak: settles the sign by the way gone, draws the heading to the course. True when
/// it was turned by a quarter because the object surely moves across it: then the single face that
/// was taken for the rear is the side, or the other way round, and the extent has to be read anew.
bool align_heading_with_course(Target& target, double dt_s);

}  // namespace scanfuse::track
