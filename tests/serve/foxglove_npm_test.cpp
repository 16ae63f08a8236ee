#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "scanfuse/serve/viewer.hpp"
#include "serve/simulated_source.hpp"

// Foxglove's own client package against our server: tests/npm/foxglove_socket.mjs.
namespace scanfuse::serve {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

TEST(FoxgloveNpm, ItsClientUnderstandsEveryChannel) {
  const fs::path npm = SCANFUSE_SOURCE "/tests/npm";
  if (!fs::exists(npm / "node_modules/@foxglove/ws-protocol")) {
    GTEST_SKIP() << "no npm packages (npm ci --prefix tests/npm): skipped";
  }
  const auto bench = scanfuse::testing::simulated_bench(60);
  ASSERT_TRUE(bench);
  Labels labels;
  ServerOptions options;
  options.port = 0;
  const auto viewer = Viewer::start(*bench, labels, options);
  ASSERT_TRUE(viewer) << viewer.error().message;
  for (const std::string protocol : {"foxglove.websocket.v1", "foxglove.sdk.v1"}) {
    const fs::path output = fs::path(::testing::TempDir()) / ("foxglove-" + protocol + ".json");
    const std::string command = "node '" + (npm / "foxglove_socket.mjs").string() +
                                "' ws://localhost:" + std::to_string(viewer->port()) + " " +
                                protocol + " > '" + output.string() + "'";
    const int code = std::system(command.c_str());
    std::stringstream text;
    text << std::ifstream(output).rdbuf();
    fs::remove(output);
    EXPECT_EQ(code, 0) << text.str();
    for (const auto* topic : {"/tf", "/scanfuse/markers", "/scanfuse/scene", "/diagnostics"}) {
      EXPECT_THAT(text.str(), HasSubstr(std::string("\"") + topic + "\":{"));
    }
    EXPECT_THAT(text.str(), HasSubstr("\"frames\":[\"ego\",")) << "transforms";
    EXPECT_THAT(text.str(), HasSubstr("\"statuses\":[\"scanfuse: reading\""));
  }
}

}  // namespace
}  // namespace scanfuse::serve
