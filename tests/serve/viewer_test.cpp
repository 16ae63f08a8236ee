#include "scanfuse/serve/viewer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "serve/raw_client.hpp"
#include "serve/simulated_source.hpp"

namespace scanfuse::serve {
namespace {

using scanfuse::testing::RawClient;
using ::testing::HasSubstr;

/// The whole of it, from a simulated world to bytes on a socket.
class ViewerTest : public ::testing::Test {
 protected:
  void SetUp() override {
    bench_ = scanfuse::testing::simulated_bench(30);
    ASSERT_TRUE(bench_);
    ServerOptions options;
    options.port = 0;
    auto viewer = Viewer::start(*bench_, labels_, options);
    ASSERT_TRUE(viewer) << viewer.error().message;
    viewer_ = std::make_unique<Viewer>(std::move(*viewer));
  }

  std::unique_ptr<Workbench> bench_;
  Labels labels_;
  std::unique_ptr<Viewer> viewer_;
};

TEST_F(ViewerTest, GreetsAndAnswers) {
  RawClient page(viewer_->port());
  page.upgrade();
  EXPECT_THAT(page.next_text("hello"), HasSubstr("\"title\":\"simulated\""));
  EXPECT_THAT(page.next_text("\"op\":\"status\""), HasSubstr("\"frames\":30"));
  page.send_frame(R"({"op":"index","run":0,"from":10})");
  EXPECT_EQ(page.next_binary(2).size(), 16U + 8 * 20);
  page.send_frame(R"({"op":"frame","run":0,"frame":29})");
  EXPECT_GT(page.next_binary(1).size(), 1000U);
  page.send_frame(R"({"op":"frame","run":0,"frame":30})");
  EXPECT_THAT(page.next_text("missing"), HasSubstr("\"frame\":30"));
  page.send_frame(R"({"op":"frame","run":1,"frame":1})");
  EXPECT_THAT(page.next_text("missing"), HasSubstr("\"run\":1"));
  page.send_frame(R"({"op":"trails","run":0,"frame":20,"length":10})");
  EXPECT_GT(page.next_binary(5).size(), 12U);
  page.send_frame("nonsense");
  EXPECT_THAT(page.next_text("problem"), HasSubstr("not a JSON object"));
}

TEST_F(ViewerTest, TunesAndExports) {
  RawClient page(viewer_->port());
  page.upgrade();
  page.send_frame(R"({"op":"options"})");
  EXPECT_THAT(page.next_text("\"op\":\"options\""), HasSubstr("\"section\":\"track\""));
  page.send_frame(R"({"op":"tune","from":3,"changes":["track.nothing=1"]})");
  EXPECT_THAT(page.next_text("problem"), HasSubstr("did you mean"));
  page.send_frame(R"({"op":"tune","from":3,"changes":["segment.method=euclidean"]})");
  page.next_text("\"trial_end\":30");
  page.send_frame(R"({"op":"export","run":1})");
  EXPECT_THAT(page.next_text("toml"), HasSubstr("method = \\\"euclidean\\\""));
  page.send_frame(R"({"op":"metrics"})");
  EXPECT_THAT(page.next_text("\"op\":\"metrics\""), HasSubstr("\"MOTA\""));
}

TEST_F(ViewerTest, SurvivesAFloodOfRequests) {
  RawClient page(viewer_->port());
  page.upgrade();
  for (int i = 0; i < 500; ++i) page.send_frame(R"({"op":"frame","run":0,"frame":1})");
  page.send_frame(R"({"op":"frame","run":0,"frame":999})");
  EXPECT_THAT(page.next_text("missing"), HasSubstr("999"));
}

TEST_F(ViewerTest, ShowsFoxgloveItsChannels) {
  RawClient studio(viewer_->port());
  EXPECT_THAT(studio.upgrade("Host: localhost\r\n", "/", "foxglove.websocket.v1"),
              HasSubstr("Sec-WebSocket-Protocol: foxglove.websocket.v1"));
  EXPECT_THAT(studio.next_text("serverInfo"), HasSubstr("\"capabilities\":[\"time\"]"));
  const auto channels = studio.next_text("advertise");
  for (const auto* type : {"sensor_msgs/msg/PointCloud2", "visualization_msgs/msg/MarkerArray",
                           "tf2_msgs/msg/TFMessage", "diagnostic_msgs/msg/DiagnosticArray"}) {
    EXPECT_THAT(channels, HasSubstr(type));
  }
  studio.send_frame(R"({"op":"subscribe","subscriptions":[{"id":70000,"channelId":1}]})");
  const auto data = studio.next_binary(1);
  ASSERT_GT(data.size(), 13U);
  std::uint32_t subscription = 0;
  std::memcpy(&subscription, data.data() + 1, 4);
  EXPECT_EQ(subscription, 70000U);
  studio.send_frame(R"({"op":"subscribe","subscriptions":[{"id":1,"channelId":999}]})");
  EXPECT_THAT(studio.next_text("status"), HasSubstr("no channel 999"));
  studio.send_frame(R"({"op":"subscribe","subscriptions":7})");
  EXPECT_THAT(studio.next_text("status"), HasSubstr("subscriptions"));
}

}  // namespace
}  // namespace scanfuse::serve
