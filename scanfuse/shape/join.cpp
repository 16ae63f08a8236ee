#include "scanfuse/shape/join.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace scanfuse::shape {
namespace {

constexpr double kMostThrough = 0.2;  ///< of the beams between, those that pass the joining line
constexpr double kLargestSigma_m = 0.5;
constexpr std::int32_t kTaken = -2;     ///< label of a point of no cluster that an object claimed
constexpr std::size_t kLeastLoose = 3;  ///< points that make a cluster of their own
constexpr std::size_t kEnough = 8;      ///< points of a cluster that needs no loose ones

/// Range at which the beam of bearing `bearing_rad` meets the line from a to b; negative: never.
double range_on_line(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double bearing_rad) {
  const Eigen::Vector2d beam(std::cos(bearing_rad), std::sin(bearing_rad)), d = b - a;
  const double cross = beam.x() * d.y() - beam.y() * d.x();
  if (std::abs(cross) < 1e-9) return -1;
  return (a.x() * d.y() - a.y() * d.x()) / cross;
}

/// The bearings under which a circle is seen; all of them from inside.
struct Bearings {
  double from_rad = -kPi, to_rad = kPi;

  Bearings(const Eigen::Vector2d& centre_m, double radius_m) {
    const double range = centre_m.norm();
    if (range <= radius_m) return;
    const double middle = std::atan2(centre_m.y(), centre_m.x());
    const double half = std::asin(radius_m / range);
    from_rad = middle - half;
    to_rad = middle + half;
  }
};

/// Calls visit(index) for the points within; those beyond +-pi are looked for a turn away.
template <class Visit>
void for_points_within(const VirtualScan& scan, const Bearings& bearings, Visit&& visit) {
  const auto look = [&](double from_rad, double to_rad) {
    auto p = std::ranges::lower_bound(scan.points, static_cast<float>(from_rad), {},
                                      &PlanarPoint::bearing_rad);
    for (; p != scan.points.end() && p->bearing_rad <= to_rad; ++p) {
      visit(static_cast<std::uint32_t>(p - scan.points.begin()));
    }
  };
  look(std::max(bearings.from_rad, -kPi), std::min(bearings.to_rad, kPi));
  if (bearings.to_rad > kPi) look(-kPi, bearings.to_rad - 2 * kPi);
  if (bearings.from_rad < -kPi) look(bearings.from_rad + 2 * kPi, kPi);
}

double angle_between_lines(double a_rad, double b_rad) {
  return std::abs(wrap_half_pi(a_rad - b_rad));
}

}  // namespace

const Clusters& ClusterJoiner::operator()(const VirtualScan& scan, const Clusters& clusters,
                                          std::span<const Expected> expected) {
  make_room(scan.points.size(), clusters.size(), expected.size());
  expected_of_.assign(clusters.size(), -1);
  if (options_.method == JoinMethod::kNone || clusters.size() == 0) {
    return clusters;  // NOLINT(bugprone-return-const-ref-from-parameter): as the header says
  }
  sets_.reset(clusters.size());
  any_ = false;
  look(scan, clusters);
  if (options_.expected_margin_m > 0) join_expected(scan, clusters, expected);
  if (options_.method == JoinMethod::kGuo) {
    join_neighbours(scan, clusters);
  } else {
    join_behind_occluders(scan, clusters);
  }
  join_legs();
  if (any_) return gather(clusters);
  for (std::size_t k = 0; k < clusters.size(); ++k) expected_of_[k] = pieces_[k].expected;
  return clusters;  // NOLINT(bugprone-return-const-ref-from-parameter): as the header says
}

/// Joins are rare: memory must not wait for the first one.
void ClusterJoiner::make_room(std::size_t points, std::size_t clusters, std::size_t expected) {
  const auto room = [](auto& buffer, std::size_t size) {
    if (buffer.capacity() < size) buffer.reserve(2 * size);
  };
  room(points_, points);
  room(labels_, points);
  room(loose_, points);
  room(joined_.indices, points);
  room(joined_.ends, clusters + expected);
  room(expected_of_, clusters + expected);
  room(pieces_, clusters);
  room(inside_, clusters);
  room(next_, clusters);
}

