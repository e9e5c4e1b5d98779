// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/two_sided/global_newton.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "fdebench/schemes/solvers/gmres.hpp"

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

constexpr int least_coarse_steps = 64, most_coarse_steps = 256;
constexpr double solved = 1e-6;  // largest relative residual of an accepted increment

}  // namespace

NewtonResult solve_by_newton(const GlobalEquations& equations, NewtonIncrements& increments, Run& run,
                             double tolerance, GridFunction start) {
  Newton method(equations, increments, run, std::move(start));
  const bool converged = method.converges(tolerance);
  return std::move(method).end(converged);
}

CondensedSystem::CondensedSystem(const Linearisation& linearisation)
    : linearisation_(linearisation),
      equations_(linearisation.equations()),
      right_value_count_(equations_.left().empty()
                             ? 0
                             : static_cast<Eigen::Index>(equations_.right().rows().size()) *
                                   equations_.times()),
      scale_(std::sqrt(static_cast<double>(equations_.times()))) {}

GridFunction CondensedSystem::solution(const Residual& residual) const {
  Rows y = Rows::Zero(residual.rows.rows(), residual.rows.cols());
  Vec unknown = Vec::Zero(equations_.unknown_count());
  linearisation_.forward_backward_sweep(residual.rows, y);
  const Vec b = unknowns(y, -residual.conditions - linearisation_.conditions(y));
  if (b.size() > 0) {
    const Vec z =
        gmres([this](const Vec& x) { return applied(x); }, b, linear_tolerance, max_krylov_vectors(b.size()));
    unknown = z.tail(unknown.size()) / scale_;
    Rows given = residual.rows;
    equations_.add_unknown(unknown, given);
    y = right_part(z);
    linearisation_.forward_backward_sweep(given, y);
  }
  return {.y = std::move(y), .unknown = std::move(unknown)};
}

Vec CondensedSystem::applied(const Vec& z) const {
  Rows y = right_part(z), given = Rows::Zero(y.rows(), y.cols());
  equations_.add_unknown(z.tail(equations_.unknown_count()) / scale_, given);
  linearisation_.forward_backward_sweep(given, y);
  Vec result = unknowns(y, linearisation_.conditions(y));
  result.head(right_value_count_) = z.head(right_value_count_) - result.head(right_value_count_);
  return result;
}

Vec CondensedSystem::unknowns(const Rows& y, In conditions) const {
  Vec z(right_value_count_ + conditions.size());
  if (right_value_count_ > 0)
    z.head(right_value_count_) = y(equations_.right().rows(), Eigen::all).reshaped();
  z.tail(conditions.size()) = scale_ * conditions;
  return z;
}

Rows CondensedSystem::right_part(const Vec& z) const {
  Rows y = Rows::Zero(equations_.problem().size(), equations_.times());
  if (right_value_count_ > 0) {
    const auto& rows = equations_.right().rows();
    y(rows, Eigen::all) =
        z.head(right_value_count_).reshaped(static_cast<Eigen::Index>(rows.size()), y.cols());
  }
  return y;
}

std::size_t CondensedSystem::bytes() const {
  const auto length = right_value_count_ + equations_.unknown_count();
  return length > 0 ? sizeof(double) * static_cast<std::size_t>(length * max_krylov_vectors(length)) : 0;
}

NewtonIncrements::NewtonIncrements(const GlobalEquations& equations, First first)
    : equations_(equations),
      linearisation_(equations),
      condensed_(linearisation_),
      coarse_steps_(least_coarse_steps),
      two_grid_(first == First::condensed ? nullptr
                                          : std::make_unique<TwoGridSolver>(equations, coarse_steps_)) {}

GridFunction NewtonIncrements::at(Run& run, const GridFunction& guess, const Residual& residual) {
  linearisation_.update(run, guess, residual);
  if (!two_grid_) {
    GridFunction increment = condensed_.solution(residual);
    if (relative_residual(increment, residual) <= solved) return increment;
    two_grid_ = std::make_unique<TwoGridSolver>(equations_, coarse_steps_);
  }
  while (true) {
    two_grid_->update(run, guess);
    GridFunction increment = two_grid_->solution(linearisation_, residual);
    if (relative_residual(increment, residual) <= solved || coarse_steps_ >= most_coarse_steps ||
        coarse_steps_ + 1 >= equations_.times())
      return increment;
    coarse_steps_ *= 2;
    two_grid_ = std::make_unique<TwoGridSolver>(equations_, coarse_steps_);
  }
}

double NewtonIncrements::relative_residual(const GridFunction& increment, const Residual& residual) const {
  const auto done = linearisation_.left_hand_sides(increment);
  const Residual left{
      .rows = residual.rows - done.rows, .conditions = residual.conditions + done.conditions, .f = {}};
  const double of = residual.norm();
  return of > 0.0 ? left.norm() / of : 0.0;
}

std::size_t NewtonIncrements::bytes() const {
  return linearisation_.bytes() + condensed_.bytes() + (two_grid_ ? two_grid_->bytes() : 0);
}

}  // namespace fde
