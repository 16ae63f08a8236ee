#include "scanfuse/serve/server.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <thread>

#include "serve/raw_client.hpp"

namespace scanfuse::serve {
namespace {

using scanfuse::testing::RawClient;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

/// Answers every text by itself.
struct Echo {
  explicit Echo(ServerOptions options = {}) {
    options.port = 0;
    auto started = Server::start(options, {[this](ClientId, std::string_view) { ++opened; },
                                           [this](ClientId id, std::string message, bool) {
                                             ready.wait();
                                             server->send(id, {std::move(message), false, 0});
                                           },
                                           [this](ClientId) { ++closed; }});
    EXPECT_TRUE(started) << started.error().message;
    server = std::make_unique<Server>(std::move(*started));
    set.set_value();
  }
  std::promise<void> set;
  std::shared_future<void> ready = set.get_future().share();
  std::atomic<int> opened{0}, closed{0};
  std::unique_ptr<Server> server;
};

TEST(Server, GivesThePageWithItsPolicy) {
  const Echo echo;
  for (const auto* path : {"/", "/index.html", "/viewer.js", "/viewer.css", "/?token=whatever"}) {
    const auto answer = RawClient(echo.server->port()).get(path);
    EXPECT_THAT(answer, StartsWith("HTTP/1.1 200 ")) << path;
    EXPECT_THAT(answer, HasSubstr("Content-Security-Policy: default-src 'none'"));
    EXPECT_THAT(answer, HasSubstr("X-Content-Type-Options: nosniff"));
    EXPECT_THAT(answer, HasSubstr("Content-Encoding: gzip"));
  }
}

TEST(Server, NoPathLeavesTheBundle) {
  const Echo echo;
  for (const auto* path :
       {"/../etc/passwd", "/%2e%2e/etc/passwd", "/..%2fetc/passwd", "//etc/passwd", "/viewer.js/",
        "/./viewer.js", "/viewer.js%00", "/.git/config", "/dist/viewer.js", "/ws", "*"}) {
    EXPECT_THAT(RawClient(echo.server->port()).get(path), StartsWith("HTTP/1.1 404 ")) << path;
  }
  EXPECT_THAT(RawClient(echo.server->port()).get("etc/passwd"), Not(StartsWith("HTTP/1.1 200")));
}

TEST(Server, HeadGivesNoBody) {
  const Echo echo;
  const auto answer = RawClient(echo.server->port()).get("/", "Host: localhost\r\n", "HEAD");
  EXPECT_THAT(answer, StartsWith("HTTP/1.1 200 "));
  EXPECT_THAT(answer, HasSubstr("Content-Length: "));
  EXPECT_EQ(answer.find("\r\n\r\n") + 4, answer.size());
}

TEST(Server, RefusesForeignHostsAndMethods) {
  const Echo echo;
  EXPECT_THAT(RawClient(echo.server->port()).get("/", "Host: evil.example\r\n"),
              StartsWith("HTTP/1.1 403 "));
  EXPECT_THAT(RawClient(echo.server->port()).get("/", "Host: localhost\r\n", "POST"),
              StartsWith("HTTP/1.1 405 "));
  EXPECT_EQ(echo.server->counters().refused, 1U);
}

TEST(Server, ClosesOnWhatIsNoHttp) {
  const Echo echo;
  for (const std::string& text :
       {std::string("\x16\x03\x01\x02", 4), std::string("GET\r\n\r\n"), std::string(20000, 'a'),
        std::string("GET / HTTP/1.1\r\nHost: ") + std::string(9000, 'h') + "\r\n\r\n"}) {
    RawClient client(echo.server->port());
    client.write(text + "\r\n\r\n");
    EXPECT_THAT(client.read_until("never"), Not(HasSubstr(" 200 ")));
  }
  EXPECT_THAT(RawClient(echo.server->port()).get("/"), StartsWith("HTTP/1.1 200 "));
}

TEST(Server, SpeaksTheProtocolThatIsOffered) {
  Echo echo;
  RawClient client(echo.server->port());
  const auto answer = client.upgrade();
  EXPECT_THAT(answer, StartsWith("HTTP/1.1 101 "));
  EXPECT_THAT(answer, HasSubstr("Sec-WebSocket-Accept: s3pPLMBiTxaQ9kYGzzhZRbK+xOo="));
  EXPECT_THAT(answer, HasSubstr("Sec-WebSocket-Protocol: scanfuse.viewer.v1"));
  client.send_frame("hello");
  EXPECT_EQ(client.next_text("hello"), "hello");
}

TEST(Server, RefusesWebsocketsOfForeignPages) {
  Echo echo;
  RawClient client(echo.server->port());
  EXPECT_THAT(client.upgrade("Host: localhost\r\nOrigin: http://evil.example\r\n"),
              StartsWith("HTTP/1.1 403 "));
  EXPECT_EQ(echo.opened, 0);
}

TEST(Server, ClosesAClientThatSaysTooMuchAtOnceAndServesTheOthers) {
  ServerOptions options;
  options.max_message_bytes = 1000;
  Echo echo(options);
  RawClient loud(echo.server->port()), quiet(echo.server->port());
  loud.upgrade();
  quiet.upgrade();
  loud.send_frame(std::string(1001, 'x'));
  EXPECT_EQ(loud.next_text("x"), "");
  quiet.send_frame(std::string(1000, 'x'));
  EXPECT_EQ(quiet.next_text("x").size(), 1000U);
}

TEST(Server, LetsInNoMoreClientsThanAllowed) {
  ServerOptions options;
  options.max_clients = 2;
  Echo echo(options);
  RawClient a(echo.server->port()), b(echo.server->port()), c(echo.server->port());
  EXPECT_THAT(a.upgrade(), StartsWith("HTTP/1.1 101 "));
  a.send_frame("in");
  a.next_text("in");
  EXPECT_THAT(b.upgrade(), StartsWith("HTTP/1.1 101 "));
  b.send_frame("in");
  b.next_text("in");
  EXPECT_THAT(c.upgrade(), StartsWith("HTTP/1.1 503 "));
}

TEST(Server, OutsideLoopbackATokenIsNeeded) {
  ServerOptions options;
  options.address = "0.0.0.0";
  const auto refused = Server::start(options, {});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("token"));
  options.token = "secret";
  Echo echo(options);
  EXPECT_THAT(RawClient(echo.server->port()).get("/"), StartsWith("HTTP/1.1 401 "));
  EXPECT_THAT(RawClient(echo.server->port()).get("/viewer.js"), StartsWith("HTTP/1.1 401 "));
  const auto answer = RawClient(echo.server->port()).get("/?token=secret", "Host: anything\r\n");
  EXPECT_THAT(answer, StartsWith("HTTP/1.1 200 "));
  EXPECT_THAT(answer, HasSubstr("Set-Cookie: scanfuse_token=secret; HttpOnly; SameSite=Strict"));
  EXPECT_THAT(RawClient(echo.server->port()).upgrade(), StartsWith("HTTP/1.1 401 "));
  RawClient client(echo.server->port());
  EXPECT_THAT(client.upgrade("Host: h\r\nCookie: scanfuse_token=secret\r\n"),
              StartsWith("HTTP/1.1 101 "));
}

TEST(Server, AnAddressThatIsNoneIsAnError) {
  ServerOptions options;
  options.address = "example.com";
  const auto refused = Server::start(options, {});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("--listen example.com"));
}

