// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/interpolants/interpolant.hpp"

#include <algorithm>

#include "fdebench/schemes/rules/implicit/newton.hpp"
#include "fdebench/schemes/stepping/grid_jumps.hpp"

namespace fde {

Trajectory solve_with_interpolant(Interpolant& interpolant, const Problem& problem, const Grid& grid,
                                  const Options& options) {
  OffStepProblem stepped(problem, interpolant.offsets());
  Run run(stepped.problem(), options, grid.steps);
  NewtonSolver newton(stepped.problem(), options.newton_tolerance);
  const GridJumps jumps(problem, grid);
  run.cost().history_bytes = interpolant.bytes();
  run.cost().history = name(interpolant.history_kind());

  Vec y = run.start(), before = y, known_derivative(y.size()), newest(y.size()), kappa(y.size()),
      known(y.size());
  int n = 1;
  const StateArchiver state = [&](Archive& archive) {
    archive.count(n, 1, grid.steps);
    archive(y, newton, interpolant);
  };
  for (run.resume_from_checkpoint(state); n <= grid.steps; ++n) {
    run.offer_checkpoint(state);
    const double t = grid.time(n);
    before = y;
    stepped.set_step(grid.time(n - 1), before, grid.step(n));
    interpolant.derivative(n, known_derivative, newest);
    kappa = newest.cwiseInverse();
    known = before - kappa.cwiseProduct(known_derivative);
    if (const SolveStatus ending = newton.solve(run, {t, kappa, known, jumps.before(t)}, y);
        ending != SolveStatus::finished) {
      run.fail(ending, t);
      break;
    }
    if (!run.accept(t, newton.delivered(y))) break;
    if (n < grid.steps) interpolant.push(n, y - before);
  }
  *run.cost().rhs_calls *= stepped.evaluations();
  return run.finish();
}

SlopeHistory::SlopeHistory(const std::vector<WeightTable>& tables, const StepPlan& steps,
                           const Options& options)
    : steps_(steps),
      factors_(tables),
      history_(make_history(options.history, {tables}, steps, options.newton_tolerance)) {}

void SlopeHistory::push(double t, In sample) {
  history_->push(t, sample);
  newest_ = t;
}

// The sums of a history are scaled with the step factor of the step to t with variable steps, of the constant
// step otherwise.
void SlopeHistory::derivative(double t, Out result) {
  history_->convolve(t, 0, result);
  result.array() /= factors_.at(steps_.uniform ? steps_.min_step : t - newest_).array();
}

OffStepProblem::OffStepProblem(const Problem& problem, const Vec& offsets)
    : problem_(problem), offsets_(offsets), stepped_(problem) {
  for (Eigen::Index i = 0; i < offsets.size(); ++i) {
    auto found = std::ranges::find(groups_, offsets[i], &Group::offset);
    if (found == groups_.end()) found = groups_.insert(found, {offsets[i], Vec::Zero(offsets.size())});
    found->rows[i] = 1.0;
  }
  if ((offsets.array() == 1.0).all()) return;
  stepped_.rhs = [this](double, In y, Out f) { evaluate(y, f); };
  stepped_.derivatives = derivatives();
}

void OffStepProblem::set_step(double t, In y, double length) {
  before_ = t;
  start_ = y;
  length_ = length;
}

Derivatives OffStepProblem::derivatives() const {
  if (const auto* dense = std::get_if<DenseLinearPart>(&problem_.derivatives))
    return DenseLinearPart{offsets_.asDiagonal() * dense->matrix};
  if (const auto* part = std::get_if<SparseLinearPart>(&problem_.derivatives))
    return SparseLinearPart{offsets_.asDiagonal() * part->matrix};
  if (has_sparse_jacobian(problem_)) {
    return SparseJacobian{
        [this](double, In y, SparseMatrix& jacobian) { differentiate_sparse(y, jacobian); }};
  }
  if (!has_jacobian(problem_)) return NoDerivatives{};
  return DenseJacobian{[this](double, In y, OutMatrix jacobian) { differentiate(y, jacobian); }};
}

void OffStepProblem::evaluate(In y, Out f) const {
  Vec of_group(f.size());
  f.setZero();
  for (const auto& group : groups_) {
    problem_.rhs(time(group), between(group, y), of_group);
    f = (group.rows.array() != 0.0).select(of_group, f);
  }
}

void OffStepProblem::differentiate(In y, OutMatrix jacobian) const {
  Matrix of_group(jacobian.rows(), jacobian.cols());
  jacobian.setZero();
  for (const auto& group : groups_) {
    evaluate_jacobian(problem_, time(group), between(group, y), of_group);
    jacobian += (group.offset * group.rows).asDiagonal() * of_group;
  }
}

void OffStepProblem::differentiate_sparse(In y, SparseMatrix& jacobian) const {
  SparseMatrix of_group(jacobian.rows(), jacobian.cols()), sum(jacobian.rows(), jacobian.cols());
  for (const auto& group : groups_) {
    std::get<SparseJacobian>(problem_.derivatives).at(time(group), between(group, y), of_group);
    sum += (group.offset * group.rows).asDiagonal() * of_group;
  }
  jacobian = sum;
}

}  // namespace fde
