// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/adaptive/adaptive_solver.hpp"
#include "fdebench/schemes/rules/adaptive/radau_rule.hpp"
#include "fdebench/schemes/stepping/order_splitting.hpp"

namespace fde {
namespace {

Trajectory solve_by_radau(const Problem& problem, const Resolution& resolution, const Options& options) {
  const auto accuracy = std::get<Tolerance>(resolution);
  return solve_adaptively(problem, accuracy, options, [&](Run& run, double shortest) {
    return std::make_unique<RadauRule>(problem, accuracy, options, run, shortest);
  });
}

}  // namespace

// Orders above 1 are split, because RadauRule is for orders up to 1.
Scheme radau_exponentials() {
  return {.id = "radau_exponentials",
          .title = "Radau IIA with exponentials",
          .source =
              "Hairer & Wanner, Solving Ordinary Differential Equations II (1996), section IV.8; memory as "
              "Guglielmi & Hairer, arXiv 2506.04188 (2025)",
          .capabilities = {.resolution = ResolutionKind::tolerance,
                           .implicit = true,
                           .algebraic_rows = true,
                           .checkpoints = true},
          .solve = with_split_orders(splitting_up_to_one, solve_by_radau)};
}

}  // namespace fde
