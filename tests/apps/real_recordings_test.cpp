#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "io/temporary_folder.hpp"

/// The tool on recordings by others, as far as they lie beside the project.
namespace scanfuse {
namespace {

namespace fs = std::filesystem;
using scanfuse::io_testing::content_of;
using scanfuse::io_testing::TemporaryFolder;
using ::testing::HasSubstr;

const fs::path kData = SCANFUSE_SHARED_DATA;

struct RealRun {
  int code = -1;
  std::string out, err;
};

RealRun run_on_real(const TemporaryFolder& folder, const std::string& arguments) {
  const auto out = folder.path() / "stdout", err = folder.path() / "stderr";
  const std::string command = "timeout 100 " SCANFUSE_TOOL " --quiet " + arguments + " >" +
                              out.string() + " 2>" + err.string();
  const int status = std::system(command.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(out), content_of(err)};
}

bool tells_nan_or_inf(const std::string& text) {
  static const std::regex kOdd("(^|[^a-z_])[-+]?(nan|inf|infinity)([^a-z_]|$)",
                               std::regex::icase | std::regex::optimize);
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const bool may = line.find_first_of("nN") != std::string::npos;
    if (may && std::regex_search(line, kOdd)) return true;
  }
  return false;
}

/// `info` lists scans, `track` ends well and writes only numbers.
void expect_tracked(const fs::path& recording, const std::string& options = "") {
  SCOPED_TRACE(recording.string());
  const TemporaryFolder folder;
  const auto info = run_on_real(folder, "info --json " + recording.string());
  EXPECT_THAT(info.code, ::testing::AnyOf(0, 3)) << info.err;
  EXPECT_THAT(info.out, HasSubstr("\"topics\""));
  const auto csv = folder.path() / "t.csv", detections = folder.path() / "d.csv";
  const auto track = run_on_real(folder, "track " + recording.string() + " " + options + " -o " +
                                             csv.string() + " --detections " + detections.string());
  EXPECT_THAT(track.code, ::testing::AnyOf(0, 3)) << track.err;
  EXPECT_THAT(content_of(csv), HasSubstr("time_s,frame,track_id"));
  EXPECT_FALSE(tells_nan_or_inf(content_of(csv)));
  EXPECT_FALSE(tells_nan_or_inf(content_of(detections)));
}

/// Refused with exit code 2 and one line that holds `words`.
void expect_refused(const fs::path& recording, const std::string& words) {
  SCOPED_TRACE(recording.string());
  const TemporaryFolder folder;
  const auto track = run_on_real(
      folder, "track " + recording.string() + " -o " + (folder.path() / "t.csv").string());
  EXPECT_EQ(track.code, 2);
  EXPECT_THAT(track.err, HasSubstr(words));
  EXPECT_EQ(std::count(track.err.begin(), track.err.end(), '\n'), 1) << track.err;
  EXPECT_FALSE(fs::exists(folder.path() / "t.csv"));
}

/// Files below `folder` with this ending, in order; none where there is no shared data.
std::vector<fs::path> shared_files(const std::string& folder, const std::string& ending) {
  std::vector<fs::path> found;
  if (!fs::exists(kData / folder)) return found;
  for (const auto& entry : fs::recursive_directory_iterator(kData / folder)) {
    if (entry.is_regular_file() && entry.path().string().ends_with(ending)) {
      found.push_back(entry.path());
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

#define SKIP_WITHOUT_SHARED_DATA() \
  if (!fs::exists(kData)) GTEST_SKIP() << "no shared data: skipped"

TEST(RealRecordings, BagsOfModelCarsAreTracked) {
  SKIP_WITHOUT_SHARED_DATA();
  for (const auto& bag : shared_files("datmo", ".bag")) {
    expect_tracked(bag, "--ego-topic /ego_pose --mount -0.12,0,0 --preset vehicle-model");
  }
}

TEST(RealRecordings, BagsOfPeopleAreTracked) {
  SKIP_WITHOUT_SHARED_DATA();
  for (const auto& bag : shared_files("people", ".bag")) {
    expect_tracked(bag, "--preset road-users");
  }
  for (const auto& bag : shared_files("formats/obstacle_detector", ".bag")) expect_tracked(bag);
}

TEST(RealRecordings, EveryPackingOfALaserScanRecordingIsTracked) {
  SKIP_WITHOUT_SHARED_DATA();
  for (const auto& file : shared_files("formats/mcap_laserscan", ".mcap")) expect_tracked(file);
}

TEST(RealRecordings, CarmenLogsAreTracked) {
  SKIP_WITHOUT_SHARED_DATA();
  for (const auto& log : shared_files("formats/carmen_ple", ".log.gz")) expect_tracked(log);
}

TEST(RealRecordings, AZippedBagIsRefusedWithAWordOnUnzipping) {
  SKIP_WITHOUT_SHARED_DATA();
  for (const auto& zip : shared_files("people", ".zip")) expect_refused(zip, "unzip");
}

TEST(RealRecordings, RecordingsWithoutScansAreRefusedInWords) {
  SKIP_WITHOUT_SHARED_DATA();
  for (const char* ending : {".db3", ".mcap"}) {
    for (const auto& file : shared_files("formats/rosbag2", ending)) {
      expect_refused(file, "no scan in it");
    }
  }
  const auto vectors = shared_files("formats/mcap_conformance", ".mcap");
  for (std::size_t i = 0; i < vectors.size(); i += 20) expect_refused(vectors[i], "no scan in it");
}

TEST(RealRecordings, BagsOfTheOldFormatAreRefusedAndNewOnesTracked) {
  SKIP_WITHOUT_SHARED_DATA();
  for (const auto& bag : shared_files("formats/scan_tools", ".bag")) {
    const bool old = bag.string().find("splitter") != std::string::npos;
    old ? expect_refused(bag, ".bag") : expect_tracked(bag);
  }
}

/// The columns by name of each row of a table.
std::vector<std::map<std::string, std::string>> rows_of(const std::string& table) {
  std::vector<std::map<std::string, std::string>> rows;
  std::istringstream lines(table);
  std::vector<std::string> names;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream cells(line);
    std::vector<std::string> values;
    for (std::string cell; std::getline(cells, cell, ',');) values.push_back(cell);
    if (names.empty()) {
      names = values;
      continue;
    }
    auto& row = rows.emplace_back();
    for (std::size_t i = 0; i < std::min(names.size(), values.size()); ++i) {
      row[names[i]] = values[i];
    }
  }
  return rows;
}

/// Who stood for a labelled object, frame by frame; empty where nobody did. A track that stood for
/// it goes on doing so while within reach.
std::vector<std::string> who_stood_for(const std::string& object, double reach_m,
                                       const std::string& tracks, int first_frame) {
  std::map<int, std::map<std::string, std::pair<double, double>>> at;
  for (auto& row : rows_of(tracks)) {
    at[std::stoi(row["frame"])][row["track_id"]] = {std::stod(row["x_m"]), std::stod(row["y_m"])};
  }
  std::vector<std::string> who;
  std::string current;
  for (auto& row : rows_of(content_of(kData / "road/kitti_seq0000/truth_lidar_frame.csv"))) {
    if (row["object_id"] != object || std::stoi(row["frame"]) < first_frame) continue;
    const double x = std::stod(row["x_m"]), y = std::stod(row["y_m"]);
    std::map<double, std::string> near;
    for (const auto& [id, place] : at[std::stoi(row["frame"])]) {
      const double d = std::hypot(place.first - x, place.second - y);
      if (d < reach_m) near[id == current ? -1 : d] = id;
    }
    current = near.empty() ? "" : near.begin()->second;
    who.push_back(current);
  }
  return who;
}

void expect_one_identity(const std::string& object, double reach_m, const std::string& tracks,
                         int first_frame) {
  const auto who = who_stood_for(object, reach_m, tracks, first_frame);
  const std::set<std::string> different(who.begin(), who.end());
  EXPECT_EQ(different.size(), 1u) << "object " << object;
  EXPECT_EQ(different.count(""), 0u) << "object " << object;
}

std::string tracks_of_road(const std::string& recording) {
  const TemporaryFolder folder;
  const auto csv = folder.path() / "t.csv";
  const auto run = run_on_real(folder, "track " + recording + " --ego " +
                                           (kData / "road/kitti_seq0000/ego.csv").string() +
                                           " --frame ego --preset road-users -o " + csv.string());
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_FALSE(tells_nan_or_inf(content_of(csv)));
  return content_of(csv);
}

TEST(RealRoad, VansAndCyclistKeepTheirIdentitiesInTheFullCloud) {
  SKIP_WITHOUT_SHARED_DATA();
  const TemporaryFolder folder;
  const auto unpack = "/usr/bin/python3 " + (kData / "road/unpack_kitti_seq0000.py").string() +
                      " " + (kData / "road/kitti_seq0000/velodyne_int_mm.xz").string() + " " +
                      folder.path().string() + "/bin >/dev/null 2>&1";
  if (std::system(unpack.c_str()) != 0) GTEST_SKIP() << "no python3 with numpy: skipped";
  const auto tracks = tracks_of_road((folder.path() / "bin").string());
  expect_one_identity("0", 2.0, tracks, 0);
  expect_one_identity("1", 1.2, tracks, 0);
  expect_one_identity("3", 2.0, tracks, 6);  // its second frame in view: 36 returns in the first
}

/// Of the van behind parked cars one layer sees 6 to 18 returns in its first frames, with gaps: it
/// is held from frame 18 on.
TEST(RealRoad, VansAndCyclistKeepTheirIdentitiesInFourLayers) {
  SKIP_WITHOUT_SHARED_DATA();
  const auto tracks =
      tracks_of_road((kData / "road/kitti_seq0000/scans_4layer.points.csv.xz").string());
  expect_one_identity("0", 2.0, tracks, 0);
  expect_one_identity("1", 1.2, tracks, 0);
  expect_one_identity("3", 2.0, tracks, 18);
}

}  // namespace
}  // namespace scanfuse
