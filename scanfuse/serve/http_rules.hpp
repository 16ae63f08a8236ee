#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scanfuse::serve {

/// Whom the server lets in. Pure rules, apart from sockets, so that they can be tested and fuzzed.
struct AccessRules {
  bool loopback = true;                      ///< listens on this machine only
  int port = 0;                              ///< as it is bound
  std::string token;                         ///< empty: none is needed
  std::vector<std::string> allowed_origins;  ///< besides the page's own
};

/// What a request says of itself. Header fields that are absent are empty.
struct RequestHead {
  std::string_view method;
  std::string_view target;  ///< path and query as they came
  std::string_view host;
  std::string_view origin;
  std::string_view cookie;
  std::string_view authorization;
};

/// What to answer. 0: let it pass.
struct Refusal {
  int status = 0;
  std::string_view reason;  ///< in words a user can act on
};

/// - A method that is neither GET nor HEAD: 405.
/// - On loopback a Host that is no name of this machine's loopback: 403, so that no page elsewhere
///   reaches the server by a name of its own that resolves to 127.0.0.1 (DNS rebinding).
/// - With a token, a request that does not bring it (query `token=`, cookie, or
///   `Authorization: Bearer`): 401. Compared in constant time.
[[nodiscard]] Refusal check_request(const AccessRules& rules, const RequestHead& head);

/// A websocket also needs an Origin that is the page's own or allowed: 403 else. Programs that are
/// no browser send none, and pass.
[[nodiscard]] Refusal check_websocket(const AccessRules& rules, const RequestHead& head);

/// The path without its query; empty when it does not start with '/'.
[[nodiscard]] std::string_view path_of(std::string_view target);

/// The value of `token=` in the query, as it stands; tokens need no escaping.
[[nodiscard]] std::string_view token_of_query(std::string_view target);

/// Whether the request brings the token in its query: the answer then sets it as a cookie.
[[nodiscard]] bool brings_token_in_query(const AccessRules& rules, const RequestHead& head);

[[nodiscard]] bool is_loopback_address(std::string_view address);

/// 32 hexadecimal digits from the system's source of randomness.
[[nodiscard]] std::string random_token();

/// Of `offered` (the header Sec-WebSocket-Protocol) the first that the server speaks; empty: none.
[[nodiscard]] std::string_view choose_protocol(std::string_view offered);

inline constexpr std::string_view kViewerProtocol = "scanfuse.viewer.v1";
inline constexpr std::string_view kFoxgloveProtocols[] = {"foxglove.sdk.v1",
                                                          "foxglove.websocket.v1"};
[[nodiscard]] bool is_foxglove(std::string_view protocol);

/// Sent with every page: nothing from elsewhere, no inline script, no framing.
inline constexpr std::string_view kContentSecurityPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; "
    "connect-src 'self'; font-src 'self'; base-uri 'none'; form-action 'none'; "
    "frame-ancestors 'none'";

}  // namespace scanfuse::serve
