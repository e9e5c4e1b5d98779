// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <map>
#include <vector>

#include "fdebench/reference/nonlinear/quadrature/gauss.hpp"
#include "fdebench/schemes/problem/problem.hpp"

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

// A Runge-Kutta step of size h for the memory variables phi_m' = -rates[m] phi_m + f. They are linear and are
// eliminated: with the Runge-Kutta matrix A and R_m = (1 + h rates[m] A)^-1, the values at the stages are
//   phi_m = R_m 1 phi_m(start) + h R_m A F,   F the values of f at the stages.
struct MemoryStep {
  MemoryStep(const DiffusiveKernels& kernels, const RadauRule& rule, double length);

  Matrix carry;               // (stage, m): R_m 1
  Matrix gain;                // (m, stage): the last row of h R_m A
  Vec decay;                  // 1 - (the last entry of R_m 1)
  std::vector<Matrix> local;  // one per kernel: lumped + sum_m weights[m] h R_m A
  Matrix integral;            // h A
};

// The memory variables of a problem. With order = integer + part, part in (0, 1],
//   v_i = initial value + sum_m weights[m] phi_im + lumped f_i    (part = 1: initial value + int f_i),
// and y_i = v_i, or y_i' = v_i for orders above 1. Algebraic rows have none.
class MemoryVariables {
 public:
  // Accurate for times from shortest * end on.
  MemoryVariables(const Problem& problem, RadauRule rule, double shortest);

  // The values of y at the stages of a step are history + weights F, one column per component, F the values
  // of f at the stages. For algebraic rows the weights are the identity.
  [[nodiscard]] Matrix history_term(double length);
  [[nodiscard]] Matrix weights(Eigen::Index component, double length);

  // Completes the step; rhs: F.
  void advance(double length, const Matrix& rhs);

  // y jumps at the end of the step.
  void add_jump(In jump);

 private:
  // A compensated sum of many small terms: its value and the rounding error so far.
  struct CompensatedSum {
    Vec value, compensation;
    void add(const Vec& terms);
  };
  struct State {
    Eigen::Index kernel;   // -1: part = 1
    bool algebraic;        // without memory
    bool order_above_one;  // y' = v
    double initial;        // of v; with the jumps of y where y = v
    CompensatedSum memory;
    CompensatedSum integral;  // y, where y' = v
  };

  const MemoryStep& step(double length);
  [[nodiscard]] Vec carried(const State& state, const MemoryStep& step) const;
  [[nodiscard]] static const Matrix& local(const State& state, const MemoryStep& step);

  RadauRule rule_;
  DiffusiveKernels kernels_;
  std::vector<State> states_;
  std::map<double, MemoryStep> steps_;  // by length
};

}  // namespace fde::reference
