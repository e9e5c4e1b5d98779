// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fdebench/reference/nonlinear/collocation/panel_equations.hpp"
#include "fdebench/reference/nonlinear/collocation/panels.hpp"
#include "fdebench/reference/nonlinear/march/rhs_noise.hpp"

namespace fde::reference {

// The rounding noise of the Legendre coefficients on a panel. Without it, noise would count as an unresolved
// solution, and panels would be halved without end.
class PanelNoise {
 public:
  using Solution = PanelEquations::Solution;

  // tolerance: for the last coefficients, relative to the sizes of f and y.
  PanelNoise(const Problem& problem, const PanelBasis& basis, double tolerance);

  // Sizes up to which coefficients of f_i and y_i are noise or within the tolerance.
  [[nodiscard]] Vec negligible_rhs(const Solution& panel) const;
  [[nodiscard]] Vec negligible_values(const Solution& panel) const;

  // Whether there is new noise of f on the panel [from, to] that explains why the panel does not resolve the
  // solution; scale: see RhsNoise::detect.
  bool detect(const Solution& panel, double from, double to, double scale);
  // The same for a panel without a solution, from the panel before it.
  bool detect(const Panel& last, const MagnitudeScales& sizes);

  // Records an accepted panel with `values`, one row for each of dense_nodes. Returns the size of each
  // component to which its rounding errors are relative.
  Vec record_panel(const Solution& panel, double from, double to, const Matrix& values);

  // The noise of f found so far, for MagnitudeScales::noise.
  [[nodiscard]] const Vec& known_rhs_noise() const { return rhs_noise_.allowance(); }

 private:
  [[nodiscard]] Vec largest_of_values(double to) const;
  [[nodiscard]] Vec integrated(double to) const;

  struct PanelRecord {
    double from, to;
    Vec rhs_noise, values_noise;
  };

  const Problem& problem_;
  const PanelBasis& basis_;
  double tolerance_;
  RhsNoise rhs_noise_;
  std::vector<PanelRecord> panels_;  // all panels so far
};

}  // namespace fde::reference
