#include "scanfuse/drivers/ros2/ros2_bus.hpp"

namespace scanfuse::drivers {

Result<std::unique_ptr<Ros2Bus>> Ros2Bus::join(const Ros2Options&) {
  return fail(Error::Code::kUnsupported,
              "scanfuse was built without ROS 2: install cyclonedds-dev and build again");
}

}  // namespace scanfuse::drivers
