// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fdebench/schemes/problem/delays.hpp"
#include "fdebench/schemes/stepping/grid_jumps.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"
#include "fdebench/schemes/stepping/with_conditions.hpp"
#include "fdebench/schemes/stepping/with_delays.hpp"
#include "fdebench/schemes/stepping/with_resets.hpp"

namespace fde {
namespace {

// Why these capabilities exclude component i, as part of a sentence. open: the problem has conditions, so
// initial values may be missing.
std::optional<std::string> unsupported_reason(const Capabilities& capabilities, const Component& component,
                                              std::size_t i, bool open) {
  const double order = component.order;
  if (is_algebraic(component) && !capabilities.algebraic_rows) {
    return fmt::format("{}: component {} is an algebraic row (order 0)",
                       capabilities.implicit ? "takes no algebraic rows" : "steps explicitly", i);
  }
  if (!(is_algebraic(component) || (order > 0.0 && order <= capabilities.max_order))) {
    return fmt::format("takes orders in {}0, {}], component {} has {}",
                       capabilities.algebraic_rows ? '[' : '(', capabilities.max_order, i, order);
  }
  const auto count = initial_count(order), given = component.initial.size();
  if (given == count || (open && given < count)) return std::nullopt;
  return fmt::format("needs {} initial value{} for order {}, component {} has {}", count,
                     count == 1 ? "" : "s", order, i, given);
}

std::optional<std::string> two_sided_refusal(const Scheme& scheme, const Problem& problem, const Grid* grid) {
  if (!is_two_sided(problem)) return std::nullopt;
  for (std::size_t i = 0; i < problem.components.size(); ++i) {
    const bool right = problem.components[i].side == Side::right;
    if (right && !scheme.capabilities.is_two_sided) {
      return fmt::format("steps from the left: component {} has a right derivative", i);
    }
    if (right && grid != nullptr && !grid->uniform()) {
      return fmt::format("needs a uniform grid for the right derivative of component {}", i);
    }
  }
  if (problem.conditions && unknown_count(problem) == 0) {
    return "needs an unknown initial value for each condition, none is unknown";
  }
  if (grid != nullptr && grid->end != problem.end) {
    return fmt::format("needs a grid that ends with the problem, at {} and not {}", problem.end, grid->end);
  }
  return std::nullopt;
}

std::optional<std::string> unsupported_reason(const Capabilities& capabilities, const Problem& problem,
                                              const Grid& grid) {
  if (capabilities.is_adaptive()) return "takes an accuracy, not a grid";
  if (capabilities.uniform_grid && !grid.uniform()) {
    return fmt::format("needs a uniform grid, not one graded with {}", grid.grading);
  }
  double max_order = 1.0;
  for (const auto& component : problem.components) max_order = std::max(max_order, component.order);
  const double shortest = std::pow(1e-290, 1.0 / max_order);  // its inverse and powers are doubles
  if (grid.step(1) > shortest) return std::nullopt;
  return fmt::format("needs a first step above {:.3g}, not {}", shortest, grid.step(1));
}

std::optional<std::string> unsupported_reason(const Capabilities& capabilities, const Tolerance& accuracy) {
  if (!capabilities.is_adaptive()) return "takes a grid, not an accuracy";
  const auto& [relative, absolute] = accuracy;
  if (relative >= 0.0 && absolute >= 0.0 && std::max(relative, absolute) > 0.0) return std::nullopt;
  return fmt::format("needs an accuracy above 0, not {} relative and {} absolute", relative, absolute);
}

}  // namespace

std::optional<std::string> unsupported_checkpoints_reason(const Scheme& scheme, const Problem& problem) {
  if (!scheme.capabilities.checkpoints) return "keeps no checkpoints";
  if (!problem.resets.empty()) return "keeps no checkpoints where events set unknowns";
  if (has_right_rows(problem)) return "keeps no checkpoints of a problem that it solves at all times at once";
  if (is_solved_by_shooting(problem)) return "keeps no checkpoints of a problem that it solves several times";
  return std::nullopt;
}

// list.def has one line a scheme; the function Scheme <id>() defines it.
#define FDE_SCHEME(id, mark) Scheme id();
#include "fdebench/schemes/list.def"
#undef FDE_SCHEME

std::span<const Scheme> schemes() {
  static const std::array all = [] {
    std::array listed{
#define FDE_SCHEME(id, mark) id(),
#include "fdebench/schemes/list.def"
#undef FDE_SCHEME
    };
    for (auto& scheme : listed)
      scheme.solve = with_conditions(with_resets(with_delays(std::move(scheme.solve))));
    return listed;
  }();
  return all;
}

const Scheme* find_scheme(std::string_view id) {
  const auto found = std::ranges::find_if(schemes(), [id](const Scheme& scheme) {
    return scheme.id == id || (!id.empty() && scheme.alias == id);
  });
  return found == schemes().end() ? nullptr : &*found;
}

Solve on_grid(GridSolve solve) {
  return [solve = std::move(solve)](const Problem& problem, const Resolution& resolution,
                                    const Options& options) {
    const Grid& grid = std::get<Grid>(resolution);
    const GridJumps jumps(problem, grid);
    return jumps.empty() ? solve(problem, grid, options) : solve(jumps.with_means(problem), grid, options);
  };
}

std::optional<std::string> unsupported_reason(const Scheme& scheme, const Problem& problem,
                                              const Resolution& resolution) {
  const auto* grid = std::get_if<Grid>(&resolution);
  auto of_resolution = grid != nullptr
                           ? unsupported_reason(scheme.capabilities, problem, *grid)
                           : unsupported_reason(scheme.capabilities, std::get<Tolerance>(resolution));
  if (of_resolution) return of_resolution;
  if (auto reason = unsupported_delays_reason(scheme, problem, resolution)) return reason;
  if (auto reason = unsupported_resets_reason(scheme, problem)) return reason;
  if (scheme.capabilities.discretises_equations && problem.equations.empty())
    return "discretises multi-term equations, and the problem is not given in multi-term form";
  if (has_sparse_jacobian(problem) && has_algebraic_rows(problem)) {
    return "takes algebraic rows with a dense Jacobian only";
  }
  for (std::size_t i = 0; i < problem.components.size(); ++i) {
    if (auto reason =
            unsupported_reason(scheme.capabilities, problem.components[i], i, bool(problem.conditions)))
      return reason;
  }
  if (auto reason = two_sided_refusal(scheme, problem, grid)) return reason;
  if (!scheme.unsupported_problem_reason) return std::nullopt;
  if (is_solved_by_shooting(problem))
    return scheme.unsupported_problem_reason(BoundProblem(with_some_initial_values(problem)).problem());
  if (problem.delays.lags.empty()) return scheme.unsupported_problem_reason(problem);
  return scheme.unsupported_problem_reason(BoundProblem(problem).problem());
}

}  // namespace fde
