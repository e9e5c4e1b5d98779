#include "nonlinear/collocation.hpp"

#include "collocation/march.hpp"
#include "diffusive/march.hpp"
#include "march/posed_problem.hpp"
#include "nonlinear/bound.hpp"

namespace fde {

PanelTable reference_table(const Problem& problem, const CollocationOptions& options) {
  require_posed(problem);
  const double tolerance = options.tolerance;
  const PiecewiseSolution solution(problem, {.points = 20, .first_panel = 1e-32, .tolerance = tolerance});
  const PiecewiseSolution other(problem, {.points = 16, .first_panel = 3e-32, .tolerance = tolerance});
  const auto estimates = error_estimates(solution, other, diffusive_solution(problem));
  PanelTable table;
  for (const Panel& panel : solution.panels()) {
    table.panels.push_back({panel.from, panel.to, panel.values, estimates[table.panels.size()]});
  }
  return table;
}

Reference reference_solution(const Problem& problem, const CollocationOptions& options) {
  return panel_reference(reference_table(problem, options));
}

}  // namespace fde
