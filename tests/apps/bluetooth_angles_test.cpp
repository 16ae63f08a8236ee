#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "apps/tool.hpp"

// Bluetooth angles of arrival, by the commands of docs/passive.md.
namespace scanfuse::tool_testing {
namespace {

namespace fs = std::filesystem;

/// x and y by frame or scan: the columns `key`, `x_m`, `y_m` of a table.
std::map<std::string, std::pair<double, double>> places(const std::string& path,
                                                        const std::string& key) {
  std::map<std::string, std::pair<double, double>> result;
  std::ifstream file(path);
  std::string line, cell;
  std::vector<std::string> header;
  while (std::getline(file, line)) {
    std::vector<std::string> cells;
    for (std::istringstream row(line); std::getline(row, cell, ',');) cells.push_back(cell);
    if (header.empty()) {
      header = cells;
      continue;
    }
    std::map<std::string, std::string> named;
    for (std::size_t k = 0; k < std::min(header.size(), cells.size()); ++k) {
      named[header[k]] = cells[k];
    }
    result[named[key]] = {std::stod(named["x_m"]), std::stod(named["y_m"])};
  }
  return result;
}

TEST(BluetoothAngles, LocateAPersonToAMetre) {
  const fs::path archive = fs::path(SCANFUSE_SHARED_DATA) / "passive/ble_aoa/ble_aoa.tar.xz";
  if (!fs::exists(archive)) GTEST_SKIP() << "no shared data: skipped";
  const TemporaryFolder folder;
  const auto root = folder.path().string();
  if (std::system(("tar xJf " + archive.string() + " -C " + root).c_str()) != 0) {
    GTEST_SKIP() << "tar cannot unpack xz: skipped";
  }
  const auto data = root + "/Dataset/mobility/";
  const auto made =
      std::system((std::string(SCANFUSE_SOURCE) + "/tools/bluetooth_angles.py '" + data +
                   "beacons/use-case 2/beacons_mobility_use-case2_run1.txt' --truth '" + data +
                   "gt/use-case 2/gt_mobility_use-case2_run1.txt' -o " + root)
                      .c_str());
  ASSERT_EQ(made, 0);
  const auto ran = run_tool(folder, "associate " + root + "/bearings.csv --sensors " + root +
                                        "/sensors.toml -o " + root + "/fixes.csv");
  ASSERT_EQ(ran.code, 0) << ran.err;
  const auto truth = places(root + "/bearings.truth.csv", "frame");
  const auto fixes = places(root + "/fixes.csv", "scan");
  std::vector<double> errors;
  for (const auto& [scan, at] : truth) {
    const auto found = fixes.find(scan);
    if (found == fixes.end()) continue;
    errors.push_back(std::hypot(found->second.first - at.first, found->second.second - at.second));
  }
  ASSERT_GT(errors.size(), 0.95 * static_cast<double>(truth.size()));
  std::ranges::sort(errors);
  EXPECT_LT(errors[errors.size() / 2], 1.0);
}

}  // namespace
}  // namespace scanfuse::tool_testing
