// What a client can say to `scanfuse view`: requests of the page, of Foxglove, and HTTP heads.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "scanfuse/serve/assets.hpp"
#include "scanfuse/serve/foxglove_messages.hpp"
#include "scanfuse/serve/http_rules.hpp"
#include "scanfuse/serve/requests.hpp"

using namespace scanfuse::serve;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  if (const auto request = parse_request(text); request) {
    const auto* trails = std::get_if<TrailsRequest>(&*request);
    if (trails != nullptr && trails->length > 200) std::abort();
  }
  (void)parse_foxglove(text);
  AccessRules rules;
  rules.loopback = false;
  rules.token = "0123456789abcdef";
  RequestHead head{"GET", text, text, text, text, text};
  const bool passes = check_request(rules, head).status == 0;
  if (passes && text.find(rules.token) == text.npos) std::abort();
  (void)check_websocket(rules, head);
  (void)choose_protocol(text);
  const auto path = path_of(text);
  if (find_asset(path) && path.find("..") != path.npos) std::abort();
  return 0;
}
