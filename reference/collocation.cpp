#include "collocation.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "collocation_march.hpp"
#include "diffusive_march.hpp"
#include "reference_bound.hpp"

namespace fde {

namespace {

void check(const Problem& problem) {
  const auto require = [](bool holds, const std::string& what) {
    if (!holds) {
      throw std::invalid_argument("reference solution: " + what);
    }
  };
  require(problem.end > 0.0 && std::isfinite(problem.end), "the end must be positive and finite");
  require(problem.size() > 0, "no components");
  for (std::size_t i = 0; i < problem.components.size(); ++i) {
    const auto& [order, initial, side] = problem.components[i];
    const std::string component = "component " + std::to_string(i);
    require(side == Side::left, component + " has a right derivative");
    require(order > 0.0 && order <= 2.0, component + " needs an order in (0, 2]");
    require(initial.size() == initial_count(order), component + " needs ceil(order) initial values");
  }
}

}  // namespace

ReferenceTable reference_table(const Problem& problem, const CollocationOptions& options) {
  check(problem);
  const double tolerance = options.tolerance;
  const PiecewiseSolution solution(problem, {.points = 20, .first_panel = 1e-32, .tolerance = tolerance});
  const PiecewiseSolution other(problem, {.points = 16, .first_panel = 3e-32, .tolerance = tolerance});
  const auto estimates = error_estimates(solution, other, diffusive_solution(problem));
  ReferenceTable table;
  for (const Panel& panel : solution.panels()) {
    table.panels.push_back({panel.from, panel.to, panel.values, estimates[table.panels.size()]});
  }
  return table;
}

Exact reference_solution(const Problem& problem, const CollocationOptions& options) {
  return exact_of(reference_table(problem, options));
}

}  // namespace fde
