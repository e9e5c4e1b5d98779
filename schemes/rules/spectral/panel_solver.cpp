// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/spectral/panel_solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "fdebench/schemes/rules/implicit/algebraic_slopes.hpp"

namespace fde {
namespace {

constexpr double rounding = std::numeric_limits<double>::epsilon();
constexpr int most_iterations = 20, most_sweeps = 5;

}  // namespace

PanelSolver::PanelSolver(const Problem& problem, const IntegratedRows& integrated_rows,
                         const PanelKernels& kernels, const Tolerance& accuracy)
    : problem_(problem),
      integrated_rows_(integrated_rows),
      kernels_(kernels),
      allowed_(accuracy),
      rhs_error_(problem.size()),
      mass_(Vec::Ones(integrated_rows.unknown_count())),
      last_end_values_(taylor_part(problem, 0.0) - integrated_rows.origin),
      jacobian_(problem, integrated_rows),
      matrix_(make_panel_matrix(problem, integrated_rows, kernels, jacobian_)),
      y_(problem.size()) {
  for (const auto& row : integrated_rows.rows) {
    if (row.is_algebraic()) mass_[row.unknown] = 0.0;
  }
}

double PanelSolver::integral_of_one(const PanelSystem& task, Eigen::Index row) const {
  const auto order = kernels_.order_of(row);
  if (order < 0) return 1.0;
  return task.units[order] / std::tgamma(integrated_rows_.rows[static_cast<std::size_t>(row)].order + 1.0);
}

Vec PanelSolver::with_multiplier_limits(const PanelSystem& task, Vec limits) const {
  if (!has_algebraic_rows(problem_)) return limits;
  const Matrix& sensitivities = *matrix_->sensitivities();
  for (Eigen::Index a = 0; a < limits.size(); ++a) {
    if (!integrated_rows_.rows[static_cast<std::size_t>(a)].is_algebraic()) continue;
    double unfelt = std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i < limits.size(); ++i) {
      const auto& row = integrated_rows_.rows[static_cast<std::size_t>(i)];
      const double slope = row.is_algebraic() ? 0.0 : sensitivities(row.unknown, a);
      if (slope > 0.0) unfelt = std::min(unfelt, limits[i] / (integral_of_one(task, i) * slope));
    }
    unfelt = std::min(unfelt, determined_error(a, limits));
    if (std::isfinite(unfelt)) limits[a] = std::max(limits[a], unfelt);
  }
  return limits;
}

double PanelSolver::determined_error(Eigen::Index algebraic, const Vec& limits) const {
  const auto slopes =
      matrix_->sensitivities()->row(integrated_rows_.rows[static_cast<std::size_t>(algebraic)].unknown);
  return (slopes.dot(limits) / slopes[algebraic]) - limits[algebraic];
}

// |y| at the points.
Matrix PanelSolver::sizes_of(const Matrix& rows) const {
  return (rows.rowwise() + integrated_rows_.origin.transpose()).cwiseAbs();
}

Vec PanelSolver::error_limits(const PanelSystem& task, const Matrix& rows) const {
  return with_multiplier_limits(task, row_limits(task, rows, unresolved(task)));
}

Vec PanelSolver::row_limits(const PanelSystem& task, const Matrix& rows, const Vec& unresolved) const {
  const Matrix sizes = sizes_of(rows);
  return allowed_.on_step(sizes.colwise().minCoeff().transpose(), sizes.colwise().maxCoeff().transpose(),
                          task.term_sizes, unresolved);
}

// The effects of rounding errors of f on the rows.
Vec PanelSolver::unresolved(const PanelSystem& task) const {
  Vec effects = Vec::Zero(integrated_rows_.row_count());
  if (!rhs_error_.is_measured()) return effects;
  for (Eigen::Index i = 0; i < effects.size(); ++i) {
    const auto& row = integrated_rows_.rows[static_cast<std::size_t>(i)];
    const auto rhs_index = integrated_rows_.rhs_indices[static_cast<std::size_t>(row.unknown)];
    if (!row.is_algebraic()) effects[i] = integral_of_one(task, i) * rhs_error_.rounding()[rhs_index];
  }
  return effects;
}

