// SPDX-License-Identifier: MIT
#pragma once

#include <mutex>

#include "fdebench/benchmarks/scenes/equations/linear_field.hpp"
#include "fdebench/benchmarks/scenes/equations/sine_modes.hpp"

namespace fde::bench {

// The coefficient a(x) of diffusion in D^gamma u = kappa div(a grad u); it depends on x only.
class Medium {
 public:
  // From the parameters of medium_parameters().
  explicit Medium(const Parameters& parameters);

  [[nodiscard]] bool is_uniform() const { return kind_ == "even"; }  // a = 1
  [[nodiscard]] double at(double x) const;

 private:
  std::string kind_;
  double contrast_;
};

// The parameters `medium` and `contrast` of the diffusion scenes.
std::vector<Parameter> medium_parameters();

// D^g u = kappa div(a(x) grad u) at points inside (0, 1), or inside the unit square, with conservative second
// differences
//   kappa ((u_(i+1) - u_i) a_(i+1/2) - (u_i - u_(i-1)) a_(i-1/2)) / dx^2,
// in the y direction with a_i, and u = 0 at the border. In y the sines are eigenvectors; for each of them the
// matrix in x is tridiagonal. Its eigenvectors are computed at the first call of exact_columns_at().
class VariableCoefficientField final : public LinearField {
 public:
  VariableCoefficientField(SineGrid points, InitialField initial_values_on_axis, int dimensions, double order,
                           double diffusivity, const Medium& medium);

  [[nodiscard]] FieldShape shape() const override { return shape_; }
  [[nodiscard]] const Vec& initial_values_on_axis() const override { return start_.values; }
  [[nodiscard]] SparseMatrix matrix() const override;
  void apply(In u, Out f) const override;
  [[nodiscard]] Outputs outputs() const override;
  // Whether the eigenvectors take a few seconds at most: 500 points of a line, 350 x 350 points with the
  // smooth start of three modes, 100 x 100 with the step start.
  [[nodiscard]] bool has_exact_solution() const override;
  [[nodiscard]] reference::ReferenceValue exact_columns_at(double t) const override;

 private:
  // Eigenvectors v_k (columns) of a tridiagonal matrix T with residuals r_k, T v_k = -rate_k v_k + r_k, and
  // the initial values start = sum_k amplitude_k v_k + an error of norm `expansion_error`. One set for each
  // sine in y, with the number of_y; of_y = 0 on a line.
  struct Modes {
    int of_y;
    double amplitude_of_y;
    Vec rates, amplitudes, residuals;  // residuals: |r_k|_2
    Matrix vectors;
    double expansion_error;  // |sum_k amplitude_k v_k - start|_2
  };
  [[nodiscard]] Modes modes_of(int of_y) const;
  [[nodiscard]] const std::vector<Modes>& modes() const;

  SineGrid points_;
  InitialField start_;
  FieldShape shape_;
  double order_;
  Vec x_coupling_;  // kappa a / dx^2 between neighbours in x, n + 1 values
  Vec y_coupling_;  // kappa a / dx^2 between neighbours in y, n values; empty on a line
  Vec diagonal_;    // diagonal of A, n values
  mutable std::once_flag decomposed_{};
  mutable std::vector<Modes> modes_{};
};

}  // namespace fde::bench
