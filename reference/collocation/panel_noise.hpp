#pragma once

#include <vector>

#include "collocation/panel_equations.hpp"
#include "collocation/volterra_history.hpp"
#include "march/rhs_noise.hpp"

namespace fde {

// What rounding leaves to be seen of the Legendre coefficients on a panel. A march that took the noise below
// for an unresolved solution would halve its panels for ever.
class PanelNoise {
 public:
  using Solution = PanelEquations::Solution;

  // tolerance: of the last coefficients, relative to the sizes of f and y.
  PanelNoise(const Problem& problem, const PanelBasis& basis, double tolerance);

  // Coefficients of f_i and y_i that are noise or within the tolerance.
  [[nodiscard]] Vec negligible_rhs(const Solution& panel) const;
  [[nodiscard]] Vec negligible_values(const Solution& panel) const;

  // Looks for noise of f that was not known of. Whether there is some on the panel [from, to] that explains
  // why it is not resolved; scale: see RhsNoise::find.
  bool found_on(const Solution& panel, double from, double to, double scale);
  // The same where a panel has no solution: on the panel before it.
  bool found_on(const Panel& last, const Sizes& sizes);

  // Takes note of a panel that ends at values, a row each at dense_nodes. Returns what its rounding errors
  // are relative to.
  Vec follow(const Solution& panel, double from, double to, const Matrix& values);

  // Noise of f that is known, for Sizes::noise.
  [[nodiscard]] const Vec& of_rhs() const { return rhs_noise_.found(); }

 private:
  [[nodiscard]] Vec integrated(double to) const;

  struct Past {
    double from, to;
    Vec rhs_noise;
  };

  const Problem& problem_;
  const PanelBasis& basis_;
  double tolerance_;
  RhsNoise rhs_noise_;
  Vec of_values_;           // the largest so far
  std::vector<Past> past_;  // all panels so far
};

}  // namespace fde