void PanelSolver::measure_rhs_error(Run& run, const PanelSystem& task, const Matrix& rows) {
  const Eigen::Index middle = rows.rows() / 2;
  const Vec y = rows.row(middle);
  if (!y.allFinite()) return;
  const auto f = [&](In at) -> const Vec& {
    y_ = at;
    return rhs(run, task.times[middle]);
  };
  rhs_error_.measure(f, y, error_limits(task, rows));
}

void PanelSolver::accept_panel(const PanelValues& solved) {
  allowed_.accept_step(sizes_of(solved.rows).colwise().maxCoeff().transpose());
  last_end_values_ = solved.rows.bottomRows<1>().transpose();
}

// The error limit of Newton's method: a small part of the error limit of a row and of the row itself, as
// other rows may be far more sensitive to it than its own limit allows for; the error limit itself where
// rounding errors of f determine it.
Vec PanelSolver::newton_limits(const PanelSystem& task, const Matrix& rows) const {
  constexpr double of_allowed = 0.01, of_row = 1e-6;
  const Vec largest = rows.cwiseAbs().colwise().maxCoeff(), allowed = error_limits(task, rows);
  const Vec without_noise = row_limits(task, rows, Vec::Zero(allowed.size()));
  const Vec with_noise = row_limits(task, rows, unresolved(task));
  const Vec noise = (with_noise.array() > without_noise.array()).select(with_noise, 0.0);
  return with_multiplier_limits(task, (of_allowed * allowed)
                                          .cwiseMin(of_row * largest)
                                          .cwiseMax(noise)
                                          .cwiseMax(2.0 * rounding * task.term_sizes));
}

void PanelSolver::integrate(const PanelSystem& task, PanelValues& values) {
  values.rows = task.known;
  const Matrix unknowns = values.unknowns;
  values.unknowns.setZero();
  apply_increment(task, unknowns, values.unknowns, values.rows);
}

bool PanelSolver::solve(Run& run, const PanelSystem& task, PanelValues& values) {
  auto& [unknowns, rows] = values;
  integrate(task, values);
  bool recompute = true;
  int sweeps = 0;
  double last = 0.0;
  for (int iteration = 1; iteration <= most_iterations; ++iteration) {
    if (!evaluate(run, task, rows)) return false;
    residual_ -= unknowns * mass_.asDiagonal();
    if (recompute && !linearise(run, task, rows)) {
      // A derivative may be infinite at the initial values. A fixed-point sweep moves the rows away from
      // there. It has converged where no row changes by more than rounding; a larger change may still change
      // other rows by far more.
      if (++sweeps > most_sweeps || mass_.minCoeff() == 0.0) return false;
      apply_increment(task, residual_, unknowns, rows);
      if (!rows.allFinite() || relative_increment(newton_limits(task, rows)) > 1.0) continue;
      if (accepts_unconverged_sweeps_ || relative_increment(rounding * task.term_sizes) <= 1.0) return true;
      had_unconverged_sweep_ = true;
      continue;
    }
    const Matrix increment = matrix_->solve(residual_);
    ++*run.cost().newton_iterations;
    apply_increment(task, increment, unknowns, rows);
    if (!rows.allFinite()) return false;
    const Vec limit = newton_limits(task, rows);
    const double now = relative_increment(limit);
    const double contraction = last > 0.0 ? now / last : 1.0;
    if (is_linear(problem_) ? !loses_digits(limit) || iteration > 1 : now * std::min(contraction, 1.0) <= 1.0)
      return true;
    if (now <= 1.0 && contraction > 0.5) return true;  // converged up to rounding
    if (iteration > 2 && contraction > 2.0) return false;
    recompute = contraction > 0.05;
    last = now;
  }
  return false;
}

bool PanelSolver::accept_unconverged_sweeps() {
  return had_unconverged_sweep_ && !std::exchange(accepts_unconverged_sweeps_, true);
}

// The largest change of a row by the last increment, in units of its limit; 0 for a row that stays 0, whose
// limit is 0.
double PanelSolver::relative_increment(const Vec& limit) const {
  const Eigen::ArrayXd moved = row_increments_.cwiseAbs().colwise().maxCoeff().transpose();
  return (moved > 0.0).select(moved / limit.array(), 0.0).maxCoeff();
}

