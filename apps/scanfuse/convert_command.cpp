#include "command.hpp"

namespace scanfuse::app {

void add_convert(Tool& tool) { (void)tool; }

}  // namespace scanfuse::app
