#include "command.hpp"

namespace scanfuse::app {

void add_info(Tool& tool) { (void)tool; }

}  // namespace scanfuse::app
