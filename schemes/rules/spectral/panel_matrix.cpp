// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/spectral/panel_matrix.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <utility>
#include <vector>

#include "fdebench/schemes/rules/implicit/difference_jacobian.hpp"
#include "fdebench/schemes/rules/spectral/mode_count.hpp"
#include "fdebench/schemes/solvers/dense_factors.hpp"
#include "fdebench/schemes/solvers/gmres.hpp"
#include "fdebench/schemes/solvers/sylvester_factors.hpp"

namespace fde {
namespace {

// Each point with its own Jacobian; unknowns of all points, one unknown after the other.
class DensePanelMatrix final : public PanelMatrix {
 public:
  DensePanelMatrix(const IntegratedRows& integrated_rows, const PanelKernels& kernels,
                   PanelJacobian& jacobian)
      : integrated_rows_(integrated_rows),
        kernels_(kernels),
        jacobian_(jacobian),
        sensitivities_(Matrix::Zero(integrated_rows.unknown_count(), integrated_rows.row_count())) {}

  bool factorise(Run& run, const PanelSystem& task, const Matrix& rows) override {
    const Eigen::Index points = rows.rows(), unknowns = integrated_rows_.unknown_count();
    matrix_.setZero(points * unknowns, points * unknowns);
    sensitivities_.setZero();
    for (const auto& row : integrated_rows_.rows) {
      if (!row.is_algebraic()) matrix_.diagonal().segment(row.unknown * points, points).setOnes();
    }
    for (Eigen::Index j = 0; j < points; ++j)
      subtract_at(j, task, jacobian_.dense_at(run, task.times[j], rows.row(j).transpose(), task.term_sizes));
    if (!matrix_.allFinite()) return false;
    factors_.compute(matrix_);
    return true;
  }

  [[nodiscard]] Matrix solve(const Matrix& residual) const override {
    return factors_.solve(residual.reshaped()).reshaped(residual.rows(), residual.cols());
  }
  [[nodiscard]] const Matrix* sensitivities() const override { return &sensitivities_; }

 private:
  // J_j (I d)_j.
  void subtract_at(Eigen::Index j, const PanelSystem& task, const Matrix& jacobian) {
    const Eigen::Index points = task.times.size();
    for (Eigen::Index k = 0; k < integrated_rows_.unknown_count(); ++k) {
      const auto slopes = jacobian.row(integrated_rows_.rhs_indices[static_cast<std::size_t>(k)]);
      sensitivities_.row(k) = sensitivities_.row(k).cwiseMax(slopes.cwiseAbs());
      for (Eigen::Index i = 0; i < integrated_rows_.row_count(); ++i) {
        if (slopes[i] == 0.0) continue;
        const Eigen::Index order = kernels_.order_of(i),
                           drive = integrated_rows_.rows[static_cast<std::size_t>(i)].unknown;
        auto line = matrix_.row(k * points + j).segment(drive * points, points);
        if (order < 0) {
          line[j] -= slopes[i];
        } else {
          line -= slopes[i] * task.units[order] * kernels_.own_integrals(order).row(j);
        }
      }
    }
  }

  const IntegratedRows& integrated_rows_;
  const PanelKernels& kernels_;
  PanelJacobian& jacobian_;
  Matrix matrix_, sensitivities_;
  Eigen::PartialPivLU<Matrix> factors_;
};

// With one order the matrix is d - J d K^T for a constant J, K the integrals of the order. J at the middle
// point solves linear problems, and is the preconditioner of GMRES for the J_j of all points.
class OneOrderPanelMatrix final : public PanelMatrix {
 public:
  OneOrderPanelMatrix(const Problem& problem, const PanelKernels& kernels, PanelJacobian& jacobian)
      : is_linear_(is_linear(problem)), integrals_(kernels.own_integrals(0)), jacobian_(jacobian) {}

