#include "scanfuse/serve/http_rules.hpp"

#include <gtest/gtest.h>

namespace scanfuse::serve {
namespace {

RequestHead get(std::string_view target, std::string_view host = "localhost:8765") {
  RequestHead head;
  head.method = "GET";
  head.target = target;
  head.host = host;
  return head;
}

AccessRules open_to_the_network() {
  AccessRules rules;
  rules.loopback = false;
  rules.token = "0123456789abcdef";
  return rules;
}

TEST(HttpRules, LoopbackAnswersToItsOwnNamesOnly) {
  const AccessRules rules;
  for (const auto* host : {"localhost", "localhost:8765", "127.0.0.1:1", "[::1]:80", "[::1]"}) {
    EXPECT_EQ(check_request(rules, get("/", host)).status, 0) << host;
  }
  for (const auto* host : {"evil.example", "localhost.evil.example", "127.0.0.1.evil.example", "",
                           "[::2]", "[", "0.0.0.0"}) {
    EXPECT_EQ(check_request(rules, get("/", host)).status, 403) << host;
  }
}

TEST(HttpRules, OnlyGetAndHeadPass) {
  auto head = get("/");
  for (const auto* method : {"POST", "PUT", "DELETE", "OPTIONS", "CONNECT", "get", ""}) {
    head.method = method;
    EXPECT_EQ(check_request({}, head).status, 405) << method;
  }
  head.method = "HEAD";
  EXPECT_EQ(check_request({}, head).status, 0);
}

TEST(HttpRules, TheTokenIsTakenFromQueryCookieAndHeader) {
  const AccessRules rules = open_to_the_network();
  EXPECT_EQ(check_request(rules, get("/", "10.0.0.1")).status, 401);
  EXPECT_EQ(check_request(rules, get("/?token=0123456789abcdef", "10.0.0.1")).status, 0);
  EXPECT_EQ(check_request(rules, get("/?a=b&token=0123456789abcdef", "x")).status, 0);
  auto head = get("/viewer.js", "10.0.0.1");
  head.cookie = "other=1; scanfuse_token=0123456789abcdef";
  EXPECT_EQ(check_request(rules, head).status, 0);
  head.cookie = {};
  head.authorization = "Bearer 0123456789abcdef";
  EXPECT_EQ(check_request(rules, head).status, 0);
}

TEST(HttpRules, NothingButTheWholeTokenWillDo) {
  const AccessRules rules = open_to_the_network();
  for (const auto* query : {"/?token=", "/?token=0123456789abcde", "/?token=0123456789abcdef0",
                            "/?token=0123456789abcdeF", "/?xtoken=0123456789abcdef", "/"}) {
    EXPECT_EQ(check_request(rules, get(query)).status, 401) << query;
  }
  auto head = get("/");
  head.cookie = "xscanfuse_token=0123456789abcdef";
  EXPECT_EQ(check_request(rules, head).status, 401);
}

TEST(HttpRules, AWebsocketNeedsTheOriginOfThePageItself) {
  AccessRules rules;
  auto head = get("/ws");
  EXPECT_EQ(check_websocket(rules, head).status, 0) << "programs send none";
  head.origin = "http://localhost:8765";
  EXPECT_EQ(check_websocket(rules, head).status, 0);
  for (const auto* origin : {"http://evil.example", "http://localhost", "http://localhost:8766",
                             "null", "http://localhost:8765.evil.example", "file://"}) {
    head.origin = origin;
    EXPECT_EQ(check_websocket(rules, head).status, 403) << origin;
  }
  rules.allowed_origins = {"https://app.foxglove.dev"};
  head.origin = "https://app.foxglove.dev";
  EXPECT_EQ(check_websocket(rules, head).status, 0);
}

TEST(HttpRules, TheProtocolIsTheFirstThatIsSpoken) {
  EXPECT_EQ(choose_protocol("scanfuse.viewer.v1"), kViewerProtocol);
  EXPECT_EQ(choose_protocol("x, foxglove.sdk.v1, foxglove.websocket.v1"), "foxglove.sdk.v1");
  EXPECT_EQ(choose_protocol("foxglove.websocket.v1"), "foxglove.websocket.v1");
  EXPECT_EQ(choose_protocol("nothing,of,that"), "");
  EXPECT_EQ(choose_protocol(""), "");
}

TEST(HttpRules, TokensDifferFromOneAnother) {
  const auto one = random_token();
  EXPECT_EQ(one.size(), 32U);
  EXPECT_NE(one, random_token());
}

TEST(HttpRules, ThePolicyAllowsNothingInline) {
  EXPECT_EQ(kContentSecurityPolicy.find("unsafe"), std::string_view::npos);
  EXPECT_NE(kContentSecurityPolicy.find("default-src 'none'"), std::string_view::npos);
}

}  // namespace
}  // namespace scanfuse::serve
