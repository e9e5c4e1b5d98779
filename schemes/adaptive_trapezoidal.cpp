// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/adaptive/adaptive_solver.hpp"
#include "fdebench/schemes/rules/adaptive/trapezoidal_stepper.hpp"

namespace fde {

// The rule of product_trapezoidal with adaptive step size.
Scheme adaptive_trapezoidal() {
  return {
      .id = "adaptive_trapezoidal",
      .title = "Adaptive product trapezoidal rule",
      .source = "Young, Proc. R. Soc. A 224 (1954); steps as Gustafsson, ACM Trans. Math. Softw. 17 (1991)",
      .capabilities = {.resolution = ResolutionKind::tolerance, .implicit = true, .checkpoints = true},
      .solve = [](const Problem& problem, const Resolution& resolution, const Options& options) {
        const auto accuracy = std::get<Tolerance>(resolution);
        return solve_adaptively(problem, accuracy, options, [&](Run& run, double shortest) {
          return std::make_unique<TrapezoidalStepper>(problem, accuracy, options, run, shortest,
                                                      make_newton_solver(problem, options.tolerance));
        });
      }};
}

}  // namespace fde
