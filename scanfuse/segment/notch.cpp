#include "scanfuse/segment/notch.hpp"

#include <algorithm>
#include <cmath>

#include "scanfuse/geometry/angles.hpp"

namespace scanfuse::segment {
namespace {

double cross(double ax, double ay, double bx, double by) { return ax * by - ay * bx; }

}  // namespace

/// The nearest point of each column, in order of bearing without a seam; false where the cluster
/// stands around the sensor, which has no far side then.
bool NotchCutter::lay_out(const VirtualScan& scan, std::span<const std::uint32_t> cluster) {
  constexpr double kWidest = 3;  // rad
  chain_.clear();
  std::int32_t column = 0;
  double widest = 0;
  std::size_t start = 0;
  for (std::uint32_t k = 0; k < cluster.size(); ++k) {
    const PlanarPoint& p = scan.points[cluster[k]];
    if (chain_.empty() || p.column != column) {
      const double bearing = p.bearing_rad;
      if (!chain_.empty() && bearing - chain_.back().bearing_rad > widest) {
        widest = bearing - chain_.back().bearing_rad;
        start = chain_.size();
      }
      chain_.push_back({p.x_m, p.y_m, p.range_m, bearing, k, k + 1, false});
    } else if (Link& link = chain_.back(); p.range_m < link.range_m) {
      link = {p.x_m, p.y_m, p.range_m, link.bearing_rad, link.first, k + 1, false};
    } else {
      link.end = k + 1;
    }
    column = p.column;
  }
  const double swept = chain_.back().bearing_rad - chain_.front().bearing_rad;
  if (!scan.full_circle || widest < 2 * kPi - swept) return swept < kWidest;
  std::ranges::rotate(chain_, chain_.begin() + static_cast<std::ptrdiff_t>(start));
  return 2 * kPi - widest < kWidest;
}

/// The corners of the convex hull of chain_[first..last] on the side of the sensor.
void NotchCutter::stretch_hull(std::size_t first, std::size_t last) {
  hull_.clear();
  for (std::size_t k = first; k <= last; ++k) {
    while (hull_.size() > 1) {
      const Link &a = chain_[hull_[hull_.size() - 2]], &b = chain_[hull_.back()], &c = chain_[k];
      if (cross(b.x - a.x, b.y - a.y, c.x - b.x, c.y - b.y) < 0) break;
      hull_.pop_back();
    }
    hull_.push_back(static_cast<std::uint32_t>(k));
  }
}

/// The link that lies deepest behind the hull, beyond what is allowed; `last` where none does.
std::size_t NotchCutter::deepest(std::size_t first, std::size_t last, double sigma_m) {
  stretch_hull(first, last);
  // The nearest and the farthest of n normal deviates are about this far apart.
  const double noise = 2 * std::sqrt(2 * std::log(static_cast<double>(last - first + 1))) * sigma_m;
  std::size_t found = last;
  double most = 0;
  for (std::size_t h = 0; h + 1 < hull_.size(); ++h) {
    const Link &a = chain_[hull_[h]], &b = chain_[hull_[h + 1]];
    const double dx = b.x - a.x, dy = b.y - a.y, length = std::hypot(dx, dy);
    const double middle_x = (a.x + b.x) / 2, middle_y = (a.y + b.y) / 2;
    const double sine =
        std::abs(cross(dx, dy, middle_x, middle_y)) / (length * std::hypot(middle_x, middle_y));
    const double allowed = notch_m_ + noise * sine;
    for (std::size_t k = hull_[h] + 1; k < hull_[h + 1]; ++k) {
      const double depth =
          std::abs(cross(dx, dy, chain_[k].x - a.x, chain_[k].y - a.y)) / length - allowed;
      if (depth > most) most = depth, found = k;
    }
  }
  return found;
}

/// Marks the links at which a new object begins: on the wider side of each notch's bottom.
void NotchCutter::find_notches(double sigma_m) {
  const auto gap = [&](std::size_t k) {
    return std::hypot(chain_[k].x - chain_[k - 1].x, chain_[k].y - chain_[k - 1].y);
  };
  stretches_.assign(1, {0, chain_.size() - 1});
  while (!stretches_.empty()) {
    const auto [first, last] = stretches_.back();
    stretches_.pop_back();
    if (last < first + 2) continue;
    const std::size_t bottom = deepest(first, last, sigma_m);
    if (bottom == last) continue;
    const std::size_t cut = gap(bottom) >= gap(bottom + 1) ? bottom : bottom + 1;
    chain_[cut].begins = true;
    stretches_.push_back({first, cut - 1});
    stretches_.push_back({cut, last});
  }
}

const Clusters& NotchCutter::operator()(const VirtualScan& scan, const Clusters& clusters,
                                        double notch_m, int min_points) {
  if (notch_m <= 0) {
    return clusters;  // NOLINT(bugprone-return-const-ref-from-parameter): as the header says
  }
  notch_m_ = notch_m;
  labels_.assign(scan.points.size(), Gatherer::kNoise);
  for (std::size_t k = 0; k < clusters.size(); ++k) {
    const auto cluster = clusters[k];
    if (lay_out(scan, cluster)) find_notches(scan.sigma_range_m);
    std::uint32_t label = cluster[chain_.front().first];
    for (const Link& link : chain_) {
      if (link.begins) label = cluster[link.first];
      for (std::uint32_t i = link.first; i < link.end; ++i) labels_[cluster[i]] = label;
    }
  }
  return gather_(labels_, scan.points.size(), min_points);
}

}  // namespace scanfuse::segment
