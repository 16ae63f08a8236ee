#include "scanfuse/pipeline/turntable_session.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "io/temporary_folder.hpp"
#include "scanfuse/io/atomic_file.hpp"
#include "scanfuse/io/image.hpp"
#include "scanfuse/io/session/features_json.hpp"
#include "scanfuse/io/session/scan_table.hpp"
#include "scanfuse/simulate/turntable_features.hpp"

// From a session's files to features: what is read, sorted, left out and refused.
namespace scanfuse::pipeline {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

simulate::SimulatedTurntable few_positions(int positions) {
  simulate::TurntableWorldOptions world;
  world.positions = positions;
  world.step_rad = radians(5);
  world.beam_step_rad = radians(0.5);
  return simulate::simulate_turntable_features(world, {}, 3);
}

io::SessionFile session_file_of(const simulate::SimulatedTurntable& made) {
  io::SessionFile file;
  file.camera = made.features.camera;
  for (const BoardSpec& board : made.features.boards) file.boards.push_back({board, ""});
  for (const auto& position : made.features.positions) {
    file.turntable_rad.push_back(position.turntable_rad);
  }
  return file;
}

/// A folder with session.toml, scans and features.json.
class SessionOnDisk {
 public:
  explicit SessionOnDisk(simulate::SimulatedTurntable made) : made_(std::move(made)) {
    write_about(session_file_of(made_));
    for (std::size_t k = 0; k < made_.features.positions.size(); ++k) {
      EXPECT_TRUE(io::write_whole(path() / io::numbered_name("scan", k, ".csv"),
                                  io::scan_table_text(made_.features.positions[k].scan, {})));
    }
    EXPECT_TRUE(io::write_whole(path() / "features.json", io::features_text(made_.features)));
  }
  void write_about(const io::SessionFile& file) const {
    EXPECT_TRUE(io::write_whole(path() / "session.toml", io::session_file_text(file)));
  }
  [[nodiscard]] const fs::path& path() const { return folder_.path(); }
  [[nodiscard]] const simulate::SimulatedTurntable& made() const { return made_; }

 private:
  io_testing::TemporaryFolder folder_;
  simulate::SimulatedTurntable made_;
};

TEST(TurntableSession, FeaturesComeBackAsTheyWereWritten) {
  const SessionOnDisk session(few_positions(4));
  const auto loaded = load_turntable_session(session.path());
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_TRUE(loaded->left_out.empty());
  ASSERT_EQ(loaded->features.positions.size(), 4U);
  const auto& truth = session.made().features;
  EXPECT_EQ(loaded->features.corners_px[1].size(), truth.corners_px[1].size());
  EXPECT_NEAR((loaded->features.corners_px[1][7] - truth.corners_px[1][7]).norm(), 0, 1e-3);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(loaded->features.positions[k].stripe_px[0].size(),
              truth.positions[k].stripe_px[0].size());
    EXPECT_EQ(loaded->features.positions[k].scan.size(), truth.positions[k].scan.size());
  }
}

// Angles may come in any order; what belongs to a position goes with it.
TEST(TurntableSession, PositionsAreSortedByTheirAngle) {
  auto made = few_positions(4);
  std::swap(made.features.positions[0], made.features.positions[2]);
  const SessionOnDisk session(made);
  const auto loaded = load_turntable_session(session.path());
  ASSERT_TRUE(loaded) << loaded.error().message;
  EXPECT_FALSE(loaded->diagnostics.empty());
  const auto& positions = loaded->features.positions;
  for (std::size_t k = 0; k + 1 < positions.size(); ++k) {
    EXPECT_LT(positions[k].turntable_rad, positions[k + 1].turntable_rad);
  }
  EXPECT_EQ(positions[0].name, "position 2");
  EXPECT_NEAR((positions[0].stripe_px[0][0] - made.features.positions[2].stripe_px[0][0]).norm(), 0,
              1e-3);
}

TEST(TurntableSession, AMissingScanIsListed) {
  const SessionOnDisk session(few_positions(4));
  auto without = session.made().features;
  for (auto& position : without.positions) position.scan.clear();
  ASSERT_TRUE(io::write_whole(session.path() / "features.json", io::features_text(without)));
  fs::remove(session.path() / "scan_0001.csv");
  const auto loaded = load_turntable_session(session.path());
  ASSERT_TRUE(loaded) << loaded.error().message;
  ASSERT_EQ(loaded->left_out.size(), 1U);
  EXPECT_EQ(loaded->left_out[0].position, 1U);
  EXPECT_THAT(loaded->left_out[0].reason, HasSubstr("scan_0001.csv"));
}

TEST(TurntableSession, TwoPositionsAreRefused) {
  const SessionOnDisk session(few_positions(2));
  const auto loaded = load_turntable_session(session.path());
  ASSERT_FALSE(loaded);
  EXPECT_THAT(loaded.error().message, AllOf(HasSubstr("session.toml"), HasSubstr("at least 3")));
}

TEST(TurntableSession, WithoutBoardImageOrOfAnotherSizeItIsAnError) {
  const SessionOnDisk session(few_positions(3));
  fs::remove(session.path() / "features.json");
  const auto none = load_turntable_session(session.path());
  ASSERT_FALSE(none);
  EXPECT_THAT(none.error().message, HasSubstr("board*.png"));
  const Image small{40, 30, 1, std::vector<std::uint8_t>(1200, 100)};
  ASSERT_TRUE(io::write_png(session.path() / "board.png", small));
  const auto other = load_turntable_session(session.path());
  ASSERT_FALSE(other);
  EXPECT_THAT(other.error().message,
              AllOf(HasSubstr("board.png"), HasSubstr("40 x 30"), HasSubstr("1624 x 1234")));
  std::ofstream(session.path() / "board.png") << "not a picture";
  const auto broken = load_turntable_session(session.path());
  ASSERT_FALSE(broken);
  EXPECT_THAT(broken.error().message, HasSubstr("board.png"));
}

TEST(TurntableSession, FolderThatIsNotThereIsAnError) {
  const auto loaded = load_turntable_session("/no/such/session");
  ASSERT_FALSE(loaded);
  EXPECT_THAT(loaded.error().message, HasSubstr("/no/such/session"));
}

}  // namespace
}  // namespace scanfuse::pipeline
