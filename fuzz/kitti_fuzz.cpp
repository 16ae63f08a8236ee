#include <cmath>
#include <cstdlib>

#include "scanfuse/io/folder/stamps.hpp"
#include "scanfuse/io/kitti/camera.hpp"
#include "scanfuse/io/kitti/labels.hpp"
#include "scanfuse/io/kitti/open_kitti.hpp"
#include "scanfuse/io/kitti/oxts.hpp"

// A .bin file, an oxts packet, a stamp, labels and a calibration of the same bytes.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace scanfuse;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  Diagnostics diagnostics;
  if (const auto scan = io::read_kitti_bin(bytes, "fuzz.bin", diagnostics)) {
    for (const Return& r : scan->returns) {
      if (!std::isfinite(r.squared_range()) || r.layer < 0 || r.layer > 63) std::abort();
    }
  }
  if (const auto packet = io::parse_oxts(bytes)) {
    io::OxtsProjection projection;
    const Pose3 pose = projection.world_from_imu(*packet);
    if (!pose.translation_m.allFinite() || !pose.rotation.coeffs().allFinite()) std::abort();
  }
  (void)io::parse_stamp(bytes);
  const std::string text(bytes);
  const auto lines = [&] { return io::LineReader("fuzz", io::open_memory("fuzz", text)); };
  (void)io::laser_from_camera(lines(), diagnostics);
  if (const auto truth = io::read_kitti_labels(lines(), Pose3{}, diagnostics)) {
    for (const TruthFrame& frame : *truth) {
      for (const TruthObject& o : frame.objects) {
        if (!o.position_m.allFinite()) std::abort();
      }
    }
  }
  return 0;
}
