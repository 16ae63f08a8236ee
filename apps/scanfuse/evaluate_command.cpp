#include "command.hpp"

namespace scanfuse::app {

void add_evaluate(Tool& tool) { (void)tool; }

}  // namespace scanfuse::app
