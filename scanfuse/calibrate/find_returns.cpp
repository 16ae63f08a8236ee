#include <algorithm>
#include <cmath>
#include <optional>

#include "scanfuse/calibrate/middle.hpp"
#include "scanfuse/calibrate/pose.hpp"

namespace scanfuse::calibrate {
namespace {

using Eigen::Vector2d;

struct Point {
  BeamReturn beam;
  Vector2d at;
};
using Points = std::vector<Point>;

Points usable(std::span<const BeamReturn> scan, double scale) {
  Points points;
  for (const auto& r : scan) {
    if (!std::isfinite(r.range_m) || !std::isfinite(r.angle_rad) || !(r.range_m > 0)) continue;
    const double range = scale * r.range_m;
    points.push_back({{r.angle_rad, range, r.intensity},
                      range * Vector2d(std::cos(r.angle_rad), std::sin(r.angle_rad))});
  }
  std::stable_sort(points.begin(), points.end(), [](const Point& a, const Point& b) {
    return a.beam.angle_rad < b.beam.angle_rad;
  });
  return points;
}

/// Of one range, from second differences: blind to straight walls and to most of anything else.
double noise_of(const Points& points) {
  std::vector<double> bends;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    bends.push_back(std::abs(points[i - 1].beam.range_m - 2 * points[i].beam.range_m +
                             points[i + 1].beam.range_m));
  }
  return middle_of(std::move(bends)) / (0.6745 * std::sqrt(6.0));
}

/// Returns [first, last) that follow one straight line.
struct Run {
  std::size_t first = 0;
  std::size_t last = 0;
  Vector2d centre = Vector2d::Zero();
  Vector2d along = Vector2d::UnitX();
  [[nodiscard]] std::size_t size() const { return last - first; }
  [[nodiscard]] double distance(const Vector2d& p) const {
    return std::abs(along.x() * (p.y() - centre.y()) - along.y() * (p.x() - centre.x()));
  }
};

Run fit(const Points& points, std::size_t first, std::size_t last) {
  Run run{first, last};
  for (std::size_t i = first; i < last; ++i) {
    run.centre += points[i].at / static_cast<double>(last - first);
  }
  Eigen::Matrix2d S = Eigen::Matrix2d::Zero();
  for (std::size_t i = first; i < last; ++i) {
    S += (points[i].at - run.centre) * (points[i].at - run.centre).transpose();
  }
  const double angle = 0.5 * std::atan2(2 * S(0, 1), S(0, 0) - S(1, 1));
  run.along = {std::cos(angle), std::sin(angle)};
  return run;
}

/// Splits where the chord is left by more than `limit` (iterative end point fit).
void split(const Points& points, std::size_t first, std::size_t last, double limit,
           std::vector<Run>& runs) {
  std::vector<std::array<std::size_t, 2>> stack{{first, last}};
  while (!stack.empty()) {
    const auto [a, b] = stack.back();
    stack.pop_back();
    if (b - a < 4) continue;
    const Vector2d chord = (points[b - 1].at - points[a].at).normalized();
    double worst = 0;
    std::size_t at = a;
    for (std::size_t i = a; i < b; ++i) {
      const Vector2d d = points[i].at - points[a].at;
      const double off = std::abs(chord.x() * d.y() - chord.y() * d.x());
      if (off > worst) {
        worst = off;
        at = i;
      }
    }
    if (worst <= limit) {
      runs.push_back(fit(points, a, b));
    } else {
      stack.push_back({at, b});
      stack.push_back({a, std::min(at + 1, b - 1)});
    }
  }
}

/// Straight runs, in order of angle; neighbours on one line are joined.
std::vector<Run> straight_runs(const Points& points, double noise_m) {
  std::vector<Run> runs;
  const double limit = std::max(6 * noise_m, 0.004);
  std::size_t start = 0;
  for (std::size_t i = 1; i <= points.size(); ++i) {
    const bool cut = i == points.size() || [&] {
      const double step = points[i].beam.angle_rad - points[i - 1].beam.angle_rad;
      const double range = std::min(points[i].beam.range_m, points[i - 1].beam.range_m);
      return std::abs(points[i].beam.range_m - points[i - 1].beam.range_m) >
             0.02 + 8 * noise_m + 4 * range * step;
    }();
    if (!cut) continue;
    split(points, start, i, limit, runs);
    start = i;
  }
  std::vector<Run> joined;
  for (const auto& run : runs) {
    if (!joined.empty()) {
      const Run both = fit(points, joined.back().first, run.last);
      const bool near = run.first - joined.back().last <= 4;
      if (near && both.distance(points[joined.back().first].at) < limit &&
          both.distance(points[run.last - 1].at) < limit &&
          both.distance(points[run.first].at) < limit) {
        joined.back() = both;
        continue;
      }
    }
    joined.push_back(run);
  }
  std::erase_if(joined, [](const Run& run) { return run.size() < 8; });
  return joined;
}

struct Match {
  std::array<Run, 2> runs;  ///< of board 0 and board 1
  Vector2d meet = Vector2d::Zero();
  std::array<Vector2d, 2> directions;
  double angle_rad = 0;
  double score = 0;
};

/// How well two runs pass for the V: the share of both boards' reach that they cover.
std::optional<Match> match(const VLines& seen, const Points& points, const Run& zero,
                           const Run& one) {
  const double cross = zero.along.x() * one.along.y() - zero.along.y() * one.along.x();
  if (std::abs(cross) < 0.05) return std::nullopt;
  const Vector2d apart = one.centre - zero.centre;
  const double t = (apart.x() * one.along.y() - apart.y() * one.along.x()) / cross;
  Match m{{zero, one}, zero.centre + t * zero.along, {}, 0, 1};
  for (std::size_t b = 0; b < 2; ++b) {
    const Run& run = m.runs[b];
    const bool back = run.along.dot(run.centre - m.meet) < 0;
    m.directions[b] = back ? Vector2d(-run.along) : run.along;
    const double ends[] = {m.directions[b].dot(points[run.first].at - m.meet),
                           m.directions[b].dot(points[run.last - 1].at - m.meet)};
    const auto [low, high] = seen.reach_m[b];
    const double covered =
        std::min(high, std::max(ends[0], ends[1])) - std::max(low, std::min(ends[0], ends[1]));
    m.score *= std::clamp(covered / (high - low), 0.0, 1.0);
  }
  m.angle_rad = std::acos(std::clamp(m.directions[0].dot(m.directions[1]), -1.0, 1.0));
  return m;
}

struct Search {
  std::optional<Match> best;
  double nearest_rad = 1e9;  ///< how far the best-covering V's angle is off, of those off too far
};

Search search(const VLines& seen, const Points& points, double noise_m, BoardOrder first) {
  const auto runs = straight_runs(points, noise_m);
  Search result;
  for (std::size_t a = 0; a < runs.size(); ++a) {
    for (std::size_t b = a + 1; b < runs.size(); ++b) {
      const bool ascending = first == BoardOrder::kAscending;
      auto m = match(seen, points, runs[ascending ? a : b], runs[ascending ? b : a]);
      if (!m || m->score < 0.25) continue;
      const double off = std::abs(m->angle_rad - seen.angle_rad);
      const double length = static_cast<double>(std::min(runs[a].size(), runs[b].size()));
      const double spread = noise_m / (0.1 * std::sqrt(length));  // of a run's direction, roughly
      if (off > 0.03 + 6 * spread) {
        result.nearest_rad = std::min(result.nearest_rad, off);
        continue;
      }
      if (!result.best || m->score > result.best->score) result.best = m;
    }
  }
  return result;
}

/// The returns that lie over a board's squares and on its line.
BoardReturns take(const VLines& seen, const Points& points, const Match& m, double noise_m) {
  BoardReturns out;
  const double edge_m = 0.002;
  const double limit = std::max(5 * noise_m, 0.002);
  for (std::size_t b = 0; b < 2; ++b) {
    const auto [low, high] = seen.reach_m[b];
    for (const auto& p : points) {
      const double along = m.directions[b].dot(p.at - m.meet);
      if (along < low + edge_m || along > high - edge_m) continue;
      if (m.runs[b].distance(p.at) <= limit) out.on_board[b].push_back(p.beam);
    }
  }
  return out;
}

}  // namespace

