#include "scanfuse/associate/packing.hpp"
namespace scanfuse::associate {
Result<PackingSolution> LagrangianPacking::operator()(const Packing& packing) const {
  return GreedyPacking{}(packing);
}
}  // namespace scanfuse::associate
