#pragma once

#include <cstddef>
#include <functional>

namespace scanfuse {

/// Calls `body(i)` once for every i in [0, count) on up to `threads` threads (0: one per core) and
/// returns when all are done. Which thread runs an index does not reach the result as long as
/// bodies write to places of their own.
void parallel_for(std::size_t count, int threads, const std::function<void(std::size_t)>& body);

}  // namespace scanfuse
