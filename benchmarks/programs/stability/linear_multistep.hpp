// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/LU>
#include <cmath>

#include "fdebench/schemes/problem/problem.hpp"

namespace fde::bench {

// Fractional linear multistep rules of rate 2 (Lubich, SIAM J. Math. Anal. 17 (1986)) for one linear
// equation, for comparison only: not in the list of schemes.
//
//   y_n = T_n + h^g (sum_{0<=j<=n} w_(n-j) f_j + sum_{j=0,1,2} s_(n,j) f_j),   sum_k w_k zeta^k:
//     bdf2            ((3 - 4 zeta + zeta^2)/2)^(-g)
//     newton_gregory  (1 - zeta)^(-g) (1 - g/2 (1 - zeta))
//     trapezoidal     (2 (1-zeta)/(1+zeta))^(-g)
//
// The starting weights s make the rule exact where f is 1, t^g and t.
enum class Multistep { bdf2, newton_gregory, trapezoidal };

// The first `count` coefficients of (1 + a x + b x^2)^power.
inline Vec power_coefficients(double a, double b, double power, int count) {
  Vec c = Vec::Zero(count);
  c[0] = 1.0;
  for (int n = 1; n < count; ++n) {
    c[n] = a * (power - (n - 1.0)) * c[n - 1];
    if (n > 1) c[n] += b * (2.0 * power - (n - 2.0)) * c[n - 2];
    c[n] /= n;
  }
  return c;
}

// The weights w_0, ..., w_(count-1) for order g.
inline Vec multistep_weights(Multistep rule, double g, int count) {
  if (rule == Multistep::bdf2)
    return std::pow(1.5, -g) * power_coefficients(-4.0 / 3.0, 1.0 / 3.0, -g, count);
  const Vec euler = power_coefficients(-1.0, 0.0, -g, count);
  const Vec factor = rule == Multistep::trapezoidal
                         ? Vec(std::pow(2.0, -g) * power_coefficients(1.0, 0.0, g, count))
                         : Vec((Vec(count) << 1.0 - 0.5 * g, 0.5 * g, Vec::Zero(count - 2)).finished());
  Vec product(count);
  for (int n = 0; n < count; ++n) product[n] = euler.head(n + 1).dot(factor.head(n + 1).reverse());
  return product;
}

// y_n / y_0, n = 0 ... steps, on D^g y = lambda y with z = lambda h^g, 0 < g < 1.
inline Vec multistep_relaxation(Multistep rule, double g, double z, int steps) {
  const Vec w = multistep_weights(rule, g, steps + 1);
  const Eigen::Array3d powers{0.0, g, 1.0};
  Eigen::Matrix3d nodes;  // nodes(p, j) = j^powers[p]
  for (int p = 0; p < 3; ++p) nodes.row(p) << (p == 0 ? 1.0 : 0.0), 1.0, std::pow(2.0, powers[p]);
  const auto inverse = nodes.partialPivLu();
  const auto start_weights = [&](int n) {
    Eigen::Vector3d missing;
    for (int p = 0; p < 3; ++p) {
      const double q = powers[p];
      missing[p] = std::tgamma(q + 1.0) / std::tgamma(q + g + 1.0) * std::pow(n, q + g);
      for (int j = 0; j <= n; ++j) missing[p] -= w[n - j] * (j == 0 && p > 0 ? 0.0 : std::pow(j, q));
    }
    return Eigen::Vector3d(inverse.solve(missing));
  };
  Vec y = Vec::Ones(steps + 1);
  Eigen::Matrix2d both = Eigen::Matrix2d::Identity();  // the starting weights couple y_1 and y_2
  Eigen::Vector2d given;
  for (int n = 1; n <= 2; ++n) {
    const Eigen::Vector3d s = start_weights(n);
    given[n - 1] = 1.0 + z * (w[n] + s[0]);
    for (int j = 1; j <= 2; ++j) both(n - 1, j - 1) -= z * (s[j] + (j <= n ? w[n - j] : 0.0));
  }
  y.segment(1, 2) = both.partialPivLu().solve(given);
  for (int n = 3; n <= steps; ++n) {
    const double known = w.segment(1, n).reverse().dot(y.head(n)) + start_weights(n).dot(y.head(3));
    y[n] = (1.0 + z * known) / (1.0 - z * w[0]);
  }
  return y;
}

}  // namespace fde::bench
