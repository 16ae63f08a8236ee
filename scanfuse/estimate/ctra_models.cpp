#include "scanfuse/estimate/ctra_models.hpp"

namespace scanfuse::estimate {
namespace {

/// Replaces what is believed of one component by N(0, sigma^2), independent of the rest.
void forget(Gaussian<6>& x, int component, double sigma) {
  x.mean(component) = 0;
  x.covariance.row(component).setZero();
  x.covariance.col(component).setZero();
  x.covariance(component, component) = sigma * sigma;
}

bool holds_accel(CtraKind kind) { return kind != CtraKind::kTurnAndAcceleration; }
bool holds_yaw_rate(CtraKind kind) { return kind == CtraKind::kConstantVelocity; }

}  // namespace

Gaussian<6> predict_ctra(const Gaussian<6>& x, double dt_s, const CtraModel& model,
                         const Fade& fade) {
  Gaussian<6> held = x;
  CtraNoise noise = model.noise;
  if (holds_accel(model.kind)) {
    forget(held, ctra::kAccel, 0);
    noise.accel_m_per_s2 = 0;
  }
  if (holds_yaw_rate(model.kind)) {
    forget(held, ctra::kYawRate, 0);
    noise.yaw_rate_rad_per_s = 0;
  }
  Gaussian<6> after = predict_ctra(held, dt_s, noise, fade);
  if (holds_accel(model.kind)) forget(after, ctra::kAccel, model.onset_accel_m_per_s2);
  if (holds_yaw_rate(model.kind)) forget(after, ctra::kYawRate, model.onset_yaw_rate_rad_per_s);
  return after;
}

std::array<CtraModel, 3> road_user_models() {
  CtraModel straight{CtraKind::kConstantVelocity, {}};
  straight.noise.heading_rad = 0.01;
  straight.noise.speed_m_per_s = 0.5;
  CtraModel turn{CtraKind::kConstantTurn, {}};
  turn.noise.speed_m_per_s = 0.5;
  turn.noise.yaw_rate_rad_per_s = 0.15;
  CtraModel both{CtraKind::kTurnAndAcceleration, {}};
  both.noise.accel_m_per_s2 = 1.5;
  both.noise.yaw_rate_rad_per_s = 0.15;
  return {straight, turn, both};
}

void predict(CtraImm& imm, double dt_s, const std::array<CtraModel, 3>& models,
             const CtraImm::Switching& rates, const Fade& fade) {
  imm.predict(switching<3>(rates, dt_s), [&](int model, const Gaussian<6>& x) {
    return predict_ctra(x, dt_s, models[model], fade);
  });
}

}  // namespace scanfuse::estimate