  bool factorise(Run& run, const PanelSystem& task, const Matrix& rows) override {
    const Eigen::Index middle = rows.rows() / 2;
    unit_ = task.units[0];
    jacobians_.clear();
    for (Eigen::Index j = 0; j < rows.rows(); ++j) {
      if (is_linear_ && j != middle) continue;
      jacobians_.push_back(jacobian_.sparse_at(run, task.times[j], rows.row(j).transpose(), task.term_sizes));
      if (!jacobians_.back().coeffs().allFinite()) return false;
    }
    middle_ = jacobians_[is_linear_ ? 0 : static_cast<std::size_t>(middle)];
    return is_linear_ ? factors_.factorise(middle_, integrals_, unit_)
                      : factors_.factorise(middle_, integrals_, unit_, accuracy / 10.0);
  }

  [[nodiscard]] Matrix solve(const Matrix& residual) const override {
    constexpr Eigen::Index most_vectors = 30;
    Vec increment = residual.transpose().reshaped();
    factors_.solve(increment);
    const Eigen::Index points = residual.rows(), unknowns = residual.cols();
    if (!is_linear_) {
      const auto apply = [&](const Vec& d) {
        const Matrix integrals = unit_ * (d.reshaped(unknowns, points) * integrals_.transpose());
        Vec rest = d;
        auto of_points = rest.reshaped(unknowns, points);
        for (Eigen::Index j = 0; j < points; ++j)
          of_points.col(j) -= jacobians_[static_cast<std::size_t>(j)] * integrals.col(j);
        factors_.solve(rest);
        return rest;
      };
      increment = gmres(apply, increment, accuracy, most_vectors);
    }
    return increment.reshaped(unknowns, points).transpose();
  }
  [[nodiscard]] std::string_view solver() const override { return factors_.method(); }

 private:
  static constexpr double accuracy = 1e-6;  // of GMRES

  bool is_linear_;
  const Matrix& integrals_;
  double unit_ = 1.0;
  PanelJacobian& jacobian_;
  std::vector<SparseMatrix> jacobians_;  // one a point, or one
  SparseMatrix middle_;
  SylvesterFactors factors_;
};

}  // namespace

PanelJacobian::PanelJacobian(const Problem& problem, const IntegratedRows& integrated_rows)
    : problem_(problem), origin_(integrated_rows.origin), has_one_order_(integrated_rows.have_one_order()) {}

bool PanelJacobian::is_sparse() const { return has_sparse_jacobian(problem_); }

const Matrix& PanelJacobian::dense_at(Run& run, double t, In z, In sizes) {
  dense_.resize(problem_.size(), problem_.size());
  if (problem_.increments.is_given()) {
    problem_.increments.jacobian(t, z, dense_);
  } else if (!evaluate_jacobian(problem_, t, z, dense_)) {
    f_ = run.rhs(t, z);
    difference_jacobian_of_rhs(run, problem_, t, z, f_, sizes, dense_);
  }
  return dense_;
}

SparseMatrix PanelJacobian::sparse_at(Run& run, double t, In z, In sizes) {
  if (!is_sparse()) return dense_at(run, t, z, sizes).sparseView();
  SparseMatrix buffer;
  return sparse_jacobian_at(problem_, t, origin_ + z, buffer);
}

bool PanelJacobian::grows_faster(Run& run, double t, In z, In sizes, double rate) {
  if (has_one_order_) {
    const SparseMatrix jacobian = sparse_at(run, t, z, sizes);
    return !jacobian.coeffs().allFinite() || fde::grows_faster(jacobian, problem_.component(0).order, rate);
  }
  const Matrix& jacobian = dense_at(run, t, z, sizes);
  return !jacobian.allFinite() || fde::grows_faster(jacobian, orders_of(problem_), rate);
}

std::unique_ptr<PanelMatrix> make_panel_matrix(const Problem& problem, const IntegratedRows& integrated_rows,
                                               const PanelKernels& kernels, PanelJacobian& jacobian) {
  // Rows of the dense matrix from which on it takes longer, measured.
  const Eigen::Index few = is_linear(problem) ? 60 : 100;
  const Eigen::Index dense_rows = problem.size() * kernels.own_integrals(0).rows();
  if (jacobian.is_sparse() || (jacobian.has_one_order() && dense_rows >= few))
    return std::make_unique<OneOrderPanelMatrix>(problem, kernels, jacobian);
  return std::make_unique<DensePanelMatrix>(integrated_rows, kernels, jacobian);
}

}  // namespace fde