Result<BoardReturns> find_board_returns(const VLines& seen, std::span<const BeamReturn> scan,
                                        BoardOrder first) {
  const Points points = usable(scan, 1);
  if (points.size() < 16) {
    return fail(Error::Code::kMalformed, "only {} of {} returns are usable", points.size(),
                scan.size());
  }
  const double noise = noise_of(points);
  const Search found = search(seen, points, noise, first);
  if (found.best) {
    auto returns = take(seen, points, *found.best, noise);
    if (returns.on_board[0].size() >= 8 && returns.on_board[1].size() >= 8) return returns;
  }
  for (const auto& [scale, unit] : {std::pair{1e-3, "millimetres"}, std::pair{1e3, "kilometres"},
                                    std::pair{1e-2, "centimetres"}}) {
    if (search(seen, usable(scan, scale), scale * noise, first).best) {
      return fail(
          Error::Code::kOutOfRange,
          "the boards' V would be in the scan if its ranges were in {}; give them in metres", unit);
    }
  }
  const std::string nearest =
      found.nearest_rad < 1
          ? fmt::format("; the nearest is {:.1f} degrees off", degrees(found.nearest_rad))
          : "";
  return fail(
      Error::Code::kNotFound,
      "no two straight runs of returns meet at the {:.1f} degrees that the camera saw "
      "between the boards{}; do both boards stand in the scan, and do image and scan belong "
      "together?",
      degrees(seen.angle_rad), nearest);
}

}  // namespace scanfuse::calibrate
