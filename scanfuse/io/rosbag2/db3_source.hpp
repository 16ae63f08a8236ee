#pragma once

#include <memory>
#include <string>
#include <vector>

#include "scanfuse/io/raw_message_source.hpp"
#include "scanfuse/io/rosbag2/database.hpp"

namespace scanfuse::io::rosbag2 {

/// One `.db3` file as a source of messages, in order of time. Schema versions 1 to 4: what differs
/// between them (QoS, message definitions, metadata) is optional here. Fails if the tables `topics`
/// and `messages` are missing.
[[nodiscard]] Result<std::unique_ptr<RawMessageSource>> open_db3(
    Database database, const std::vector<std::string>& topics);

}  // namespace scanfuse::io::rosbag2
