#pragma once

#include <array>

#include "problem/problem.hpp"

namespace fde {

// A polynomial on one step, in w = (t - start) / length: p0 + p1 w + p2 w^2 / 2.
using Polynomial = Eigen::Vector3d;

// A kernel t^(a-1)/Gamma(a) as decaying exponentials, at distances from the shortest step to twice the end.
class ExponentialKernel {
 public:
  ExponentialKernel(long double a, double shortest, double end, double tolerance);

  // So many exponentials, the slowest, make the kernel at distances from this length on. A multiple of lanes.
  [[nodiscard]] Eigen::Index needed(double length) const;

  // The integrals of w^(k-1) / (k-1)!, k = 1, 2, 3, over a step of this length, up to its end: length^a /
  // Gamma(a + k).
  [[nodiscard]] std::array<double, 3> near(double length) const;

  long double exponent;
  Vec nodes,
      coefficients;  // nodes increase; as many as make a multiple of lanes, the last with coefficient 0

 private:
  double gamma_;    // Gamma(a + 1)
  double fastest_;  // node * distance up to which the sum needs its nodes
};

// What a step of one length does to the exponentials of a kernel, x = nodes * length.
struct KernelStep {
  double length = 0.0;
  Eigen::Index count = 0;        // of the exponentials that the step needs
  Vec decay_minus_one{};         // exp(-x) - 1
  Matrix phi{};                  // phi_1, phi_2, phi_3 of x
  Vec weights{};                 // coefficients * exp(-x)
  std::array<double, 3> near{};  // ExponentialKernel::near
  Matrix revived{};              // states of the exponentials that the steps before did not need
};

// The past of functions that share one kernel, on steps of any length. Each exponential carries one integral
// a function, z(t) = int_0^t exp(-node (t - s)) u(s) ds, from step to step. Work and memory do not depend on
// the number of steps done. docs/history.md derives it.
//
// An exponential that decays to nothing within a step is dropped there. Where a shorter step needs it again,
// its integral over that one step is all there is of it: the kernel of anything older is within the tolerance
// without it.
class KernelIntegrals {
 public:
  explicit KernelIntegrals(ExponentialKernel kernel);

  [[nodiscard]] const ExponentialKernel& kernel() const { return kernel_; }

  // The number of a new function. All are added before their states are made, and these before the first
  // step.
  Eigen::Index add_function() { return functions_++; }
  void make_states();

  // The step of this length that may follow. Changes nothing here.
  void prepare(double length, KernelStep& step) const;

  // The integral of the kernel with the function up to the end of this step, on which it is this polynomial.
  [[nodiscard]] double integral(const KernelStep& step, Eigen::Index function,
                                const Polynomial& newest) const;

  // Where the function's polynomial goes before a step is taken.
  [[nodiscard]] auto polynomial(Eigen::Index function) { return polynomials_.col(function); }

  // Takes the step, as prepared after the last one.
  void advance(const KernelStep& step);

  [[nodiscard]] std::size_t bytes() const;

 private:
  [[nodiscard]] Eigen::Index needed(double length) const;
  [[nodiscard]] Matrix revived(Eigen::Index count) const;

  ExponentialKernel kernel_;
  Eigen::Index functions_ = 0;
  double length_ = 0.0;              // of the newest step
  Eigen::Index alive_;               // the exponentials whose states are those of now
  Matrix polynomials_;               // 3 x functions, on the newest step, times its length
  Matrix states_, carries_, input_;  // nodes x functions
};

}  // namespace fde
