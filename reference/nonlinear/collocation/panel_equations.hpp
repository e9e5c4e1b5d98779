// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "fdebench/reference/nonlinear/collocation/panels.hpp"
#include "fdebench/reference/nonlinear/march/implicit_step.hpp"
#include "fdebench/reference/nonlinear/march/rhs_noise.hpp"
#include "fdebench/schemes/problem/problem.hpp"

namespace fde::reference {

// The coefficients of f are resolved to so many rounding errors of its forcing.
inline constexpr double roundings_of_forcing = 16.0;

// Sizes to which rounding errors and tolerances are relative: the largest so far, one number per component.
struct MagnitudeScales {
  Vec values;   // of y_i
  Vec rhs;      // of the terms of f_i
  Vec forcing;  // of f_i at the initial values, over all times: 1 - cos t is mostly rounding near 0
  Vec noise;    // rounding errors of terms of f_i that cancel for every y, which no size shows

  [[nodiscard]] double largest() const { return values.cwiseMax(rhs).maxCoeff(); }
};

// For a problem with algebraic rows, sets the sizes of f and of the unknowns of these rows to 0: both may be
// unbounded at the start and are then no measure for later panels.
MagnitudeScales without_unbounded_scales(MagnitudeScales sizes, const Problem& problem);

MagnitudeScales sizes_at_start(const Problem& problem);

// The sizes including y and f at the nodes of a panel, one row per node, with df/dy there.
MagnitudeScales updated_scales(const MagnitudeScales& before, const Matrix& y, const Matrix& rhs,
                               const std::vector<Matrix>& jacobians);

// The collocation equations y_i(t_k) = history_i(t_k) + length^gamma_i sum_j W_kj f_i(t_j, y(t_j)) of one
// panel, where history_i is the history term, W the matrix PanelBasis::integral, and t_k, t_j are the nodes
// of the panel. Algebraic rows are 0 = f_i(t_k, y(t_k)).
class PanelEquations {
 public:
  PanelEquations(const Problem& problem, const PanelBasis& basis);

  struct Solution {
    Matrix values;          // y at the targets
    Matrix rhs;             // f at the nodes
    MagnitudeScales sizes;  // up to the end of this panel
    Vec increment;  // size of the integral of f_i over this panel without cancellation: its rounding is noise
                    // of y_i
    Noise noise;
    Noise left_unresolved;  // what the part of f that counts as rounding of its forcing does to all rows
  };

  // Newton's method down to rounding on the panel [from, to], with f = first_rhs as the initial guess; after
  // a jump the root is followed that continues the solution. history: the history term at the targets, and an
  // initial guess of the unknowns of algebraic rows. nullopt where it does not converge.
  [[nodiscard]] std::optional<Solution> solve(const Matrix& history, double from, double to, In first_rhs,
                                              const MagnitudeScales& before) const;

 private:
  // The equations of one panel, with a part of the integral over it.
  struct Step {
    const Matrix& history;
    const Vec& times;
    double from, length, part;
  };
  [[nodiscard]] std::optional<Solution> newton(const Step& step, const Matrix& guess,
                                               const MagnitudeScales& before) const;
  // Linearises at at.values, and sets the sizes, the increment and the noise of `at`.
  [[nodiscard]] LinearisedStep linearise(const Step& step, const MagnitudeScales& before, Solution& at) const;
  // The right-hand sides of the equations for the values and f of `from`.
  [[nodiscard]] Matrix right_hand_side(const Step& step, const Solution& from) const;
  [[nodiscard]] Matrix integrate(const Matrix& rhs, double length) const;  // from the start to the targets
  [[nodiscard]] std::vector<Matrix> weights(double length) const;          // from the start to the nodes

  const Problem& problem_;
  const PanelBasis& basis_;
  std::vector<Matrix> integral_;  // of each component
};

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
