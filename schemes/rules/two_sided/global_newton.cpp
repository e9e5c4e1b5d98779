// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/two_sided/global_newton.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace fde {
namespace {

constexpr int most_iterations = 50, most_halvings = 12;
constexpr double stagnation = 1e-10;

double largest(const Rows& y) { return y.cwiseAbs().maxCoeff(); }

class Newton {
 public:
  Newton(const GlobalEquations& equations, NewtonIncrements& increments, Run& run, GridFunction start)
      : equations_(equations),
        increments_(increments),
        run_(run),
        guess_(std::move(start)),
        residual_(equations.residual(run, guess_)) {}

  bool converges(double tolerance) {
    if (!std::isfinite(residual_.norm())) return false;
    double last = std::numeric_limits<double>::infinity();
    for (int iteration = 0; iteration < most_iterations && !run_.out_of_budget(); ++iteration) {
      const GridFunction increment = increments_.at(run_, guess_, residual_);
      ++*run_.cost().newton_iterations;
      const double now = largest(increment.y);
      if (!std::isfinite(now)) return false;
      const bool whole = advance(increment);
      const double size = largest(guess_.y);
      if (whole && (now <= tolerance * size || (now >= last / 2 && now <= stagnation * size))) return true;
      if (stuck_) return false;
      last = now;
    }
    return false;
  }

  NewtonResult end(bool converged) && { return {std::move(guess_), residual_.norm(), converged}; }

 private:
  // Adds the largest of the increment, its half, ... that decreases the residual. Returns whether it is the
  // whole increment.
  bool advance(const GridFunction& increment) {
    const double before = residual_.norm();
    // Smaller increments are rounding errors, and so are their effects on the residual.
    const bool small = largest(increment.y) <= stagnation * largest(guess_.y);
    double part = 1.0;
    for (int halving = 0; halving <= most_halvings; ++halving, part /= 2) {
      GridFunction trial{.y = guess_.y + part * increment.y,
                         .unknown = guess_.unknown + part * increment.unknown};
      Residual residual = equations_.residual(run_, trial);
      const double after = residual.norm();
      if (!(after < before || (small && std::isfinite(after)))) continue;
      guess_ = std::move(trial);
      residual_ = std::move(residual);
      return halving == 0;
    }
    stuck_ = true;
    return false;
  }

  const GlobalEquations& equations_;
  NewtonIncrements& increments_;
  Run& run_;
  GridFunction guess_;
  Residual residual_;
  bool stuck_ = false;
};

}  // namespace

NewtonResult solve_by_newton(const GlobalEquations& equations, NewtonIncrements& increments, Run& run,
                             double tolerance, GridFunction start) {
  Newton method(equations, increments, run, std::move(start));
  const bool converged = method.converges(tolerance);
  return std::move(method).end(converged);
}

}  // namespace fde
