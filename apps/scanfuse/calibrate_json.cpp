#include "calibrate_json.hpp"

#include <nlohmann/json.hpp>

#include "scanfuse/calibrate/rig_error.hpp"

namespace scanfuse::app {
namespace {

nlohmann::json list(const Eigen::VectorXd& v) {
  return std::vector<double>(v.data(), v.data() + v.size());
}

nlohmann::json matrix(const calibrate::RigCovariance& m) {
  nlohmann::json rows = nlohmann::json::array();
  for (int r = 0; r < m.rows(); ++r) rows.push_back(list(m.row(r).transpose()));
  return rows;
}

nlohmann::json mean_max(const calibrate::MeanMax& value) {
  return {{"mean", value.mean}, {"max", value.max}};
}

nlohmann::json camera_json(const Camera& camera) {
  return {{"width_px", camera.width_px},
          {"height_px", camera.height_px},
          {"fx_px", camera.fx_px},
          {"fy_px", camera.fy_px},
          {"cx_px", camera.cx_px},
          {"cy_px", camera.cy_px},
          {"k1", camera.k1},
          {"k2", camera.k2},
          {"p1", camera.p1},
          {"p2", camera.p2},
          {"k3", camera.k3}};
}

}  // namespace

std::string reason_of(const calibrate::TurntableCalibration& calibration,
                      const pipeline::LoadedSession& session, std::size_t position) {
  if (calibration.positions[position].used) return "";
  for (const auto& left : session.left_out) {
    if (left.position == position) return left.reason;
  }
  return calibration.positions[position].reason;
}

nlohmann::json calibration_json(const calibrate::TurntableCalibration& calibration,
                                const pipeline::LoadedSession& session) {
  const Rig& rig = calibration.rig;
  nlohmann::json left_out = nlohmann::json::array(), positions = nlohmann::json::array();
  for (std::size_t k = 0; k < calibration.positions.size(); ++k) {
    const auto& position = calibration.positions[k];
    if (!position.used) {
      left_out.push_back({{"position", position.name},
                          {"turntable_deg", degrees(position.turntable_rad)},
                          {"reason", reason_of(calibration, session, k)}});
      continue;
    }
    positions.push_back({{"name", position.name},
                         {"turntable_deg", degrees(position.turntable_rad)},
                         {"turntable_correction_deg", degrees(position.turntable_correction_rad)},
                         {"stripe_px", position.stripe_px},
                         {"lidar_mm", {position.lidar_m[0] * 1e3, position.lidar_m[1] * 1e3}},
                         {"center_mm", position.centre_m * 1e3},
                         {"z_axis_deg", degrees(position.z_axis_rad)},
                         {"x_axis_deg", degrees(position.x_axis_rad)}});
  }
  const auto sigma = [&](int first, int count) {
    return std::sqrt(rig.covariance.diagonal().segment(first, count).sum());
  };
  const Eigen::Matrix3d turn = rig.camera_from_lidar.rotation.toRotationMatrix();
  return {{"method", scanfuse::detail::print(calibration.method)},
          {"axis",
           {{"direction", list(rig.axis_direction)},
            {"point_mm", list(rig.axis_point_m * 1e3)},
            {"direction_sigma_deg", degrees(sigma(0, 2))},
            {"point_sigma_mm", sigma(2, 2) * 1e3}}},
          {"center_mm", list(rig.camera_from_lidar.translation_m * 1e3)},
          {"center_sigma_mm", sigma(7, 3) * 1e3},
          {"x_axis", list(turn.col(0))},
          {"z_axis", list(turn.col(2))},
          {"range_bias_mm", rig.range_bias_m * 1e3},
          {"square_bias_mm", calibration.square_bias_m * 1e3},
          {"angle_scale", rig.angle_scale},
          {"arc_deg", {degrees(rig.first_turntable_rad), degrees(rig.last_turntable_rad)}},
          {"covariance", matrix(rig.covariance)},
          {"covariance_jackknife", matrix(calibration.covariance_jackknife)},
          {"positions_used", calibration.positions_used},
          {"positions_left_out", left_out},
          {"positions", positions},
          {"rms",
           {{"corner_px", calibration.rms.corner_px},
            {"stripe_px", calibration.rms.stripe_px},
            {"lidar_mm", calibration.rms.lidar_mm}}},
          {"table1",
           {{"center_mm", mean_max(calibration.table1.centre_mm)},
            {"z_axis_deg", mean_max(calibration.table1.z_axis_deg)},
            {"x_axis_deg", mean_max(calibration.table1.x_axis_deg)},
            {"meaning", "residuals against the samples that were fitted, not an accuracy"}}},
          {"chi2_per_dof", calibration.chi2_per_dof},
          {"line_chi2_per_dof", calibration.line_chi2_per_dof},
          {"converged", calibration.converged},
          {"iterations", calibration.iterations},
          {"warnings", calibration.warnings},
          {"camera", camera_json(session.features.camera)},
          {"seconds",
           {{"files", session.seconds_files},
            {"boards", session.seconds_boards},
            {"stripes", session.seconds_stripes}}}};
}

}  // namespace scanfuse::app
