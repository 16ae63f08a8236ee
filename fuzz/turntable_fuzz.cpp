#include <cmath>
#include <cstdlib>
#include <string>
#include <string_view>

#include "scanfuse/io/cloud/cloud_file.hpp"
#include "scanfuse/io/session/features_json.hpp"
#include "scanfuse/io/session/rig_toml.hpp"
#include "scanfuse/io/session/scan_table.hpp"
#include "scanfuse/io/session/session_file.hpp"

// The bytes as every file of a turntable session: what is read is finite and within its bounds.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace scanfuse;
  const std::string text(reinterpret_cast<const char*>(data), size);
  if (const auto session = io::parse_session_file(text, "fuzz")) {
    for (const double angle : session->turntable_rad) {
      if (!std::isfinite(angle)) std::abort();
    }
    if (!io::parse_session_file(io::session_file_text(*session), "again") &&
        !session->camera_images && session->lidar.recording.empty()) {
      std::abort();
    }
  }
  if (const auto rig = io::parse_rig(text, "fuzz")) {
    if (!rig->rig.covariance.allFinite() || !rig->rig.axis_point_m.allFinite()) std::abort();
  }
  TurntableFeatures features;
  features.boards = {BoardSpec{1, 2, 0.02}, BoardSpec{2, 1, 0.02}};
  features.positions.resize(1);
  if (io::parse_features(text, "fuzz", features) && features.corners_px[0].size() != 2) {
    std::abort();
  }
  Diagnostics diagnostics;
  if (const auto scan = io::parse_scan_table(text, "fuzz", {}, diagnostics)) {
    for (std::size_t k = 1; k < scan->size(); ++k) {
      if (!((*scan)[k - 1].angle_rad <= (*scan)[k].angle_rad)) std::abort();
    }
  }
  if (const auto cloud = io::parse_cloud(text, "fuzz", diagnostics)) {
    const int profiles = static_cast<int>(cloud->profiles.size());
    for (const CloudPoint& point : cloud->points) {
      if (!point.position_m.allFinite() || point.profile >= profiles) std::abort();
    }
  }
  return 0;
}
