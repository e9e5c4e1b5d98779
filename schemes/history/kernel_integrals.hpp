// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "fdebench/schemes/problem/archive.hpp"
#include "fdebench/schemes/problem/problem.hpp"

namespace fde {

// The polynomial p0 + p1 w + p2 w^2 / 2 on one step, w = (t - start) / length.
using Polynomial = Eigen::Vector3d;

// A sum of exponentials for the kernel t^(a-1)/Gamma(a), t from the shortest step to 2 end, with the relative
// error `tolerance`.
class ExponentialKernel {
 public:
  ExponentialKernel(long double a, double shortest, double end, double tolerance);

  // The number of slowest exponentials that suffice for t >= length, a multiple of lanes.
  [[nodiscard]] Eigen::Index node_count(double length) const;

  // The integrals of the exact kernel times w^(k-1) / (k-1)!, k = 1, 2, 3, over the step that ends at the
  // evaluation time: length^a / Gamma(a + k), with power = length^a.
  [[nodiscard]] std::array<double, 3> newest_step_integrals(double power) const;

  long double exponent;
  // By increasing nodes; padded to a multiple of lanes with coefficients 0.
  Vec nodes, coefficients;

 private:
  double gamma_;    // Gamma(a + 1)
  double fastest_;  // the largest node times the shortest step
};

// The coefficients that advance the exponentials of a kernel over a step of one length; x = nodes * length.
struct KernelStep {
  double length = 0.0;
  Eigen::Index count = 0;                         // number of exponentials that the step needs
  Vec decay_minus_one{};                          // exp(-x) - 1
  Matrix phi{};                                   // phi_1, phi_2, phi_3 of x
  Vec weights{};                                  // coefficients * exp(-x)
  std::array<double, 3> newest_step_integrals{};  // ExponentialKernel::newest_step_integrals
  Matrix reactivated{};  // states of the exponentials that the previous step did not need
};

// Convolutions of functions u with one kernel, on steps of any length. For each exponential and each function
// the integral z(t) = int_0^t exp(-node (t - s)) u(s) ds is updated from step to step. Work a step and memory
// do not depend on the number of steps. Derivation: docs/history.md.
//
// An exponential that is negligible after a step is dropped. If a later, shorter step needs it again, its
// state is the integral over the newest step alone: for older values the kernel is within the tolerance
// without it.
class KernelIntegrals {
 public:
  explicit KernelIntegrals(ExponentialKernel kernel);

  [[nodiscard]] const ExponentialKernel& kernel() const { return kernel_; }

  // Adds a function and returns its index. Call begin() after the last add_function() and before the first
  // step.
  Eigen::Index add_function() { return functions_++; }
  void begin();

  // Computes the coefficients of a next step of this length. Does not change this object.
  void prepare(double length, KernelStep& step) const;
  // The same with the given power = length^a.
  void prepare(double length, double power, KernelStep& step) const;

  // int_0^t of the kernel times the function, t the end of this step, on which the function is `newest`.
  [[nodiscard]] double integral(const KernelStep& step, Eigen::Index function,
                                const Polynomial& newest) const;

  // The polynomial of a function on the next step, times the step length; set it before advance().
  [[nodiscard]] auto polynomial(Eigen::Index function) { return polynomials_.col(function); }

  // Advances over the step. Precondition: `step` was prepared after the previous advance().
  void advance(const KernelStep& step);

  [[nodiscard]] std::size_t bytes() const;
  void state(Archive& archive);

 private:
  [[nodiscard]] Eigen::Index node_count(double length) const;
  [[nodiscard]] Matrix reactivated(Eigen::Index count) const;

  ExponentialKernel kernel_;
  Eigen::Index functions_ = 0;
  double length_ = 0.0;      // of the newest step
  Eigen::Index active_;      // number of exponentials whose states are up to date
  Matrix polynomials_;       // 3 x functions: the polynomials on the newest step times its length
  Matrix states_, carries_;  // nodes x functions
};

}  // namespace fde
