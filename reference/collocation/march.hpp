#pragma once

#include <vector>

#include "collocation/panel_basis.hpp"
#include "collocation/volterra_history.hpp"

namespace fde {

struct MarchOptions {
  int points;               // Gauss points of a panel
  double first_panel;       // its length relative to the end; what it misses of a weak singularity dies out
  double first_after_jump;  // the same behind a jump of f, relative to its time
  double tolerance;  // of the last Legendre coefficients of f and y on a panel, relative to their sizes
  double weightless = 1e-18;  // of the end: an error of f before it is lost in rounding later on
};

// A solved problem: y is a polynomial on each panel. Panels adapt to f and y and at most double, so that they
// are graded towards 0. Throws std::runtime_error naming the time where no panel converges.
class PiecewiseSolution {
 public:
  PiecewiseSolution(const Problem& problem, const MarchOptions& options);

  [[nodiscard]] Vec at(double t) const;                // 0 <= t <= end
  [[nodiscard]] std::size_t panel_of(double t) const;  // the panel that ends at or after t
  [[nodiscard]] const std::vector<Panel>& panels() const { return panels_; }
  // y at the start of a panel, at Gauss-Legendre points that it is the polynomial through, and at its end.
  [[nodiscard]] Matrix legendre_values(const Panel& panel) const;

 private:
  PanelBasis basis_;
  std::vector<Panel> panels_;
  Vec kept_;  // the points of legendre_values
};

}  // namespace fde
