#include "scanfuse/classify/vehicle_options.hpp"

namespace scanfuse::classify {

RecognizerOptions to_scale(RecognizerOptions options) {
  for (double* length : {&options.min_width_m, &options.max_width_m, &options.min_length_m,
                         &options.max_length_m, &options.min_cut_m, &options.size_slack_m,
                         &options.mean_length_m, &options.sigma_length_m, &options.mean_width_m,
                         &options.sigma_width_m, &options.max_end_sigma_m, &options.min_user_m}) {
    *length *= options.scale;
  }
  options.scale = 1;
  return options;
}

}  // namespace scanfuse::classify
