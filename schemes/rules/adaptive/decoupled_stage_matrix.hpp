// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/rules/adaptive/stage_matrix.hpp"
#include "fdebench/schemes/solvers/sylvester_factors.hpp"

namespace fde {

// The iteration matrix of a step where all components have one order, hence the same weights K, and df/dy = A
// is sparse: Y - A Y K^T = B, Y and B with one column a stage. For all orders up to 1, K has one real
// eigenvalue and one complex pair, and their real parts are positive (Hairer & Wanner, section IV.8).
class DecoupledStageMatrix final : public StageMatrix {
 public:
  explicit DecoupledStageMatrix(const Problem& problem) : problem_(problem) {}

  void factorise(Run& run, double t, In y, In f, const StageWeights& weights) override;
  void solve(Vec& b) const override;
  [[nodiscard]] std::string_view solver() const override { return factors_.method(); }

 private:
  const Problem& problem_;
  SparseMatrix jacobian_;
  SylvesterFactors factors_;
  bool solvable_ = false;
};

}  // namespace fde
