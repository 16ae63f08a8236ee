#pragma once

#include <array>

#include "scanfuse/estimate/ctra.hpp"
#include "scanfuse/estimate/imm.hpp"

/// Motion models that share the six states of ctra.hpp, for an `Imm` to choose among.
namespace scanfuse::estimate {

enum class CtraKind {
  kConstantVelocity,  ///< a = 0, w = 0
  kConstantTurn,      ///< a = 0
  kTurnAndAcceleration
};

/// What a model holds at zero it passes on as N(0, onset^2): what the component may be when the
/// target starts to use it. With a variance of zero instead, every exchange between the models
/// would draw the estimate of a manoeuvre towards none.
struct CtraModel {
  CtraKind kind = CtraKind::kTurnAndAcceleration;
  CtraNoise noise;
  double onset_accel_m_per_s2 = 1.5;
  double onset_yaw_rate_rad_per_s = 0.3;
};

/// Moves a belief on by a model. `fade` as in ctra.hpp, for what the model does not hold.
[[nodiscard]] Gaussian<6> predict_ctra(const Gaussian<6>& x, double dt_s, const CtraModel& model,
                                       const Fade& fade = {});

/// Straight, turning, turning and accelerating: a set for road users, with noise as a careful
/// driver has it (not fitted to any recording).
[[nodiscard]] std::array<CtraModel, 3> road_user_models();

/// The IMM over three such models.
using CtraImm = Imm<6, 3>;

/// One prediction of it. `rates` as in `switching`.
void predict(CtraImm& imm, double dt_s, const std::array<CtraModel, 3>& models,
             const CtraImm::Switching& rates, const Fade& fade = {});

}  // namespace scanfuse::estimate
