// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/implicit/piecewise_constant_multipliers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "fdebench/schemes/history/history.hpp"
#include "fdebench/schemes/problem/multipliers.hpp"
#include "fdebench/schemes/rules/implicit/implicit_rule.hpp"

namespace fde {

namespace {

// The rows that may contain multipliers: by the matrix of a linear problem, otherwise all but algebraic ones.
std::vector<Eigen::Index> rows_with_multipliers(const Problem& problem,
                                                const std::vector<Eigen::Index>& multipliers) {
  const auto* linear = std::get_if<DenseLinearPart>(&problem.derivatives);
  std::vector<Eigen::Index> rows;
  for (Eigen::Index i = 0; i < problem.size(); ++i) {
    if (problem.is_algebraic(i)) continue;
    const auto in_row = [&](Eigen::Index j) { return linear->matrix(i, j) != 0.0; };
    if (linear == nullptr || std::ranges::any_of(multipliers, in_row)) rows.push_back(i);
  }
  return rows;
}

// The trapezoidal weights are for continuous functions. f is the sum of a continuous function and a function
// that is constant on each step:
//   f = c + p,  p_n = f(t_(n-1), y_(n-1), lambda_n) - c_(n-1),  c_n = f(t_n, y_n, lambda_n) - p_n,
// c_n at t_n and p_n on the step to it. The weight of c_n is kappa, the weight of p_n is (1 + g) kappa, g the
// order of the row: the step reads
//   y_n = known + kappa (f(t_n, y_n, lambda_n) + g p_n).
// Rows without multipliers have p = 0, and g = 0 leaves algebraic rows as they are.
class StepwiseMultipliers {
 public:
  StepwiseMultipliers(const Problem& problem, const std::vector<Eigen::Index>& multipliers, const Grid& grid,
                      const Options& options)
      : problem_(problem),
        multipliers_(multipliers),
        grid_(grid),
        taylor_(problem),
        constants_(problem, rows_with_multipliers(problem, multipliers), grid, options),
        orders_(orders_of(problem)),
        start_(Vec::Zero(problem.size())),
        rhs_(start_),
        continuous_(start_),
        slopes_(Matrix::Zero(problem.size(), std::ssize(multipliers))),
        f_(problem.size()) {}

  // The problem with f + g p in place of f, to be solved by solve_implicit with rule().
  [[nodiscard]] Problem stepped() {
    Problem stepped = problem_;
    stepped.rhs = [this](double t, In y, Out f) {
      problem_.rhs(t, y, f);
      f += orders_.cwiseProduct(rhs_at_start(y) - continuous_);
    };
    if (const auto* linear = std::get_if<DenseLinearPart>(&problem_.derivatives)) {
      Matrix matrix = linear->matrix;
      for (const auto j : multipliers_) matrix.col(j) += orders_.cwiseProduct(linear->matrix.col(j));
      stepped.derivatives = DenseLinearPart{matrix};
    } else if (has_jacobian(problem_)) {
      stepped.derivatives = DenseJacobian{[this](double t, In y, OutMatrix jacobian) {
        evaluate_jacobian(problem_, t, y, jacobian);
        for (std::size_t k = 0; k < multipliers_.size(); ++k)
          jacobian.col(multipliers_[k]) += orders_.cwiseProduct(slopes_.col(static_cast<Eigen::Index>(k)));
      }};
    }
    return stepped;
  }

  [[nodiscard]] ImplicitRule rule() {
    return {.tables = weight_tables(problem_, families::trapezoid),
            .known = [this](double t, In convolved, In /*previous*/, In kappa,
                            Out known) { begin_step(t, convolved, kappa, known); },
            .sample = [this](double t, In y, In /*previous*/, Out sample) { end_step(t, y, sample); },
            .recorded_result = [this](In y, Out recorded) { extrapolate_multipliers(y, recorded); },
            .state =
                [this](Archive& archive) {
                  archive.count(step_count_, 0, grid_.steps);
                  archive(constants_, t_, start_, rhs_, continuous_);
                }};
  }

  [[nodiscard]] std::size_t bytes() const { return constants_.bytes(); }

 private:
  void begin_step(double t, In convolved, In kappa, Out known) {
    taylor_.at(t, known);
    known += kappa.cwiseProduct(convolved);
    constants_.add_integrals(t, grid_.step(step_count_ + 1), known);
    if (has_jacobian(problem_) && !std::holds_alternative<DenseLinearPart>(problem_.derivatives))
      difference_in_multipliers();
  }

  // Accepts a step that ends with y at t, or the start. sample: c there.
  void end_step(double t, In y, Out sample) {
    Vec constant = Vec::Zero(y.size());
    if (t > 0.0) {
      constant = rhs_at_start(y) - continuous_;
      ++step_count_;
    }
    constants_.push(t, t > 0.0 ? grid_.step(step_count_) : 0.0, constant);
    t_ = t;
    start_ = y;
    rhs_ = rhs_at_start(y);
    continuous_ = rhs_ - constant;
    sample = continuous_;
  }

  // f at the start of the step, with the multipliers of y.
  const Vec& rhs_at_start(In y) {
    trial_ = start_;
    for (const auto j : multipliers_) trial_[j] = y[j];
    problem_.rhs(t_, trial_, f_);
    return f_;
  }

