// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/interpolants/interpolant.hpp"

#include <algorithm>

#include "fdebench/schemes/rules/implicit/newton_stepper.hpp"

namespace fde {

namespace {

class InterpolantStepper final : public NewtonStepper<InterpolantStepper> {
 public:
  InterpolantStepper(Interpolant& interpolant, OffStepProblem& stepped, const Grid& grid,
                     const Options& options)
      : NewtonStepper(stepped.problem(), grid, options),
        interpolant_(interpolant),
        stepped_(stepped),
        previous_(y_),
        known_derivative_(y_.size()),
        newest_(y_.size()),
        kappa_(y_.size()),
        known_(y_.size()) {
    record_history(interpolant_.bytes(), interpolant_.history());
  }

  void finish(Trajectory& path) {
    NewtonStepper::finish(path);
    *path.cost.rhs_calls *= stepped_.evaluations();
  }

  SolveStatus step() {
    if (n() > 1) interpolant_.push(n() - 1, y_ - previous_);
    previous_ = y_;
    stepped_.set_step(before(), previous_, h());
    interpolant_.derivative(n(), known_derivative_, newest_);
    kappa_ = newest_.cwiseInverse();
    known_ = previous_ - kappa_.cwiseProduct(known_derivative_);
    return solve(kappa_, known_);
  }

  void rule_state(Archive& archive) {
    NewtonStepper::rule_state(archive);
    archive(previous_, interpolant_);
  }

 private:
  Interpolant& interpolant_;
  OffStepProblem& stepped_;
  Vec previous_, known_derivative_, newest_, kappa_, known_;
};

}  // namespace

Trajectory solve_with_interpolant(Interpolant& interpolant, const Problem& problem, const Grid& grid,
                                  const Options& options) {
  OffStepProblem stepped(problem, interpolant.offsets());
  return integrate(InterpolantStepper(interpolant, stepped, grid, options));
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
