#include "scanfuse/serve/foxglove_messages.hpp"

#include <nlohmann/json.hpp>

#include "scanfuse/serve/wire.hpp"

namespace scanfuse::serve {
namespace {

using Json = nlohmann::json;
constexpr std::size_t kMostAtOnce = 1000;

std::string dumped(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

bool read_id(const Json& json, std::uint32_t& id) {
  if (!json.is_number_unsigned() || json.get<std::uint64_t>() > 0xffffffffULL) return false;
  id = json.get<std::uint32_t>();
  return true;
}

const Json* list_of(const Json& json, const char* name) {
  const auto found = json.find(name);
  const bool fits = found != json.end() && found->is_array() && found->size() <= kMostAtOnce;
  return fits ? &*found : nullptr;
}

Result<FoxgloveRequest> read_subscribe(const Json& json) {
  const Json* list = list_of(json, "subscriptions");
  if (list == nullptr) return fail(Error::Code::kMalformed, "subscribe: no 'subscriptions'");
  FoxgloveSubscribe request;
  for (const Json& one : *list) {
    std::uint32_t subscription = 0, channel = 0;
    const bool fine = one.is_object() && one.contains("id") && one.contains("channelId") &&
                      read_id(one["id"], subscription) && read_id(one["channelId"], channel);
    if (!fine) return fail(Error::Code::kMalformed, "subscribe: 'id' and 'channelId' are numbers");
    request.wanted.emplace_back(subscription, channel);
  }
  return request;
}

Result<FoxgloveRequest> read_unsubscribe(const Json& json) {
  const Json* list = list_of(json, "subscriptionIds");
  if (list == nullptr) return fail(Error::Code::kMalformed, "unsubscribe: no 'subscriptionIds'");
  FoxgloveUnsubscribe request;
  for (const Json& one : *list) {
    std::uint32_t id = 0;
    if (!read_id(one, id)) return fail(Error::Code::kMalformed, "unsubscribe: ids are numbers");
    request.subscriptions.push_back(id);
  }
  return request;
}

}  // namespace

Result<FoxgloveRequest> parse_foxglove(std::string_view text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return fail(Error::Code::kMalformed, "not a JSON object");
  const auto op = json.find("op");
  if (op == json.end() || !op->is_string()) return fail(Error::Code::kMalformed, "no 'op'");
  if (*op == "subscribe") return read_subscribe(json);
  if (*op == "unsubscribe") return read_unsubscribe(json);
  return FoxgloveOther{};
}

std::string foxglove_server_info(std::string_view name, std::string_view session) {
  return dumped({{"op", "serverInfo"},
                 {"name", name},
                 {"capabilities", {"time"}},
                 {"supportedEncodings", Json::array()},
                 {"metadata", Json::object()},
                 {"sessionId", session}});
}

std::string foxglove_advertise(const std::vector<FoxgloveChannel>& channels) {
  Json list = Json::array();
  for (const auto& channel : channels) {
    list.push_back({{"id", channel.id},
                    {"topic", channel.topic},
                    {"encoding", channel.encoding},
                    {"schemaName", channel.schema_name},
                    {"schema", channel.schema},
                    {"schemaEncoding", channel.schema_encoding}});
  }
  return dumped({{"op", "advertise"}, {"channels", list}});
}

std::string foxglove_status(FoxgloveLevel level, std::string_view text) {
  return dumped({{"op", "status"}, {"level", static_cast<int>(level)}, {"message", text}});
}

std::string foxglove_data(std::uint32_t subscription, Time time, std::string_view payload) {
  WireWriter out(13 + payload.size());
  out.put(std::uint8_t{1}).u32(subscription).put(to_nanos(time));
  return out.take().append(payload);
}

std::string foxglove_time(Time time) {
  WireWriter out;
  out.put(std::uint8_t{2}).put(to_nanos(time));
  return out.take();
}

}  // namespace scanfuse::serve