void ClusterJoiner::look(const VirtualScan& scan, const Clusters& clusters) {
  pieces_.clear();
  for (std::size_t k = 0; k < clusters.size(); ++k) {
    Piece& piece = pieces_.emplace_back();
    if (clusters[k].empty()) continue;
    piece.first = clusters[k].front();
    piece.last = clusters[k].back();
    piece.cut = find_cut_ends(scan, piece.first, piece.last, occlusion_);
    const Eigen::Vector2d first = scan.position(piece.first), last = scan.position(piece.last);
    piece.limb = (last - first).norm() <= options_.limb_m;
    piece.middle_m = (first + last) / 2;
  }
}

/// The limb within a stride that is nearest, of `reach` clusters before and behind in order; `of`
/// itself where there is none.
std::size_t ClusterJoiner::nearest_limb(std::size_t of) const {
  const auto reach = static_cast<std::size_t>(options_.reach);
  std::size_t best = of;
  double nearest2 = options_.stride_m * options_.stride_m;
  for (std::size_t k = of - std::min(of, reach); k < pieces_.size() && k <= of + reach; ++k) {
    const double apart2 = (pieces_[k].middle_m - pieces_[of].middle_m).squaredNorm();
    if (k == of || !pieces_[k].limb || apart2 > nearest2) continue;
    nearest2 = apart2;
    best = k;
  }
  return best;
}

void ClusterJoiner::join_legs() {
  if (options_.limb_m <= 0) return;
  for (std::size_t a = 0; a < pieces_.size(); ++a) {
    if (!pieces_[a].limb || pieces_[a].expected >= 0) continue;
    const std::size_t b = nearest_limb(a);
    if (b > a && pieces_[b].expected < 0 && nearest_limb(b) == a) join(a, b);
  }
}

void ClusterJoiner::join(std::size_t a, std::size_t b) {
  sets_.join(static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b));
  any_ = true;
}

void ClusterJoiner::label_points(const VirtualScan& scan, const Clusters& clusters) {
  labels_.assign(scan.points.size(), -1);
  for (std::size_t k = 0; k < clusters.size(); ++k) {
    for (const std::uint32_t i : clusters[k]) labels_[i] = static_cast<std::int32_t>(k);
  }
}

void ClusterJoiner::join_expected(const VirtualScan& scan, const Clusters& clusters,
                                  std::span<const Expected> expected) {
  loose_.clear();
  if (expected.empty()) return;
  label_points(scan, clusters);
  inside_.assign(clusters.size(), 0);
  for (std::size_t e = 0; e < expected.size(); ++e) {
    claim(scan, clusters, expected[e], static_cast<std::int32_t>(e));
  }
}

/// Looks at the points whose bearings cross the circle around the box.
void ClusterJoiner::claim(const VirtualScan& scan, const Clusters& clusters, const Expected& object,
                          std::int32_t number) {
  const double margin = options_.expected_margin_m + std::min(object.sigma_m, kLargestSigma_m);
  const double reach = 0.5 * std::hypot(object.box.length_m, object.box.width_m) + 2 * margin;
  const Bearings bearings(object.box.centre_m, reach);
  const std::size_t loose_before = loose_.size();
  const InBox is_inside(object.box, margin);
  for_points_within(scan, bearings, [&](std::uint32_t i) {
    if (!is_inside(scan.position(i))) return;
    if (labels_[i] >= 0) {
      ++inside_[static_cast<std::size_t>(labels_[i])];
    } else {
      loose_.emplace_back(number, i);
      labels_[i] = kTaken;
    }
  });
  const std::size_t clustered = join_inside(scan, clusters, number);
  const std::size_t loose = loose_.size() - loose_before;
  if (clustered >= kEnough || clustered + loose < kLeastLoose) {
    loose_.resize(loose_before);
  } else {
    any_ |= loose > 0;
  }
}

