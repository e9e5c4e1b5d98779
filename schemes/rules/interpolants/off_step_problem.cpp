// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/interpolants/off_step_problem.hpp"

#include <algorithm>

namespace fde {

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
