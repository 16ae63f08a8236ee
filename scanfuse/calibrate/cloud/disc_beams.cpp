#include "scanfuse/calibrate/cloud/disc_beams.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace scanfuse::calibrate {
namespace {

constexpr double kOnSigmas = 4;
constexpr double kLeastTolerance_m = 5e-4;
/// Two neighbouring returns of the background differ by no more, in steps across the plane.
constexpr double kBackgroundSlope = 2;
constexpr int kMostMixedInRow = 6;
/// Beams between these shares of the reach show the background.
constexpr double kWellOutside = 0.9;
constexpr double kFurthestOut = 1.4;
constexpr double kMostlyFlat = 0.6;

/// Beams of the neighbourhood as a raster of their own.
struct Neighbourhood {
  int first_beam = 0;
  int width = 0;
  int profiles = 0;
  double tolerance_m = 0;  ///< a return further from the plane is not on the target
  struct Cell {
    Eigen::Vector2d place = Eigen::Vector2d::Zero();
    double off_m = std::numeric_limits<double>::quiet_NaN();  ///< behind the plane, along the ray
    bool meets = false;
    bool on = false;
  };
  std::vector<Cell> cells;

  [[nodiscard]] const Cell* at(int profile, int column) const {
    if (profile < 0 || column < 0 || profile >= profiles || column >= width) return nullptr;
    const Cell& cell = cells[static_cast<std::size_t>(profile) * static_cast<std::size_t>(width) +
                             static_cast<std::size_t>(column)];
    return cell.meets ? &cell : nullptr;
  }
};

Neighbourhood look_around(const BeamGrid& grid, const PlaneFit& plane,
                          const Eigen::Vector2d& around, double reach_m) {
  Neighbourhood near;
  near.profiles = grid.profiles();
  const Eigen::Vector3d middle = plane.raised(around);
  int first = std::numeric_limits<int>::max(), last = std::numeric_limits<int>::min();
  for (int p = 0; p < near.profiles; ++p) {
    const double distance = std::max((middle - grid.origin(p)).norm(), 1e-3);
    const auto [from, to] =
        grid.beams_around(p, middle, std::atan2(1.5 * reach_m, distance) + 3 * grid.step_rad());
    first = std::min(first, from);
    last = std::max(last, to);
  }
  if (first > last) return near;
  near.first_beam = first;
  near.width = last - first + 1;
  near.cells.resize(static_cast<std::size_t>(near.width) * static_cast<std::size_t>(near.profiles));
  near.tolerance_m = on_tolerance_m(plane);
  for (int p = 0; p < near.profiles; ++p) {
    for (int b = first; b <= last; ++b) {
      auto& cell = near.cells[static_cast<std::size_t>(p) * static_cast<std::size_t>(near.width) +
                              static_cast<std::size_t>(b - first)];
      const auto place = grid.meets(plane, p, b);
      if (!place) continue;
      cell.meets = true;
      cell.place = plane.flat(*place);
      if (const CloudPoint* point = grid.point(p, b)) {
        cell.off_m = (point->position_m - grid.origin(p)).norm() - (*place - grid.origin(p)).norm();
        cell.on = std::abs(cell.off_m) <= near.tolerance_m;
      }
    }
  }
  return near;
}

/// Where a beam stands in the neighbourhood.
struct Seat {
  int profile = 0;
  int column = 0;
};

/// The neighbour that lies furthest out from the middle.
std::optional<Seat> outward(const Neighbourhood& near, Seat seat, const Eigen::Vector2d& around) {
  std::optional<Seat> best;
  double furthest = (near.at(seat.profile, seat.column)->place - around).norm();
  for (const auto& [dp, db] : {std::pair{0, 1}, {0, -1}, {1, 0}, {-1, 0}}) {
    const Seat next{seat.profile + dp, seat.column + db};
    const auto* cell = near.at(next.profile, next.column);
    if (cell == nullptr) continue;
    const double out = (cell->place - around).norm();
    if (out <= furthest) continue;
    furthest = out;
    best = next;
  }
  return best;
}

/// Whether anything came back from further out: several mixed beams in a row may be missing.
bool is_backed(const Neighbourhood& near, Seat seat, const Eigen::Vector2d& around) {
  for (int k = 0; k < kMostMixedInRow; ++k) {
    const auto next = outward(near, seat, around);
    if (!next) return false;
    if (std::isfinite(near.at(next->profile, next->column)->off_m)) return true;
    seat = *next;
  }
  return false;
}

/// The plane of what lies well outside the target; nothing where most of it is no plane.
std::optional<PlaneFit> find_background(const BeamGrid& grid, const Neighbourhood& near,
                                        const Eigen::Vector2d& around, double reach_m) {
  std::vector<Eigen::Vector3d> points, rays;
  for (int p = 0; p < near.profiles; ++p) {
    for (int b = 0; b < near.width; ++b) {
      const auto* cell = near.at(p, b);
      if (cell == nullptr || cell->on || !std::isfinite(cell->off_m)) continue;
      const double out = (cell->place - around).norm();
      if (out < kWellOutside * reach_m || out > kFurthestOut * reach_m) continue;
      points.push_back(grid.point(p, near.first_beam + b)->position_m);
      rays.push_back((points.back() - grid.origin(p)).normalized());
    }
  }
  auto plane = fit_plane(points, rays);
  if (!plane || plane->rms_m > near.tolerance_m / 2) return std::nullopt;
  if (static_cast<double>(plane->inliers.size()) <
      kMostlyFlat * static_cast<double>(points.size())) {
    return std::nullopt;
  }
  return plane;
}

/// How far a return lies behind the background's plane, along its ray.
double off_background(const BeamGrid& grid, const Neighbourhood& near, Seat seat,
                      const PlaneFit& background) {
  const int beam = near.first_beam + seat.column;
  const auto place = grid.meets(background, seat.profile, beam);
  if (!place) return std::numeric_limits<double>::infinity();
  return (grid.point(seat.profile, beam)->position_m - *place).dot(grid.ray(seat.profile, beam));
}

/// What a beam that is not on the target is; nothing for one that tells nothing.
std::optional<BeamState> state_off(const BeamGrid& grid, const Neighbourhood& near, Seat seat,
                                   const Eigen::Vector2d& around,
                                   const std::optional<PlaneFit>& background) {
  const auto& cell = *near.at(seat.profile, seat.column);
  const bool returned = std::isfinite(cell.off_m);
  const auto next = outward(near, seat, around);
  if (!next) return returned ? BeamState::kBeyond : BeamState::kNothing;
  const auto& beyond = *near.at(next->profile, next->column);
  if (beyond.on) return std::nullopt;
  // The same tolerance as on the target, so that the band of mixed beams is as wide on both sides
  // of the edge.
  if (returned && background &&
      std::abs(off_background(grid, near, seat, *background)) <= near.tolerance_m) {
    return BeamState::kBeyond;
  }
  if (!returned) {
    return is_backed(near, seat, around) ? BeamState::kMixed : BeamState::kNothing;
  }
  if (!std::isfinite(beyond.off_m)) return BeamState::kMixed;
  if (background) return BeamState::kMixed;
  const double apart = (cell.place - beyond.place).norm();
  const bool level = std::abs(cell.off_m - beyond.off_m) <= kBackgroundSlope * apart;
  return level ? BeamState::kBeyond : BeamState::kMixed;
}

/// Beams on the target near its edge have behind them what the nearest beam off it has.
void find_backing(std::vector<EdgeBeam>& beams, const Eigen::Vector2d& around) {
  std::vector<const EdgeBeam*> off;
  for (const EdgeBeam& beam : beams) {
    if (beam.state != BeamState::kOn) off.push_back(&beam);
  }
  if (off.empty()) return;
  // By direction from the middle: the nearest in angle among those off the target.
  const auto direction = [&](const EdgeBeam& beam) {
    return std::atan2(beam.place_m.y() - around.y(), beam.place_m.x() - around.x());
  };
  constexpr std::size_t kSectors = 72;
  std::array<int, kSectors> nothing{}, backed{};
  const auto sector = [&](const EdgeBeam& beam) {
    const double share = (direction(beam) + kPi) / (2 * kPi);
    return std::min(static_cast<std::size_t>(share * kSectors), kSectors - 1);
  };
  for (const EdgeBeam* beam : off) {
    ++(beam->state == BeamState::kNothing ? nothing : backed)[sector(*beam)];
  }
  for (EdgeBeam& beam : beams) {
    const std::size_t s = sector(beam);
    beam.backed = backed[s] >= nothing[s];
  }
}

}  // namespace

double on_tolerance_m(const PlaneFit& plane) {
  return std::max(kOnSigmas * plane.rms_m, kLeastTolerance_m);
}

std::vector<EdgeBeam> edge_beams(const BeamGrid& grid, const PlaneFit& plane,
                                 const Eigen::Vector2d& around, double reach_m) {
  const Neighbourhood near = look_around(grid, plane, around, reach_m);
  const auto background = find_background(grid, near, around, reach_m);
  std::vector<EdgeBeam> beams;
  for (int p = 0; p < near.profiles; ++p) {
    for (int b = 0; b < near.width; ++b) {
      const auto* cell = near.at(p, b);
      if (cell == nullptr || (cell->place - around).norm() > reach_m) continue;
      EdgeBeam beam;
      beam.place_m = cell->place;
      beam.behind_m = cell->off_m;
      if (const CloudPoint* point = grid.point(p, near.first_beam + b)) {
        beam.intensity = point->intensity;
      }
      if (!cell->on) {
        const auto state = state_off(grid, near, {p, b}, around, background);
        if (!state) continue;
        beam.state = *state;
      }
      beams.push_back(beam);
    }
  }
  find_backing(beams, around);
  return beams;
}

}  // namespace scanfuse::calibrate
