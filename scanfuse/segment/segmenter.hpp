#pragma once

#include <array>
#include <concepts>
#include <tuple>
#include <utility>
#include <variant>

#include "scanfuse/core/options.hpp"
#include "scanfuse/segment/adaptive.hpp"
#include "scanfuse/segment/breakpoint.hpp"
#include "scanfuse/segment/euclidean.hpp"
#include "scanfuse/segment/pag.hpp"
#include "scanfuse/segment/pag_literal.hpp"
#include "scanfuse/segment/surface.hpp"

namespace scanfuse::segment {

/// A way to cut a virtual scan into objects. It owns its working memory, so that scans after the
/// first few allocate nothing; the result stays valid until the next call. Clusters come in the
/// order of their first point (so by bearing), indices ascending; on a full circle a cluster across
/// +-pi is one.
template <class T>
concept Segmentation = requires(T segment, const VirtualScan& scan) {
  { segment(scan) } -> std::same_as<const Clusters&>;
};

enum class SegmentMethod {
  kPag,
  kPagLiteral,
  kSurface,
  kBreakpoint,
  kAdaptive,
  kDistanceThreshold,
  kEuclidean
};

constexpr auto choices(SegmentMethod) {
  using enum SegmentMethod;
  return std::array{std::pair{"pag", kPag},
                    std::pair{"pag_literal", kPagLiteral},
                    std::pair{"surface", kSurface},
                    std::pair{"breakpoint", kBreakpoint},
                    std::pair{"adaptive", kAdaptive},
                    std::pair{"distance_threshold", kDistanceThreshold},
                    std::pair{"euclidean", kEuclidean}};
}

/// The method, and the options of each: sections of their own in a configuration file.
struct SegmentOptions {
  SegmentMethod method = SegmentMethod::kPag;
  PagOptions pag;
  PagLiteralOptions pag_literal;
  SurfaceOptions surface;
  BreakpointOptions breakpoint;
  AdaptiveOptions adaptive;
  DistanceThresholdOptions distance_threshold;
  EuclideanOptions euclidean;

  static constexpr auto fields() {
    return std::tuple{Field{"method", &SegmentOptions::method, "how a scan is cut into objects"}};
  }
};

/// The configured method.
class Segmenter {
 public:
  explicit Segmenter(const SegmentOptions& options = {});
  /// The result stays valid until the next call.
  const Clusters& operator()(const VirtualScan& scan);

 private:
  std::variant<Pag, PagLiteral, Surface, Breakpoint, Adaptive, DistanceThreshold, Euclidean>
      method_;
};

}  // namespace scanfuse::segment
