#pragma once

namespace scanfuse::estimate {

/// The integrals that a motion along a circle is made of, for the angle th = w T turned in a step:
///
///   A_k = int_0^1 s^k cos(th s) ds        B_k = int_0^1 s^k sin(th s) ds        k = 0, 1, 2
///
/// so that int_0^T t^k cos(psi + w t) dt = T^(k+1) (cos psi A_k - sin psi B_k), likewise for sin.
/// In closed form A_0 = sin(th) / th, B_0 = (1 - cos th) / th, and so on with th^(k+1) below. As th
/// falls these quotients lose all digits; the textbook forms with 1/w and 1/w^2 [Schubert2008] are
/// wrong by 110 m at w = 1e-9 rad/s (15 m/s, 0.1 s). Below |th| = 1 the series
///
///   A_k = sum_n (-1)^n th^(2n) / ((2n)! (2n+k+1)),   B_k = sum_n (-1)^n th^(2n+1) / ((2n+1)!
///   (2n+k+2))
///
/// are summed instead, nine terms: the tenth is below 1e-17. Nothing special happens at th = 0.
struct TurnMoments {
  double A0, A1, A2, B0, B1, B2;
};

/// Errors stay below 1e-15 for |th| <= 3.
[[nodiscard]] TurnMoments turn_moments(double th);

}  // namespace scanfuse::estimate
