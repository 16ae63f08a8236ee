#include "scanfuse/segment/segmenter.hpp"

namespace scanfuse::segment {
namespace {

using Method =
    std::variant<Pag, PagLiteral, Surface, Breakpoint, Adaptive, DistanceThreshold, Euclidean>;

Method make_method(const SegmentOptions& options) {
  switch (options.method) {
    case SegmentMethod::kPag:
      return Pag(options.pag);
    case SegmentMethod::kPagLiteral:
      return PagLiteral(options.pag_literal);
    case SegmentMethod::kSurface:
      return Surface(options.surface);
    case SegmentMethod::kBreakpoint:
      return Breakpoint(options.breakpoint);
    case SegmentMethod::kAdaptive:
      return Adaptive(options.adaptive);
    case SegmentMethod::kDistanceThreshold:
      return DistanceThreshold(options.distance_threshold);
    case SegmentMethod::kEuclidean:
      return Euclidean(options.euclidean);
  }
  return Pag(options.pag);
}

}  // namespace

Segmenter::Segmenter(const SegmentOptions& options) : method_(make_method(options)) {}

const Clusters& Segmenter::operator()(const VirtualScan& scan) {
  return std::visit([&](auto& method) -> const Clusters& { return method(scan); }, method_);
}

}  // namespace scanfuse::segment
