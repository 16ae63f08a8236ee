#include "scanfuse/io/session/rig_toml.hpp"

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>

#include "scanfuse/io/atomic_file.hpp"
#include "scanfuse/io/document/document.hpp"
#include "scanfuse/io/session/camera_table.hpp"
#include "scanfuse/io/text/numbers.hpp"

namespace scanfuse::io {
namespace {

constexpr std::size_t kLargestRig = std::size_t{1} << 20;
constexpr double kRoundingSlack = 1e-6;
constexpr double kFarthestRig_m = 1e6;
constexpr std::size_t kCount = Rig::kParameters;
using RowMajor3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
using RowMajorCovariance =
    Eigen::Matrix<double, Rig::kParameters, Rig::kParameters, Eigen::RowMajor>;

/// The order of the covariance, for readers of the file.
constexpr std::array<const char*, kCount> kParameterNames{"axis_direction_u_rad",
                                                          "axis_direction_v_rad",
                                                          "axis_point_u_m",
                                                          "axis_point_v_m",
                                                          "lidar_rotation_x_rad",
                                                          "lidar_rotation_y_rad",
                                                          "lidar_rotation_z_rad",
                                                          "lidar_x_m",
                                                          "lidar_y_m",
                                                          "lidar_z_m",
                                                          "range_bias_m",
                                                          "angle_scale"};

Result<Eigen::Vector3d> read_place(const DocumentTable& table, std::string_view key) {
  const auto numbers = table.numbers(key, 3);
  if (!numbers) return tl::unexpected(numbers.error());
  Eigen::Vector3d place(numbers->data());
  if (place.cwiseAbs().maxCoeff() <= kFarthestRig_m) return place;
  return table.wrong(key, fmt::format("{} is out of bounds; write metres", key));
}

Result<void> read_axis(const DocumentTable& table, Rig& rig) {
  if (auto known = table.only({"direction", "point_m"}); !known) return known;
  const auto direction = read_place(table, "direction");
  if (!direction) return tl::unexpected(direction.error());
  if (!(std::abs(direction->norm() - 1) <= kRoundingSlack)) {
    return table.wrong("direction", "direction needs a vector of length 1");
  }
  const auto point = read_place(table, "point_m");
  if (!point) return tl::unexpected(point.error());
  rig.axis_direction = direction->normalized();
  rig.axis_point_m = *point - rig.axis_direction * rig.axis_direction.dot(*point);
  return {};
}

Result<void> read_lidar_pose(const DocumentTable& table, Rig& rig) {
  if (auto known = table.only({"rotation", "position_m", "range_bias_m"}); !known) return known;
  const auto numbers = table.rows("rotation", 3, 3);
  if (!numbers) return tl::unexpected(numbers.error());
  const Eigen::Matrix3d rotation = Eigen::Map<const RowMajor3>(numbers->data());
  const Eigen::Matrix3d off = rotation * rotation.transpose() - Eigen::Matrix3d::Identity();
  if (!(off.cwiseAbs().maxCoeff() <= kRoundingSlack) || !(rotation.determinant() > 0)) {
    return table.wrong("rotation",
                       "rotation needs three orthogonal rows of length 1, right-handed");
  }
  rig.camera_from_lidar.rotation = Eigen::Quaterniond(rotation).normalized();
  const auto place = read_place(table, "position_m");
  if (!place) return tl::unexpected(place.error());
  rig.camera_from_lidar.translation_m = *place;
  const auto bias = table.number_or("range_bias_m", 0, -10, 10);
  if (!bias) return tl::unexpected(bias.error());
  rig.range_bias_m = *bias;
  return {};
}

Result<void> read_arc(const DocumentTable& table, Rig& rig) {
  if (auto known = table.only({"angle_scale", "first_deg", "last_deg"}); !known) return known;
  const auto scale = table.number_or("angle_scale", 1, -2, 2);
  if (!scale) return tl::unexpected(scale.error());
  const auto first = table.number_or("first_deg", 0, -36000, 36000);
  if (!first) return tl::unexpected(first.error());
  const auto last = table.number_or("last_deg", 0, -36000, 36000);
  if (!last) return tl::unexpected(last.error());
  rig.angle_scale = *scale;
  rig.first_turntable_rad = radians(*first);
  rig.last_turntable_rad = radians(*last);
  return {};
}

Result<void> read_covariance(const DocumentTable& table, Rig& rig) {
  if (auto known = table.only({"order", "matrix"}); !known) return known;
  const auto numbers = table.rows("matrix", kCount, kCount);
  if (!numbers) return tl::unexpected(numbers.error());
  const auto matrix = Eigen::Map<const RowMajorCovariance>(numbers->data());
  const double size = matrix.cwiseAbs().maxCoeff();
  if (!(size <= 1e12)) return table.wrong("matrix", "the covariance is out of bounds");
  if (!((matrix - matrix.transpose()).cwiseAbs().maxCoeff() <= kRoundingSlack * size)) {
    return table.wrong("matrix", "the covariance is not symmetric");
  }
  rig.covariance = 0.5 * (matrix + matrix.transpose());
  const Eigen::SelfAdjointEigenSolver<decltype(rig.covariance)> eigen(rig.covariance,
                                                                      Eigen::EigenvaluesOnly);
  if (eigen.eigenvalues()[0] >= -kRoundingSlack * size) return {};
  return table.wrong("matrix", "the covariance has a negative eigenvalue");
}

Result<RigFile> read_rig_root(const DocumentTable& root) {
  if (auto known = root.only({"axis", "lidar", "turntable", "covariance", "camera"}); !known) {
    return tl::unexpected(known.error());
  }
  RigFile file;
  const auto part = [&](const char* key, bool needed, const auto& read) -> Result<void> {
    const auto table = root.table(key);
    if (!table) return tl::unexpected(table.error());
    if (*table) return read(**table);
    if (!needed) return {};
    return root.wrong(
        key, fmt::format("a rig needs [{}]; `scanfuse calibrate turntable` writes it", key));
  };
  const auto read_seen_by = [&](const DocumentTable& table) -> Result<void> {
    const auto camera = read_camera(table);
    if (!camera) return tl::unexpected(camera.error());
    file.camera = *camera;
    return {};
  };
  for (const auto& done :
       {part("axis", true, [&](const auto& table) { return read_axis(table, file.rig); }),
        part("lidar", true, [&](const auto& table) { return read_lidar_pose(table, file.rig); }),
        part("turntable", false, [&](const auto& table) { return read_arc(table, file.rig); }),
        part("covariance", false,
             [&](const auto& table) { return read_covariance(table, file.rig); }),
        part("camera", false, read_seen_by)}) {
    if (!done) return tl::unexpected(done.error());
  }
  return file;
}

std::string vector_text(const Eigen::Vector3d& v) {
  return fmt::format("[{}, {}, {}]", print_number(v.x()), print_number(v.y()), print_number(v.z()));
}

std::string covariance_text(const Rig& rig) {
  std::string text =
      "[covariance]  # of small changes, in this order; zero: not estimated\norder = [";
  for (std::size_t k = 0; k < kCount; ++k) {
    text += fmt::format("{}\"{}\"", k > 0 ? ", " : "", kParameterNames[k]);
  }
  text += "]\nmatrix = [\n";
  for (int r = 0; r < Rig::kParameters; ++r) {
    text += "  [";
    for (int c = 0; c < Rig::kParameters; ++c) {
      text += fmt::format("{}{}", c > 0 ? ", " : "", print_number(rig.covariance(r, c)));
    }
    text += "],\n";
  }
  return text + "]\n";
}

}  // namespace

Result<RigFile> parse_rig(std::string_view text, const std::string& name) {
  const auto document = parse_toml_document(text, name);
  if (!document) return tl::unexpected(document.error());
  const auto root = DocumentTable::root(*document, name);
  if (!root) return tl::unexpected(root.error());
  return read_rig_root(*root);
}

Result<RigFile> read_rig(const std::filesystem::path& path) {
  const auto text = read_document_text(path, kLargestRig, "rig.toml");
  if (!text) return tl::unexpected(text.error());
  return parse_rig(*text, path.string());
}

std::string rig_text(const RigFile& file) {
  const Rig& rig = file.rig;
  const Eigen::Matrix3d r = rig.camera_from_lidar.rotation.toRotationMatrix();
  std::string text =
      "# A 2D lidar on a turntable, in the camera's frame: x right, y down, z "
      "forward; metres.\n";
  text += fmt::format("[axis]\ndirection = {}\npoint_m = {}  # nearest to the camera\n\n",
                      vector_text(rig.axis_direction), vector_text(rig.axis_point_m));
  text += fmt::format(
      "[lidar]  # at turntable angle 0\nrotation = [{}, {}, {}]  # camera from lidar, rows\n"
      "position_m = {}\nrange_bias_m = {}  # true range = measured range - bias\n\n",
      vector_text(r.row(0)), vector_text(r.row(1)), vector_text(r.row(2)),
      vector_text(rig.camera_from_lidar.translation_m), print_number(rig.range_bias_m));
  text += fmt::format(
      "[turntable]\nangle_scale = {}  # true turn = scale * commanded turn\n"
      "first_deg = {}  # the arc that was calibrated\nlast_deg = {}\n\n",
      print_number(rig.angle_scale), print_number(degrees(rig.first_turntable_rad)),
      print_number(degrees(rig.last_turntable_rad)));
  if (file.camera) text += "[camera]\n" + camera_text(*file.camera) + "\n";
  return text + covariance_text(rig);
}

Result<void> write_rig(const std::filesystem::path& path, const RigFile& file) {
  return write_whole(path, rig_text(file));
}

}  // namespace scanfuse::io
