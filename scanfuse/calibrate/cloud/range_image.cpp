#include "scanfuse/calibrate/cloud/range_image.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scanfuse::calibrate {
namespace {

constexpr std::size_t kMostCells = std::size_t{1} << 28;

double median_of(std::vector<double>& values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

}  // namespace

double RangeImage::near(std::ptrdiff_t profile, std::ptrdiff_t beam) const {
  if (profile < 0 || beam < 0 || profile >= static_cast<std::ptrdiff_t>(profiles) ||
      beam >= static_cast<std::ptrdiff_t>(beams)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return at(static_cast<std::size_t>(profile), static_cast<std::size_t>(beam));
}

RangeRaster range_raster(std::span<const TurntablePosition> scans) {
  RangeRaster raster;
  RangeImage& image = raster.image;
  std::vector<double> steps;
  double first = std::numeric_limits<double>::infinity(), last = -first;
  for (const auto& position : scans) {
    for (std::size_t k = 0; k < position.scan.size(); ++k) {
      first = std::min(first, position.scan[k].angle_rad);
      last = std::max(last, position.scan[k].angle_rad);
      if (k == 0) continue;
      const double step = position.scan[k].angle_rad - position.scan[k - 1].angle_rad;
      if (step > 1e-7) steps.push_back(step);
    }
  }
  image.profiles = scans.size();
  image.step_rad = median_of(steps);
  raster.columns.resize(scans.size());
  if (!(image.step_rad > 0)) image.step_rad = 1e-3;
  if (!(last >= first)) return raster;
  image.first_angle_rad = first;
  image.beams = static_cast<std::size_t>(std::lround((last - first) / image.step_rad)) + 1;
  if (image.beams > kMostCells / std::max<std::size_t>(image.profiles, 1)) {
    image.step_rad = (last - first) * static_cast<double>(image.profiles) / kMostCells;
    image.beams = kMostCells / image.profiles;
  }
  image.range_m.assign(image.profiles * image.beams, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t p = 0; p < scans.size(); ++p) {
    int before = -1;
    for (const BeamReturn& beam : scans[p].scan) {
      const int column =
          std::clamp(static_cast<int>(std::lround((beam.angle_rad - first) / image.step_rad)), 0,
                     static_cast<int>(image.beams) - 1);
      raster.columns[p].push_back(column > before ? column : -1);
      if (column <= before) continue;
      before = column;
      image.range_m[p * image.beams + static_cast<std::size_t>(column)] = beam.range_m;
    }
  }
  return raster;
}

double range_noise(const RangeImage& image) {
  std::vector<double> bends;
  for (std::size_t p = 0; p < image.profiles; ++p) {
    for (std::size_t b = 1; b + 1 < image.beams; ++b) {
      const double bend = image.at(p, b - 1) - 2 * image.at(p, b) + image.at(p, b + 1);
      if (std::isfinite(bend)) bends.push_back(std::abs(bend));
    }
  }
  return 1.4826 * median_of(bends) / std::sqrt(6.0);
}

}  // namespace scanfuse::calibrate