/// Joins to the largest cluster in the box those that one rectangle explains with it: what stands
/// in the box may also be seen through a window. How many points they have.
std::size_t ClusterJoiner::join_inside(const VirtualScan& scan, const Clusters& clusters,
                                       std::int32_t number) {
  std::size_t largest = clusters.size(), points = 0;
  for (std::size_t k = 0; k < clusters.size(); ++k) {
    const auto inside = static_cast<std::size_t>(inside_[k]);
    const bool mostly_inside = inside * 10 >= clusters[k].size() * 8 && inside > 0;
    inside_[k] = 0;
    if (!mostly_inside || pieces_[k].expected >= 0) continue;
    pieces_[k].expected = number;
    if (largest == clusters.size() || clusters[k].size() > clusters[largest].size()) largest = k;
  }
  for (std::size_t k = 0; k < clusters.size(); ++k) {
    if (pieces_[k].expected != number) continue;
    const bool fits = k == largest || fits_one_box(scan, clusters[largest], clusters[k]);
    if (fits) points += clusters[k].size();
    if (fits && k != largest) join(largest, k);
  }
  return points;
}

void ClusterJoiner::join_neighbours(const VirtualScan& scan, const Clusters& clusters) {
  for (std::size_t k = 0; k + 1 < clusters.size(); ++k) {
    if (clusters[k].empty() || clusters[k + 1].empty()) continue;
    const Eigen::Vector2d from = scan.position(pieces_[k].last),
                          to = scan.position(pieces_[k + 1].first), gap = to - from;
    if (gap.norm() >= options_.guo_gap_m) continue;
    points_.clear();
    for (const std::uint32_t i : clusters[k + 1]) points_.push_back(scan.position(i));
    const double slope = direction_of(points_);
    if (angle_between_lines(slope, std::atan2(gap.y(), gap.x())) < options_.guo_slope_rad) {
      join(k, k + 1);
    }
  }
}

void ClusterJoiner::join_behind_occluders(const VirtualScan& scan, const Clusters& clusters) {
  const auto reach = static_cast<std::size_t>(options_.reach);
  for (std::size_t a = 0; a < clusters.size(); ++a) {
    if (!pieces_[a].cut.left) continue;
    for (std::size_t b = a + 1; b < clusters.size() && b <= a + reach; ++b) {
      const std::int32_t owner_a = pieces_[a].expected, owner_b = pieces_[b].expected;
      if (!pieces_[b].cut.right || (owner_a >= 0 && owner_b >= 0 && owner_a != owner_b)) continue;
      if (pieces_[b].first < pieces_[a].last) continue;
      const double extent =
          (scan.position(pieces_[b].last) - scan.position(pieces_[a].first)).norm();
      if (extent > options_.max_extent_m) continue;
      if (!is_hidden_between(scan, pieces_[a], pieces_[b])) continue;
      if (fits_one_box(scan, clusters[a], clusters[b])) join(a, b);
    }
  }
}

double ClusterJoiner::direction_of(std::span<const Eigen::Vector2d> points) {
  sums_.reset(points);
  return sums_.fit(0, points.size() - 1).direction_rad();
}

bool ClusterJoiner::is_hidden_between(const VirtualScan& scan, const Piece& a,
                                      const Piece& b) const {
  const Eigen::Vector2d from = scan.position(a.last), to = scan.position(b.first);
  const int columns = scan.points[b.first].column - scan.points[a.last].column - 1;
  if (columns < 1) return false;
  int hidden = 0, through = 0;
  std::int32_t column = scan.points[a.last].column;
  for (std::uint32_t i = a.last + 1; i < b.first; ++i) {
    const PlanarPoint& p = scan.points[i];
    if (p.column == scan.points[b.first].column) break;
    const double line = range_on_line(from, to, p.bearing_rad);
    if (p.range_m < line - options_.nearer_by_m) {
      if (p.column != column) ++hidden;
      column = p.column;
    } else if (p.range_m > line + options_.nearer_by_m && p.column != column) {
      ++through;
    }
  }
  return hidden >= options_.hidden_share * columns && through <= kMostThrough * columns;
}

