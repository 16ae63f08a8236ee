#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "scanfuse/core/result.hpp"
#include "scanfuse/core/time.hpp"

/// The Foxglove websocket protocol, version 1: what a client says and what it is told.
namespace scanfuse::serve {

struct FoxgloveSubscribe {
  /// Subscription (the client's number), channel (ours).
  std::vector<std::pair<std::uint32_t, std::uint32_t>> wanted;
};
struct FoxgloveUnsubscribe {
  std::vector<std::uint32_t> subscriptions;
};
/// An operation that this server does not offer.
struct FoxgloveOther {};
using FoxgloveRequest = std::variant<FoxgloveSubscribe, FoxgloveUnsubscribe, FoxgloveOther>;

/// Never crashes, whatever the text.
[[nodiscard]] Result<FoxgloveRequest> parse_foxglove(std::string_view text);

struct FoxgloveChannel {
  std::uint32_t id = 0;
  std::string topic;
  std::string encoding;  ///< "cdr", "json"
  std::string schema_name;
  std::string schema;
  std::string schema_encoding;  ///< "ros2msg", "jsonschema"
};

[[nodiscard]] std::string foxglove_server_info(std::string_view name, std::string_view session);
[[nodiscard]] std::string foxglove_advertise(const std::vector<FoxgloveChannel>& channels);
enum class FoxgloveLevel { kInfo = 0, kWarning = 1, kError = 2 };
[[nodiscard]] std::string foxglove_status(FoxgloveLevel level, std::string_view text);
/// Binary: opcode 1, subscription, time, payload.
[[nodiscard]] std::string foxglove_data(std::uint32_t subscription, Time time,
                                        std::string_view payload);
/// Binary: opcode 2, time.
[[nodiscard]] std::string foxglove_time(Time time);

}  // namespace scanfuse::serve