  // Difference quotients of f in each multiplier, at the start of the step. Exact where the multiplier enters
  // linearly.
  void difference_in_multipliers() {
    Vec moved = start_;
    for (std::size_t k = 0; k < multipliers_.size(); ++k) {
      const auto j = multipliers_[k];
      moved[j] += std::max(1.0, std::abs(start_[j]));
      slopes_.col(static_cast<Eigen::Index>(k)) = (rhs_at_start(moved) - rhs_) / (moved[j] - start_[j]);
      moved[j] = start_[j];
    }
  }

  void extrapolate_multipliers(In y, Out recorded) const {
    if (step_count_ == 0) return;
    const double length = grid_.step(step_count_ + 1), part = length / (length + grid_.step(step_count_));
    for (const auto j : multipliers_) recorded[j] += part * (y[j] - start_[j]);
  }

  const Problem& problem_;
  const std::vector<Eigen::Index>& multipliers_;
  Grid grid_;
  TaylorPart taylor_;
  PiecewiseConstantIntegrals constants_;
  Vec orders_;
  int step_count_ = 0;  // number of accepted steps
  double t_ = 0.0;      // where the next step starts
  Vec start_, rhs_;     // y and f there, with the multipliers of the step before
  Vec continuous_;      // c there
  Matrix slopes_;       // df/dlambda there, a column a multiplier
  Vec trial_, f_;
};

std::optional<std::string> unsupported_multiplier_rows_reason(const Problem& problem,
                                                              const std::vector<Eigen::Index>& multipliers) {
  const Vec start = taylor_part(problem, 0.0);
  Vec at_start(problem.size()), f(problem.size());
  problem.rhs(0.0, start, at_start);
  for (const auto j : multipliers) {
    Vec moved = start;
    moved[j] += std::max(1.0, std::abs(start[j]));
    problem.rhs(0.0, moved, f);
    for (Eigen::Index i = 0; i < problem.size(); ++i) {
      const double order = problem.component(i).order;
      if (order > 1.0 && f[i] != at_start[i]) {
        return fmt::format("takes no multiplier in a row of order above 1: component {} is in that of {}", j,
                           i);
      }
    }
  }
  return std::nullopt;
}

}  // namespace

Trajectory solve_product_trapezoidal(const Problem& problem, const Grid& grid, const Options& options) {
  if (!has_algebraic_rows(problem))
    return solve_implicit(problem, grid, options, integral_rule(problem, families::trapezoid));
  std::int64_t calls = 0;
  Problem counted = problem;
  counted.rhs = [&](double t, In y, Out f) {
    ++calls;
    problem.rhs(t, y, f);
  };
  const auto unknowns = multipliers(counted);
  Trajectory path;
  const auto step_counted = [&](const Problem& stepped, ImplicitRule rule) {
    rule.state = [&calls, own = std::move(rule.state)](Archive& archive) {
      archive(calls);
      if (own) own(archive);
    };
    path = solve_implicit(stepped, grid, options, rule);
  };
  if (unknowns.empty()) {
    step_counted(counted, integral_rule(counted, families::trapezoid));
  } else {
    StepwiseMultipliers steps(counted, unknowns, grid, options);
    step_counted(steps.stepped(), steps.rule());
    *path.cost.history_bytes += steps.bytes();
  }
  path.cost.rhs_calls = calls;
  return path;
}

std::optional<std::string> unsupported_multipliers_reason(const Problem& problem) {
  constexpr double slack = 0.1;
  const auto found = multipliers(problem);
  if (found.empty()) return std::nullopt;
  if (is_two_sided(problem))
    return fmt::format("takes multipliers in steps from the left only: component {} is one", found.front());
  if (auto reason = unsupported_multiplier_rows_reason(problem, found)) return reason;
  const double orders = multiplier_integration_order(problem);
  if (!(orders > 1.0 + slack)) return std::nullopt;  // NaN: not known; an unsolvable step ends the run
  return fmt::format(
      "takes constraints that are one integration away from their multipliers (index 2), not {:.3g}", orders);
}

PiecewiseConstantIntegrals::PiecewiseConstantIntegrals(const Problem& problem,
                                                       const std::vector<Eigen::Index>& components,
                                                       const Grid& grid, const Options& options)
    : totals_(problem.size()) {
  for (const auto i : components) {
    const double order = problem.component(i).order;
    if (order < 1.0) tables_.push_back({&families::l1, 1.0 - order});
    (order < 1.0 ? below_ : order > 1.0 ? above_ : whole_).push_back(i);
  }
  if (below_.empty()) return;
  buffer_.resize(std::ssize(below_));
  fractional_ = make_history(options.history, {tables_}, step_plan(grid), options.newton_tolerance);
}

void PiecewiseConstantIntegrals::push(double t, double length, In values) {
  for (const auto i : whole_) totals_.add(i, length * values[i]);
  for (const auto i : above_) {
    if (values[i] != 0.0) totals_.add(i, std::numeric_limits<double>::quiet_NaN());
  }
  if (!fractional_) return;
  buffer_ = length * values(below_);
  fractional_->push(t, buffer_);
}

void PiecewiseConstantIntegrals::add_integrals(double t, double length, Out sums) {
  for (const auto i : whole_) sums[i] += totals_[i];
  for (const auto i : above_) sums[i] += totals_[i];
  if (!fractional_) return;
  fractional_->convolve(t, 0, buffer_);
  for (Eigen::Index r = 0; r < buffer_.size(); ++r) {
    const auto at = static_cast<std::size_t>(r);
    sums[below_[at]] += buffer_[r] / step_factor(tables_[at], length);
  }
}

}  // namespace fde
