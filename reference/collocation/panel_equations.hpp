#pragma once

#include <optional>
#include <vector>

#include "collocation/panel_basis.hpp"
#include "collocation/sizes.hpp"
#include "march/implicit_step.hpp"

namespace fde {

// The collocation equations y_i(t_k) = past_i(t_k) + length^gamma_i sum_j W_kj f_i(t_j, y(t_j)) of one panel,
// where W holds the exact integrals of PanelBasis::integral and t_k, t_j are the nodes of the panel.
// Algebraic rows read 0 = f_i(t_k, y(t_k)).
class PanelEquations {
 public:
  PanelEquations(const Problem& problem, const PanelBasis& basis);

  struct Solution {
    Matrix values;  // y at the targets
    Matrix rhs;     // f at the nodes
    Sizes sizes;    // up to the end of this panel
    Vec increment;  // size of y_i if nothing cancelled in f_i over this panel; its last digit is noise in y_i
    Noise noise;
  };

  // Newton's method down to rounding, from f = first_rhs on the whole panel [from, to]; past is given at the
  // targets, and is a first guess of unknowns of algebraic rows. Empty where it does not converge.
  [[nodiscard]] std::optional<Solution> solve(const Matrix& past, double from, double to, In first_rhs,
                                              const Sizes& before) const;

 private:
  // Linearises at the values of a solution, and says how large it is and how much of it is noise.
  [[nodiscard]] LinearisedStep linearise(const Vec& times, const Sizes& before, double length,
                                         Solution& at) const;
  // What the equations make of values and f.
  [[nodiscard]] Matrix advanced(const Matrix& past, const Solution& from, double length) const;
  [[nodiscard]] Matrix jacobian_at(double t, In y) const;
  [[nodiscard]] Matrix integrate(const Matrix& rhs, double length) const;  // from the start to the targets
  [[nodiscard]] std::vector<Matrix> weights(double length) const;          // from the start to the nodes

  const Problem& problem_;
  const PanelBasis& basis_;
  std::vector<Matrix> integral_;  // of each component
};

}  // namespace fde
