// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <vector>

namespace fde::reference {

using ExtendedVec = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

// The kernel of fractional integration as a sum of decaying exponentials,
//   t^(g-1)/Gamma(g) = sin(pi g)/pi int_0^inf s^(-g) e^(-s t) ds = sum_m weights[m] e^(-rates[m] t) + local,
// by the trapezoidal rule in u, s = exp(u - exp(-u))/end (W. McLean, Exponential sum approximations for
// t^-beta, 2018): the integrand decays doubly exponentially for u -> -inf for every g. Exponentials faster
// than the last rate have no memory: they are local = lumped delta(t), lumped = sum of their weight / rate.
struct DiffusiveKernels {
  // Kernels for orders in (0, 1), with common rates, valid for shortest * end <= t <= end.
  DiffusiveKernels(const std::vector<double>& orders, double end, double shortest);

  struct Kernel {
    double order;
    Eigen::VectorXd weights;
    double lumped;
  };

  ExtendedVec rates;  // increasing
  std::vector<Kernel> kernels;
};

}  // namespace fde::reference
