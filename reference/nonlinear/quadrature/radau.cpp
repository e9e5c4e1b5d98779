// SPDX-License-Identifier: MIT
#include "fdebench/reference/nonlinear/quadrature/radau.hpp"

#include <Eigen/LU>
#include <boost/math/special_functions/legendre.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace fde::reference {

namespace {

long double legendre_p(int degree, long double x) {
  return degree < 0 ? 0.0L : boost::math::legendre_p(degree, 2 * x - 1);
}

// int_0^x P_k(2u-1) du = (P_(k+1) - P_(k-1)) / (2 (2k+1)), and x for k = 0.
long double legendre_integral(int degree, long double x) {
  return degree == 0 ? x
                     : (legendre_p(degree + 1, x) - legendre_p(degree - 1, x)) /
                           static_cast<long double>(2 * (2 * degree + 1));
}

// The zeros are close enough to zeros of a Chebyshev polynomial for Newton's method to find each.
Stages radau_nodes(int count) {
  constexpr int iterations = 12;
  Stages nodes(count);
  for (int k = 0; k < count; ++k) {
    const long double angle = std::numbers::pi_v<long double> *
                              static_cast<long double>(2 * (count - k) - 2) /
                              static_cast<long double>(2 * count - 1);
    long double x = std::cos(angle);
    for (int i = 0; i < iterations && k + 1 < count; ++i) {
      const long double value = boost::math::legendre_p(count, x) - boost::math::legendre_p(count - 1, x);
      const long double slope =
          boost::math::legendre_p_prime(count, x) - boost::math::legendre_p_prime(count - 1, x);
      x -= value / slope;
    }
    nodes[k] = k + 1 == count ? 1.0L : (1 + x) / 2;
  }
  return nodes;
}

}  // namespace

RadauRule::RadauRule(int stages) {
  if (stages < 1 || stages > max_stages) {
    throw std::invalid_argument("Radau method: stages = " + std::to_string(stages) + ": must be in [1, " +
                                std::to_string(max_stages) + "]");
  }
  nodes = radau_nodes(stages);
  StageMatrix values(stages, stages), integrals(stages, stages), dense(stages + 1, stages + 1);
  for (int k = 0; k <= stages; ++k) {
    dense(0, k) = legendre_p(k, 0.0L);
    for (int i = 0; i < stages; ++i) {
      dense(i + 1, k) = legendre_p(k, nodes[i]);
      if (k < stages) {
        values(i, k) = legendre_p(k, nodes[i]);
        integrals(i, k) = legendre_integral(k, nodes[i]);
      }
    }
  }
  const StageMatrix coefficients = values.partialPivLu().inverse();
  integral = integrals * coefficients;
  at_nodes = coefficients.cast<double>();
  with_start = StageMatrix(dense.partialPivLu().inverse()).cast<double>();
}

}  // namespace fde::reference