// Whether rounding in the last increment may exceed the limit.
bool PanelSolver::loses_digits(const Vec& limit) const {
  const Vec lost = rounding * row_increments_.cwiseAbs().colwise().maxCoeff().transpose();
  return (lost.array() > limit.array()).any();
}

const Vec& PanelSolver::rhs(Run& run, double t) {
  return problem_.increments.is_given() ? run.rhs_of_increments(t, y_) : run.rhs(t, y_);
}

Vec PanelSolver::unknowns_from_rhs(Run& run, double t) {
  const Vec& f = rhs(run, t);
  return Vec::NullaryExpr(integrated_rows_.unknown_count(), [&](Eigen::Index k) {
    const auto row = integrated_rows_.rhs_indices[static_cast<std::size_t>(k)];
    return mass_[k] == 0.0 ? y_[row] : f[row];
  });
}

Vec PanelSolver::initial_unknowns(Run& run) {
  y_ = run.start() - integrated_rows_.origin;
  const Vec unknowns = unknowns_from_rhs(run, 0.0);
  return unknowns.allFinite() ? unknowns : Vec();
}

Vec PanelSolver::unknowns_at_first_point(Run& run, const PanelSystem& task) {
  y_ = task.known.row(0);
  for (Eigen::Index i = 0; i < y_.size(); ++i) {
    if (integrated_rows_.rows[static_cast<std::size_t>(i)].is_algebraic()) y_[i] = last_end_values_[i];
  }
  const Vec unknowns = unknowns_from_rhs(run, task.times[0]);
  return unknowns.array().isFinite().select(unknowns, 0.0);
}

Matrix PanelSolver::algebraic_slopes(Run& run, const PanelSystem& task, const Matrix& rows) {
  if (!has_algebraic_rows(problem_)) return {};
  return fde::algebraic_slopes(
      problem_, jacobian_.dense_at(run, task.times[0], rows.row(0).transpose(), task.term_sizes));
}

bool PanelSolver::has_growing_mode(Run& run, const PanelSystem& task, const Matrix& rows, double folds) {
  const double rate = folds / (task.times[rows.rows() - 1] - task.times[0]);
  if (rate >= growth_rate_bound_) return false;
  const Eigen::Index middle = rows.rows() / 2;
  if (jacobian_.grows_faster(run, task.times[middle], rows.row(middle).transpose(), task.term_sizes, rate))
    return true;
  if (is_linear(problem_)) growth_rate_bound_ = rate;
  return false;
}

bool PanelSolver::evaluate(Run& run, const PanelSystem& task, const Matrix& rows) {
  residual_.resize(rows.rows(), integrated_rows_.unknown_count());
  for (Eigen::Index j = 0; j < rows.rows(); ++j) {
    y_ = rows.row(j);
    left_domain_ = problem_.domain.margin && !problem_.domain.contains(task.times[j], values_at(rows, j));
    if (left_domain_) return false;
    const Vec& f = rhs(run, task.times[j]);
    for (Eigen::Index k = 0; k < residual_.cols(); ++k)
      residual_(j, k) = f[integrated_rows_.rhs_indices[static_cast<std::size_t>(k)]];
  }
  return residual_.allFinite();
}

bool PanelSolver::linearise(Run& run, const PanelSystem& task, const Matrix& rows) {
  if (factored_units_.size() == task.units.size() && factored_units_ == task.units) return true;
  if (!matrix_->factorise(run, task, rows)) return false;
  if (is_linear(problem_)) factored_units_ = task.units;
  return true;
}

void PanelSolver::apply_increment(const PanelSystem& task, const Matrix& increment, Matrix& unknowns,
                                  Matrix& rows) {
  unknowns += increment;
  row_increments_.resizeLike(rows);
  for (Eigen::Index i = 0; i < integrated_rows_.row_count(); ++i) {
    const Eigen::Index order = kernels_.order_of(i),
                       drive = integrated_rows_.rows[static_cast<std::size_t>(i)].unknown;
    if (order < 0) {
      row_increments_.col(i) = increment.col(drive);
    } else {
      row_increments_.col(i).noalias() =
          kernels_.own_integrals(order) * (task.units[order] * increment.col(drive));
    }
  }
  rows += row_increments_;
}

}  // namespace fde
