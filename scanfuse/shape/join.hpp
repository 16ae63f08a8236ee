#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "scanfuse/core/disjoint_sets.hpp"
#include "scanfuse/core/options.hpp"
#include "scanfuse/shape/face_fit.hpp"
#include "scanfuse/shape/line_fit.hpp"
#include "scanfuse/shape/occlusion.hpp"
#include "scanfuse/types/clusters.hpp"
#include "scanfuse/types/expected.hpp"
#include "scanfuse/types/virtual_scan.hpp"

namespace scanfuse::shape {

/// How pieces of one object, cut apart by something nearer, are found.
enum class JoinMethod { kNone, kGuo, kOccluder };

constexpr auto choices(JoinMethod) {
  using enum JoinMethod;
  return std::array{std::pair{"none", kNone}, std::pair{"guo", kGuo},
                    std::pair{"occluder", kOccluder}};
}

struct JoinOptions {
  JoinMethod method = JoinMethod::kOccluder;
  int reach = 4;
  double max_extent_m = 6;
  double max_width_m = 2.6;
  double hidden_share = 0.6;
  double nearer_by_m = 0.5;
  double min_inlier_share = 0.85;
  double guo_gap_m = 3;
  double guo_slope_rad = 0.5235987755982988;  // 30 deg
  double expected_margin_m = 0.3;
  double limb_m = 0.3;
  double stride_m = 0.55;

  static constexpr auto fields() {
    using O = JoinOptions;
    return std::tuple{
        Field{"method", &O::method, "how pieces of an object behind another are found"},
        Field{"reach", &O::reach, 1, 32, "occluder: clusters further on that are tried"},
        Field{"max_extent_m", &O::max_extent_m, 0.0, 100.0, "no joined object is longer"},
        Field{"max_width_m", &O::max_width_m, 0.0, 100.0, "nor wider"},
        Field{"hidden_share", &O::hidden_share, 0.0, 1.0,
              "occluder: of the beams between two pieces that something nearer must stop"},
        Field{"nearer_by_m", &O::nearer_by_m, 0.0, 10.0, "occluder: nearer by at least this"},
        Field{"min_inlier_share", &O::min_inlier_share, 0.0, 1.0,
              "occluder: of both pieces' points that one rectangle's sides must explain"},
        Field{"guo_gap_m", &O::guo_gap_m, 0.0, 100.0, "guo: the longest gap between two pieces"},
        Field{"guo_slope_rad", &O::guo_slope_rad, 0.0, 1.6,
              "guo: between the gap's slope and the next piece's"},
        Field{"expected_margin_m", &O::expected_margin_m, 0.0, 10.0,
              "clusters in a track's box, grown by this and by its uncertainty, are one object; "
              "0 leaves them apart"},
        Field{"limb_m", &O::limb_m, 0.0, 1.0,
              "two clusters no longer than this that stand alone within a stride are the legs of "
              "one person; 0 leaves them apart"},
        Field{"stride_m", &O::stride_m, 0.0, 2.0, "between the middles of two legs, at most"},
    };
  }
};

/// Joins clusters that are pieces of one object.
///
/// `occluder`: two clusters are pieces when most beams between them were stopped by something
/// nearer than the line that joins them, next to none went through that line, and the sides of one
/// rectangle of a vehicle's size explain the points of both. The pieces need not be neighbours in
/// bearing: what hides the middle stands between them.
///
/// `guo` [Guo]: neighbouring clusters are joined when the line from the last point of one to the
/// first point of the next is short, and its slope is near that of the next one's points. Nothing
/// need stand in front, and cars side by side are joined too: for comparison.
///
/// Legs, by either method but `none`: of two clusters as small as limbs each is the other's nearest
/// neighbour within a stride. A scanner at knee height sees no more of a person who is near.
///
/// Clusters that lie in the box where a track expects a vehicle are joined by either method but
/// `none`, and what is too sparse there to be a cluster is added to them; clusters expected by two
/// tracks are never joined.
///
/// Owns its working memory: after the first scans nothing is allocated.
class ClusterJoiner {
 public:
  ClusterJoiner(const JoinOptions& options, const OcclusionOptions& occlusion,
                const FaceFitOptions& faces)
      : options_(options), occlusion_(occlusion), faces_(faces) {}

  /// Clusters in order of their first point, indices ascending, as they came; after them those of
  /// an expected object's points that no cluster had. Valid until the next call, and as long as
  /// `clusters`.
  const Clusters& operator()(const VirtualScan& scan, const Clusters& clusters,
                             std::span<const Expected> expected);

  /// Of each cluster of the last result: index of the expected object it lies in, or -1.
  [[nodiscard]] std::span<const std::int32_t> expected_of() const { return expected_of_; }

 private:
  struct Piece {
    std::uint32_t first = 0;  ///< the points of smallest and largest bearing
    std::uint32_t last = 0;
    CutEnds cut;
    std::int32_t expected = -1;
    bool limb = false;  ///< of a limb's size
    Eigen::Vector2d middle_m = Eigen::Vector2d::Zero();
  };
  void make_room(std::size_t points, std::size_t clusters, std::size_t expected);
  void look(const VirtualScan& scan, const Clusters& clusters);
  void join_expected(const VirtualScan& scan, const Clusters& clusters,
                     std::span<const Expected> expected);
  void join_neighbours(const VirtualScan& scan, const Clusters& clusters);
  void join_behind_occluders(const VirtualScan& scan, const Clusters& clusters);
  void join_legs();
  [[nodiscard]] std::size_t nearest_limb(std::size_t of) const;
  [[nodiscard]] bool is_hidden_between(const VirtualScan& scan, const Piece& a,
                                       const Piece& b) const;
  [[nodiscard]] bool fits_one_box(const VirtualScan& scan, std::span<const std::uint32_t> a,
                                  std::span<const std::uint32_t> b);
  [[nodiscard]] double direction_of(std::span<const Eigen::Vector2d> points);
  void join(std::size_t a, std::size_t b);
  void label_points(const VirtualScan& scan, const Clusters& clusters);
  void claim(const VirtualScan& scan, const Clusters& clusters, const Expected& object,
             std::int32_t number);
  std::size_t join_inside(const VirtualScan& scan, const Clusters& clusters, std::int32_t number);
  void add_loose_points(std::int32_t number);
  const Clusters& gather(const Clusters& clusters);

  JoinOptions options_;
  OcclusionOptions occlusion_;
  FaceFitOptions faces_;
  std::vector<Piece> pieces_;
  DisjointSets sets_;
  bool any_ = false;
  RunningSums sums_;
  std::vector<Eigen::Vector2d> points_;
  Clusters joined_;
  std::vector<std::int32_t> expected_of_;
  std::vector<std::uint32_t> next_;   ///< the following cluster of the same object
  std::vector<std::int32_t> labels_;  ///< the cluster of each point, -1: none
  std::vector<int> inside_;           ///< points of each cluster in an expected box
  /// Points of no cluster in an expected box: the number of the object, the point.
  std::vector<std::pair<std::int32_t, std::uint32_t>> loose_;
};

}  // namespace scanfuse::shape
