#include "command.hpp"

namespace scanfuse::app {

void add_track(Tool& tool) { (void)tool; }

}  // namespace scanfuse::app
