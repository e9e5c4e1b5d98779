// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string_view>

#include "fdebench/schemes/rules/spectral/panel_rule.hpp"
#include "fdebench/schemes/stepping/run.hpp"

namespace fde {

// The equations of a panel: at every point x_k = f, or 0 = f for an algebraic row (see IntegratedRows), with
// the rows
//   y_i - origin_i = known_i + I^(order_i) x_k,   k the unknown of row i.
struct PanelSystem {
  Vec times;       // of the points
  Vec units;       // PanelKernels::units of its length
  Matrix known;    // one row a point, one column a row of the problem
  Vec term_sizes;  // of the largest term in the sum of each row: rounding is relative to it
};

// df/dy of a problem at (t, z), z = y - origin. The problem must outlive it.
class PanelJacobian {
 public:
  PanelJacobian(const Problem& problem, const IntegratedRows& integrated_rows);

  // Whether all rows are integrals of one order, each of an unknown of its own.
  [[nodiscard]] bool has_one_order() const { return has_one_order_; }
  [[nodiscard]] bool is_sparse() const;

  // Dense; by differences with increments for these sizes of y where the problem does not tell it. The
  // reference is valid up to the next call.
  const Matrix& dense_at(Run& run, double t, In z, In sizes);
  // Sparse, of any problem.
  SparseMatrix sparse_at(Run& run, double t, In z, In sizes);

  // Whether the problem, linearised there, has a mode that grows faster than e^(rate t); also true where
  // df/dy is not finite.
  bool grows_faster(Run& run, double t, In z, In sizes, double rate);

 private:
  const Problem& problem_;
  const Vec& origin_;
  bool has_one_order_;
  Matrix dense_;
  Vec f_;
};

// The matrix of Newton's method for all points of a panel at once: increments d of the x_k change the rows by
// their integrals I d, and
//   d_j - J_j (I d)_j = residual_j   at every point j, without the first term for algebraic rows,
// J_j = df/dy at the point. One row a point and one column an unknown.
class PanelMatrix {
 public:
  PanelMatrix() = default;
  PanelMatrix(const PanelMatrix&) = delete;
  PanelMatrix& operator=(const PanelMatrix&) = delete;
  virtual ~PanelMatrix() = default;

  // Returns false where an entry is not finite or the matrix is singular. `rows`: y - origin at the points.
  virtual bool factorise(Run& run, const PanelSystem& task, const Matrix& rows) = 0;

  // The increments d.
  [[nodiscard]] virtual Matrix solve(const Matrix& residual) const = 0;

  // The largest |df_k/dy_i| on the panel, one row an unknown k, one column a row i; nullptr: not known.
  [[nodiscard]] virtual const Matrix* sensitivities() const { return nullptr; }

  // The name of the solver of sparse matrices; empty: it is dense.
  [[nodiscard]] virtual std::string_view solver() const { return {}; }
};

// A matrix for the kind of a problem: dense elimination of all points and unknowns; or, where all rows have
// one order and there are many of them, SylvesterFactors, whose cost grows with the entries of df/dy. All
// arguments must outlive it.
std::unique_ptr<PanelMatrix> make_panel_matrix(const Problem& problem, const IntegratedRows& integrated_rows,
                                               const PanelKernels& kernels, PanelJacobian& jacobian);

}  // namespace fde
