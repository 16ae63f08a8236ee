#include "command.hpp"

namespace scanfuse::app {

void add_bench(Tool& tool) { (void)tool; }

}  // namespace scanfuse::app
