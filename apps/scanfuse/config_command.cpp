#include "command.hpp"

namespace scanfuse::app {

void add_config(Tool& tool) { (void)tool; }

}  // namespace scanfuse::app