bool ClusterJoiner::fits_one_box(const VirtualScan& scan, std::span<const std::uint32_t> a,
                                 std::span<const std::uint32_t> b) {
  points_.clear();
  for (const std::uint32_t i : a) points_.push_back(scan.position(i));
  for (const std::uint32_t i : b) points_.push_back(scan.position(i));
  const std::span<const Eigen::Vector2d> all(points_), first = all.first(a.size()),
                                                       second = all.subspan(a.size());
  for (const auto& part : {all, first, second}) {
    if (part.size() < 2) continue;
    const double heading = direction_of(part);
    const FaceFit fit = fit_faces(all, heading, scan.sigma_range_m, faces_);
    if (fit.inlier_share < options_.min_inlier_share) continue;
    const Eigen::Vector2d u = fit.a.tangent(), n = fit.a.normal;
    double low_u = 1e9, high_u = -1e9, low_n = 1e9, high_n = -1e9;
    for (const auto& p : all) {
      low_u = std::min(low_u, u.dot(p)), high_u = std::max(high_u, u.dot(p));
      low_n = std::min(low_n, n.dot(p)), high_n = std::max(high_n, n.dot(p));
    }
    const double along = high_u - low_u, across = high_n - low_n;
    if (std::max(along, across) <= options_.max_extent_m &&
        std::min(along, across) <= options_.max_width_m) {
      return true;
    }
  }
  return false;
}

const Clusters& ClusterJoiner::gather(const Clusters& clusters) {
  const auto count = static_cast<std::uint32_t>(clusters.size());
  next_.assign(count, count);
  joined_.clear();
  expected_of_.clear();
  // Roots are the smallest of their set, so chains can be built from the back.
  for (std::uint32_t k = count; k-- > 0;) {
    const std::uint32_t root = sets_.find(k);
    if (root != k) next_[k] = std::exchange(next_[root], k);
  }
  for (std::uint32_t k = 0; k < count; ++k) {
    if (sets_.find(k) != k) continue;
    const auto begin = static_cast<std::ptrdiff_t>(joined_.indices.size());
    std::int32_t owner = -1;
    for (std::uint32_t piece = k; piece < count; piece = next_[piece]) {
      joined_.indices.insert(joined_.indices.end(), clusters[piece].begin(), clusters[piece].end());
      owner = std::max(owner, pieces_[piece].expected);
    }
    if (owner >= 0) add_loose_points(owner);
    std::sort(joined_.indices.begin() + begin, joined_.indices.end());
    joined_.close();
    expected_of_.push_back(owner);
  }
  while (!loose_.empty()) {
    const std::int32_t owner = loose_.front().first;
    const std::size_t begin = joined_.indices.size();
    add_loose_points(owner);
    if (joined_.indices.size() - begin < kLeastLoose) {
      joined_.indices.resize(begin);
      continue;
    }
    std::sort(joined_.indices.begin() + static_cast<std::ptrdiff_t>(begin), joined_.indices.end());
    joined_.close();
    expected_of_.push_back(owner);
  }
  return joined_;
}

/// Moves the loose points of an object to the end of the cluster that is being made.
void ClusterJoiner::add_loose_points(std::int32_t number) {
  if (loose_.empty()) return;
  std::size_t kept = 0;
  for (const auto& [owner, point] : loose_) {
    if (owner == number) {
      joined_.indices.push_back(point);
    } else {
      loose_[kept++] = {owner, point};
    }
  }
  loose_.resize(kept);
}

}  // namespace scanfuse::shape
