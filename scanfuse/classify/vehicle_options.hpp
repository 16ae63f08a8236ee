#pragma once

#include <array>
#include <memory>
#include <string>
#include <tuple>
#include <utility>

#include "scanfuse/core/options.hpp"

namespace scanfuse::classify {

enum class Method { kScore, kLu2018, kSoftmax, kGuoIntervals };

constexpr auto choices(Method) {
  using enum Method;
  return std::array{std::pair{"score", kScore}, std::pair{"lu2018", kLu2018},
                    std::pair{"softmax", kSoftmax}, std::pair{"guo_intervals", kGuoIntervals}};
}

/// Which clusters become detections.
enum class Keep { kVehicles, kRoadUsers };

constexpr auto choices(Keep) {
  return std::array{std::pair{"vehicles", Keep::kVehicles},
                    std::pair{"road_users", Keep::kRoadUsers}};
}

struct ClassModel;

/// What a vehicle is taken to look like. Defaults: passenger cars and vans.
struct RecognizerOptions {
  Method method = Method::kScore;
  Keep keep = Keep::kVehicles;
  double min_score = 0.5;
  int min_points = 3;
  double min_width_m = 1.4;
  double max_width_m = 2.4;
  double min_length_m = 2.6;
  double max_length_m = 6.5;
  double min_cut_m = 1.1;
  double both_cut_score = 0.7;
  double size_slack_m = 0.4;
  double mean_length_m = 4.4;
  double sigma_length_m = 0.4;
  double mean_width_m = 1.8;
  double sigma_width_m = 0.12;
  double max_end_sigma_m = 0.15;
  double min_inlier_share = 0.85;
  double min_expected_inlier_share = 0.85;
  double min_coverage = 0.85;
  double right_angle_tolerance_rad = 0.35;
  double min_user_m = 0.15;
  double max_other_probability = 0.999;
  std::string classes_file;
  /// What softmax and guo_intervals have learned; without it these two take the rules of `score`.
  /// The pipeline puts in what comes with the library, or what `classes_file` holds.
  std::shared_ptr<const ClassModel> model;

  static constexpr auto fields() {
    using O = RecognizerOptions;
    return std::tuple{
        Field{"method", &O::method,
              "scored rules for vehicles, the plain ones of [Lu2018], or learned: softmax, or the "
              "intervals of [Guo]"},
        Field{"keep", &O::keep,
              "vehicles only, or smaller objects too (unknown, where the method only knows "
              "vehicles)"},
        Field{"min_score", &O::min_score, 0.0, 1.0, "less likely vehicles are dropped"},
        Field{"min_points", &O::min_points, 1, 1000, "clusters with fewer are dropped"},
        Field{"min_width_m", &O::min_width_m, 0.0, 100.0, "narrowest rear or front"},
        Field{"max_width_m", &O::max_width_m, 0.0, 100.0, "widest rear or front"},
        Field{"min_length_m", &O::min_length_m, 0.0, 100.0, "shortest side"},
        Field{"max_length_m", &O::max_length_m, 0.0, 100.0, "longest side"},
        Field{"min_cut_m", &O::min_cut_m, 0.0, 100.0, "shortest face of which an end is hidden"},
        Field{"both_cut_score", &O::both_cut_score, 0.0, 1.0,
              "score of a face of which both ends are hidden: walls look so"},
        Field{"size_slack_m", &O::size_slack_m, 0.001, 100.0,
              "the score falls to zero this far outside these bounds"},
        Field{"mean_length_m", &O::mean_length_m, 0.0, 100.0, "length where it is not seen"},
        Field{"sigma_length_m", &O::sigma_length_m, 0.0, 100.0, "its standard deviation"},
        Field{"mean_width_m", &O::mean_width_m, 0.0, 100.0, "width where it is not seen"},
        Field{"sigma_width_m", &O::sigma_width_m, 0.0, 100.0, "its standard deviation"},
        Field{"max_end_sigma_m", &O::max_end_sigma_m, 0.0, 100.0,
              "a side whose ends are less certain, seen at grazing incidence, is a lower bound"},
        Field{"min_inlier_share", &O::min_inlier_share, 0.0, 1.0,
              "of the points on straight faces: bushes have less"},
        Field{"min_expected_inlier_share", &O::min_expected_inlier_share, 0.0, 1.0,
              "the same where a track expects a vehicle"},
        Field{"min_coverage", &O::min_coverage, 0.0, 1.0,
              "of the beams that must return: loose foliage has less"},
        Field{"right_angle_tolerance_rad", &O::right_angle_tolerance_rad, 0.0, 1.5,
              "between the two lines of a corner, for lu2018"},
        Field{"min_user_m", &O::min_user_m, 0.0, 100.0, "smaller objects are no road users"},
        Field{"max_other_probability", &O::max_other_probability, 0.0, 1.0,
              "what is more surely no road user is dropped (softmax)"},
        Field{"classes_file", &O::classes_file,
              "what `scanfuse learn classes` wrote; empty: what comes with scanfuse"},
    };
  }
};

}  // namespace scanfuse::classify