TEST(Server, TakesTheNextPortWhenItsOwnIsTaken) {
  const Echo first;
  ServerOptions options;
  options.port = first.server->port();
  options.next_free_port = false;
  const auto refused = Server::start(options, {});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("--port"));
  options.next_free_port = true;
  const auto second = Server::start(options, {});
  ASSERT_TRUE(second) << second.error().message;
  EXPECT_NE(second->port(), first.server->port());
}

/// A client that does not read makes messages wait: of one slot the newest is kept, and what has no
/// slot closes it once there is too much.
TEST(Server, NewestWinsForAClientThatDoesNotKeepUp) {
  Echo echo;
  RawClient client(echo.server->port());
  client.upgrade();
  while (echo.opened == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  for (int i = 0; i < 60; ++i) {
    echo.server->send(1, {std::string(1 << 20, 'x') + std::to_string(i), true, 7});
  }
  while (echo.server->counters().replaced < 10) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  echo.server->send(1, {"end", false, 0});
  std::string last;
  while (auto frame = client.next_frame()) {
    if (frame->opcode == 1) break;
    last = frame->payload.substr(1 << 20);
  }
  EXPECT_EQ(last, "59");
  EXPECT_EQ(echo.server->counters().dropped, 0U);
}

TEST(Server, DropsAClientWhoseQueueGrowsTooLong) {
  ServerOptions options;
  options.max_queue_bytes = 4 << 20;
  Echo echo(options);
  RawClient client(echo.server->port());
  client.upgrade();
  while (echo.opened == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  for (int i = 0; i < 40; ++i) echo.server->send(1, {std::string(1 << 20, 'x'), true, 0});
  while (echo.server->counters().dropped == 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  while (echo.closed == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(echo.server->counters().dropped, 1U);
}

}  // namespace
}  // namespace scanfuse::serve
