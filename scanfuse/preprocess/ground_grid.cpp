#include "scanfuse/preprocess/ground_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "scanfuse/geometry/angles.hpp"

namespace scanfuse::preprocess {
namespace {

constexpr std::size_t kSectors = 180;
constexpr float kGroundReach = 120;   // m; beyond, the last ring's height holds
constexpr float kPlacesPerMetre = 2;  // of the ring table
constexpr float kStep = 0.12F;        // m the ground may jump at once (curbs)
constexpr float kBend = 0.06F;        // change of slope that is followed
constexpr float kSlopeLimit = 0.2F;
constexpr float kStandOut = 0.15F;  // m from the sectors beside

}  // namespace

GroundGrid::GroundGrid() {
  float inner = 0;
  std::vector<float> edges;
  while (inner < kGroundReach) {
    const float size = std::max(1.0F, 0.08F * inner);
    middles_.push_back(inner + size / 2);
    inner += size;
    edges.push_back(inner);
  }
  std::size_t at = 0;
  for (float range = 0; range < inner; range += 1 / kPlacesPerMetre) {
    while (at + 1 < edges.size() && range >= edges[at]) ++at;
    rings_.push_back(static_cast<std::uint8_t>(at));
  }
  heights_.assign(kSectors * middles_.size(), 0);
  raw_ = heights_;
}

std::size_t GroundGrid::ring(float range_m) const {
  const auto place = static_cast<std::size_t>(range_m * kPlacesPerMetre);
  return rings_[std::min(place, rings_.size() - 1)];
}

std::size_t GroundGrid::sector(float bearing_rad) {
  const auto turn = (bearing_rad + static_cast<float>(kPi)) / static_cast<float>(2 * kPi);
  const auto index = static_cast<std::int32_t>(turn * kSectors);
  return static_cast<std::size_t>(std::clamp(index, 0, static_cast<std::int32_t>(kSectors) - 1));
}

void GroundGrid::estimate(std::span<const LevelPoint> points,
                          std::optional<double> sensor_height_m) {
  collect(points);
  const float start = start_height(sensor_height_m);
  for (std::size_t s = 0; s < kSectors; ++s) grow(s, start);
  smooth();
}

void GroundGrid::collect(std::span<const LevelPoint> points) {
  cells_.assign(kSectors * middles_.size(), Cell{});
  for (const LevelPoint& p : points) {
    if (p.range_m >= kGroundReach) continue;
    Cell& cell = cells_[sector(p.bearing_rad) * middles_.size() + ring(p.range_m)];
    if (!cell.seen || p.z_m < cell.low_m) cell = {p.z_m, p.range_m, true};
  }
}

float GroundGrid::start_height(std::optional<double> sensor_height_m) {
  scratch_.clear();
  for (const Cell& cell : cells_) {
    if (cell.seen && cell.range_m > 3 && cell.range_m < 20) scratch_.push_back(cell.low_m);
  }
  const float told = sensor_height_m ? static_cast<float>(-*sensor_height_m) : 0;
  if (scratch_.empty()) return told;
  const auto middle = scratch_.begin() + static_cast<std::ptrdiff_t>(scratch_.size() / 2);
  std::nth_element(scratch_.begin(), middle, scratch_.end());
  return sensor_height_m && std::abs(*middle - told) > 0.5F ? told : *middle;
}

void GroundGrid::grow(std::size_t s, float start_m) {
  const std::size_t first = s * middles_.size();
  float height = start_m, range = 0, slope = 0;
  std::size_t next = 0;  // first ring without a height yet
  for (std::size_t k = 0; k < middles_.size(); ++k) {
    const Cell& cell = cells_[first + k];
    if (!cell.seen) continue;
    const float run = std::max(cell.range_m - range, 0.5F);
    const float expected = height + slope * run;
    if (std::abs(cell.low_m - expected) > kStep + kBend * std::min(run, 10.0F)) continue;
    const float rise = range > 0 ? (cell.low_m - height) / run : 0;
    for (; next <= k; ++next) {
      const float share = std::clamp((middles_[next] - range) / run, 0.0F, 1.0F);
      raw_[first + next] = height + share * (cell.low_m - height);
    }
    slope = std::clamp(0.7F * slope + 0.3F * rise, -kSlopeLimit, kSlopeLimit);
    height = cell.low_m;
    range = cell.range_m;
  }
  for (; next < middles_.size(); ++next) raw_[first + next] = height;
}

void GroundGrid::smooth() {
  constexpr std::size_t kBeside = 2;
  for (std::size_t s = 0; s < kSectors; ++s) {
    for (std::size_t k = 0; k < middles_.size(); ++k) {
      std::array<float, 2 * kBeside + 1> around;
      for (std::size_t i = 0; i < around.size(); ++i) {
        around[i] = raw_[(s + kSectors + i - kBeside) % kSectors * middles_.size() + k];
      }
      std::ranges::nth_element(around, around.begin() + kBeside);
      const float own = raw_[s * middles_.size() + k];
      const bool stands_out = std::abs(own - around[kBeside]) > kStandOut;
      heights_[s * middles_.size() + k] = stands_out ? around[kBeside] : own;
    }
  }
}

float GroundGrid::height_m(float range_m, float bearing_rad) const {
  const float* row = heights_.data() + sector(bearing_rad) * middles_.size();
  const std::size_t k = ring(range_m);
  const std::size_t other =
      range_m < middles_[k] ? (k == 0 ? 0 : k - 1) : std::min(k + 1, middles_.size() - 1);
  if (other == k) return row[k];
  const float share = (range_m - middles_[k]) / (middles_[other] - middles_[k]);
  return row[k] + std::min(share, 1.0F) * (row[other] - row[k]);
}

}  // namespace scanfuse::preprocess
