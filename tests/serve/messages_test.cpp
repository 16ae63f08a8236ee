#include "scanfuse/serve/messages.hpp"

#include <gtest/gtest.h>

#include <cstring>

namespace scanfuse::serve {
namespace {

template <class T>
T read_at(const std::string& bytes, std::size_t offset) {
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

// docs/viewer-protocol.md, kind 1; where each section stands is what the page relies on.
TEST(FrameMessage, EndsWithRaysThenEdgesThenTruth) {
  ShownFrame shown;
  shown.rays.push_back({{1, 2, 3}, {4, 5, 6}, 7, -1});
  shown.edges.push_back({{10, 20, 30}, {11, 22, 33}, RigPart::kLidar});
  auto bytes = frame_message(shown, RunName::kMain, 5, 0.5, {1, 2, 3});
  constexpr std::size_t kHead = 8 + 32 + 16 + 32 + 16;
  ASSERT_EQ(bytes.size(), kHead + 32 + 28);
  EXPECT_EQ(read_at<std::uint32_t>(bytes, 36), 1U) << "rays";
  EXPECT_EQ(read_at<std::uint32_t>(bytes, kHead - 4), 1U) << "edges";
  EXPECT_EQ(read_at<float>(bytes, kHead), 0) << "positions are told from the origin";
  EXPECT_EQ(read_at<std::int32_t>(bytes, kHead + 28), -1);
  EXPECT_EQ(read_at<float>(bytes, kHead + 32), 9);
  EXPECT_EQ(read_at<float>(bytes, kHead + 32 + 20), 30);
  EXPECT_EQ(read_at<std::uint32_t>(bytes, kHead + 32 + 24), 2U);
  TruthObject object;
  object.id = 42;
  append_truth(bytes, std::span(&object, 1), {1, 2, 3});
  EXPECT_EQ(read_at<double>(bytes, kHead + 60), 42);
}

}  // namespace
}  // namespace scanfuse::serve
