#pragma once

#include <Eigen/LU>
#include <optional>
#include <vector>

#include "collocation/panel_basis.hpp"

namespace fde {

// What rounding, and so every tolerance, is relative to: how large y_i and the terms that f_i is made of have
// been so far, and f_i at the initial values at all times (a forcing like 1 - cos t is all rounding near 0).
// And rounding that no size tells of: the noise of terms of f_i that cancel for every y.
struct Sizes {
  Vec values, rhs, forcing, noise;

  [[nodiscard]] double largest() const { return values.cwiseMax(rhs).maxCoeff(); }
};

// int_0^length (length-s)^(order-1) / Gamma(order) ds times the size of f, in each component.
Vec increment_of(const Problem& problem, const Vec& rhs_size, double length);

// The collocation equations y_i(t_k) = past_i(t_k) + length^gamma_i sum_j W_kj f_i(t_j, y(t_j)) of one panel,
// where W holds the exact integrals of PanelBasis::integral and t_k, t_j are the nodes of the panel.
class PanelEquations {
 public:
  PanelEquations(const Problem& problem, const PanelBasis& basis);

  // How much of y and f on the panel is rounding, as it passes from component to component.
  struct Noise {
    Vec values, rhs;
  };

  struct Solution {
    Matrix values;  // y at the targets
    Matrix rhs;     // f at the nodes
    Sizes sizes;    // up to the end of this panel
    Vec increment;  // size of y_i if nothing cancelled in f_i over this panel; its last digit is noise in y_i
    Noise noise;
  };

  // Newton's method down to rounding, from f = first_rhs on the whole panel [from, to]; past is given at the
  // targets. Empty where it does not converge.
  [[nodiscard]] std::optional<Solution> solve(const Matrix& past, double from, double to, In first_rhs,
                                              const Sizes& before) const;

 private:
  [[nodiscard]] Matrix rhs_at(const Vec& times, const Matrix& y) const;
  [[nodiscard]] Matrix jacobian_at(double t, In y) const;
  [[nodiscard]] Matrix integrate(const Matrix& rhs, double length) const;  // from the start to the targets
  [[nodiscard]] Matrix newton_matrix(const std::vector<Matrix>& jacobians, double length) const;
  [[nodiscard]] Noise noise(const Eigen::PartialPivLU<Matrix>& newton, const std::vector<Matrix>& jacobians,
                            const Matrix& y, const Matrix& rhs, const Vec& rhs_noise, double length) const;

  const Problem& problem_;
  const PanelBasis& basis_;
  std::vector<Matrix> integral_;  // of each component
};

}  // namespace fde
