#include "command.hpp"

namespace scanfuse::app {

void add_simulate(Tool& tool) { (void)tool; }

}  // namespace scanfuse::app
