#pragma once

#include <algorithm>
#include <vector>

namespace scanfuse::calibrate {

/// The middle of the values (the upper one of two); 0 of none.
[[nodiscard]] inline double middle_of(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace scanfuse::calibrate
