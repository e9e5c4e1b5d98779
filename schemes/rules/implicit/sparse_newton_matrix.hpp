// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/schemes/rules/implicit/newton_matrix.hpp"
#include "fdebench/schemes/solvers/sparse_factors.hpp"

namespace fde {

// The iteration matrix of a problem with sparse derivatives. The elimination order depends on the pattern
// only and is computed once for each pattern.
class SparseNewtonMatrix : public NewtonMatrix {
 public:
  explicit SparseNewtonMatrix(const Problem& problem);

  void linearise(Run& run, const StepEquations& step, In y, In f) override;
  bool factorise_linear(const Vec& kappa) override;
  int determinant_sign() override;
  void add_to_diagonal(const Vec& values) override { matrix_.diagonal() += values; }
  void factorise() override;
  void solve(Vec& b) const override;
  [[nodiscard]] std::string_view solver() const override;
  void state(Archive& archive) override;
  [[nodiscard]] const RowScales& rows() const override { return rows_; }

 private:
  void assemble(const SparseMatrix& derivatives, const Vec& kappa);

  // The pattern of a compressed matrix.
  struct Pattern {
    Pattern() = default;
    explicit Pattern(const SparseMatrix& matrix);
    [[nodiscard]] bool matches(const SparseMatrix& matrix) const;
    std::vector<int> outer, inner;
  };

  const Problem& problem_;
  RowScales rows_;
  SparseMatrix identity_, derivatives_, matrix_;
  Pattern assembled_pattern_{};             // of derivatives with a full diagonal, which the matrix shares
  Pattern analysed_pattern_{};              // of the matrix that the factors belong to
  std::unique_ptr<SparseFactors> factors_;  // nullptr: none, or singular
};

}  // namespace fde
