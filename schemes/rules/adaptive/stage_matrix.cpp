// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/adaptive/stage_matrix.hpp"

#include <algorithm>
#include <limits>

#include "fdebench/schemes/rules/implicit/difference_jacobian.hpp"
#include "fdebench/schemes/solvers/dense_factors.hpp"
#include "fdebench/schemes/solvers/sparse_lu.hpp"
#include "fdebench/schemes/solvers/sylvester_factors.hpp"

namespace fde {

namespace {

class DenseStageMatrix final : public StageMatrix {
 public:
  explicit DenseStageMatrix(const Problem& problem)
      : problem_(problem), jacobian_(problem.size(), problem.size()) {}

  void factorise(Run& run, double t, In y, In f, const StageWeights& weights) override {
    if (!evaluate_jacobian(problem_, t, y, jacobian_))
      difference_jacobian_of_rhs(run, problem_, t, y, f, Vec::Zero(y.size()), jacobian_);
    const auto size = y.size();
    matrix_.setIdentity(stages * size, stages * size);
    for (Eigen::Index row = 0; row < size; ++row) {
      const bool without_past = problem_.is_algebraic(row);
      for (Eigen::Index i = 0; i < stages; ++i) {
        if (without_past) matrix_(i * size + row, i * size + row) = 0.0;
        for (Eigen::Index j = 0; j < stages; ++j) {
          const double weight =
              without_past ? static_cast<double>(i == j) : weights[static_cast<std::size_t>(row)](i, j);
          matrix_.row(i * size + row).segment(j * size, size) -= weight * jacobian_.row(row);
        }
      }
    }
    factors_.compute(matrix_);
  }

  void solve(Vec& b) const override { b = factors_.solve(b).eval(); }

 private:
  const Problem& problem_;
  Matrix jacobian_, matrix_;
  Eigen::PartialPivLU<Matrix> factors_;
};

// Problems with sparse derivatives have no algebraic rows.
class SparseStageMatrix final : public StageMatrix {
 public:
  explicit SparseStageMatrix(const Problem& problem) : problem_(problem) {}

  void factorise(Run& /*run*/, double t, In y, In /*f*/, const StageWeights& weights) override {
    assemble(sparse_jacobian_at(problem_, t, y, jacobian_), weights);
    factors_.compute(matrix_);
  }

  void solve(Vec& b) const override {
    if (factors_.info() == Eigen::Success) {
      b = factors_.solve(b).eval();
    } else {
      b.setConstant(std::numeric_limits<double>::quiet_NaN());
    }
  }

  [[nodiscard]] std::string_view solver() const override { return "lu"; }

 private:
  void assemble(const SparseMatrix& jacobian, const StageWeights& weights) {
    const auto size = jacobian.rows();
    std::vector<Eigen::Triplet<double>> entries;
    for (Eigen::Index row = 0; row < stages * size; ++row) entries.emplace_back(row, row, 1.0);
    for (Eigen::Index outer = 0; outer < jacobian.outerSize(); ++outer) {
      for (SparseMatrix::InnerIterator entry(jacobian, outer); entry; ++entry) {
        const auto& of_row = weights[static_cast<std::size_t>(entry.row())];
        for (Eigen::Index i = 0; i < stages; ++i) {
          for (Eigen::Index j = 0; j < stages; ++j) {
            entries.emplace_back(i * size + entry.row(), j * size + entry.col(),
                                 -of_row(i, j) * entry.value());
          }
        }
      }
    }
    matrix_.resize(stages * size, stages * size);
    matrix_.setFromTriplets(entries.begin(), entries.end());
  }

  const Problem& problem_;
  SparseMatrix jacobian_, matrix_;
  SparseLu factors_;
};

// The iteration matrix of a step where all components have one order, hence the same weights K, and df/dy = A
// is sparse: Y - A Y K^T = B, Y and B with one column a stage. For all orders up to 1, K has one real
// eigenvalue and one complex pair, and their real parts are positive (Hairer & Wanner, section IV.8). The
// next iteration corrects what a solve leaves, so increments need few digits.
class DecoupledStageMatrix final : public StageMatrix {
 public:
  explicit DecoupledStageMatrix(const Problem& problem) : problem_(problem) {}

  void factorise(Run& /*run*/, double t, In y, In /*f*/, const StageWeights& weights) override {
    solvable_ = factors_.factorise(sparse_jacobian_at(problem_, t, y, jacobian_), weights.front(), 1.0,
                                   accuracy_of_increments);
  }
  void solve(Vec& b) const override {
    if (solvable_) {
      factors_.solve(b);
    } else {
      b.setConstant(std::numeric_limits<double>::quiet_NaN());
    }
  }
  [[nodiscard]] std::string_view solver() const override { return factors_.method(); }

 private:
  static constexpr double accuracy_of_increments = 1e-6;

  const Problem& problem_;
  SparseMatrix jacobian_;
  SylvesterFactors factors_;
  bool solvable_ = false;
};

}  // namespace

std::unique_ptr<StageMatrix> make_stage_matrix(const Problem& problem) {
  const auto& rows = problem.components;
  const bool one_order =
      std::ranges::all_of(rows, [&](const Component& row) { return row.order == rows.front().order; });
  if (has_sparse_jacobian(problem) && one_order) return std::make_unique<DecoupledStageMatrix>(problem);
  if (has_sparse_jacobian(problem)) return std::make_unique<SparseStageMatrix>(problem);
  return std::make_unique<DenseStageMatrix>(problem);
}

}  // namespace fde
