#include "scanfuse/pipeline/scan_variation.hpp"

#include <algorithm>
#include <cmath>

namespace scanfuse::pipeline {
namespace {

constexpr double kUnchanged = 1.0 / 3;
constexpr double kMostDropout = 0.2;
constexpr double kMostNoise_m = 0.03;

}  // namespace

ScanVariation::ScanVariation(std::uint64_t seed) : random_(seed) {
  if (random_.chance(kUnchanged)) return;
  if (random_.chance(0.5)) layer_step_ = 2 + static_cast<int>(random_.below(3));
  if (random_.chance(0.3)) column_step_ = 2;
  if (random_.chance(0.5)) dropout_ = random_.uniform(0, kMostDropout);
  if (random_.chance(0.5)) noise_m_ = random_.uniform(0, kMostNoise_m);
}

void ScanVariation::leave_out_layers(Scan& scan) const {
  int layers = scan.beams ? scan.beams->layers : 1;
  for (const Return& r : scan.returns) layers = std::max(layers, r.layer + 1);
  if (layers < 2 * layer_step_) return;
  std::erase_if(scan.returns, [&](const Return& r) { return r.layer % layer_step_ != 0; });
  for (Return& r : scan.returns) r.layer = static_cast<std::int16_t>(r.layer / layer_step_);
  if (scan.beams) scan.beams->layers = (layers + layer_step_ - 1) / layer_step_;
}

void ScanVariation::leave_out_columns(Scan& scan) const {
  if (!scan.beams || scan.beams->columns < 2 * column_step_) return;
  std::erase_if(scan.returns, [&](const Return& r) { return r.beam % column_step_ != 0; });
  for (Return& r : scan.returns) r.beam /= column_step_;
  scan.beams->columns = (scan.beams->columns + column_step_ - 1) / column_step_;
  scan.beams->step_rad *= column_step_;
}

void ScanVariation::operator()(Scan& scan) {
  if (layer_step_ > 1) leave_out_layers(scan);
  if (column_step_ > 1) leave_out_columns(scan);
  if (dropout_ > 0) {
    std::erase_if(scan.returns, [&](const Return&) { return random_.chance(dropout_); });
  }
  if (noise_m_ <= 0) return;
  for (Return& r : scan.returns) {
    const double range = std::sqrt(r.x_m * r.x_m + r.y_m * r.y_m + r.z_m * r.z_m);
    const auto factor = static_cast<float>(1 + random_.normal(0, noise_m_) / std::max(range, 0.5));
    r.x_m *= factor;
    r.y_m *= factor;
    r.z_m *= factor;
  }
}

}  // namespace scanfuse::pipeline
