// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/adaptive/adaptive_solver.hpp"
#include "fdebench/schemes/rules/adaptive/trapezoidal_rule.hpp"

namespace fde {
namespace {

// The trapezoidal rule, whose steps are solved by `make`.
template <class Make>
Solve trapezoidal(Make make) {
  return [make](const Problem& problem, const Resolution& resolution, const Options& options) {
    const auto accuracy = std::get<Tolerance>(resolution);
    return solve_adaptively(problem, accuracy, options, [&](Run& run, double shortest) {
      return std::make_unique<TrapezoidalRule>(problem, accuracy, options, run, shortest,
                                               make(problem, options));
    });
  };
}

}  // namespace

// The rule of product_trapezoidal with adaptive step size.
Scheme adaptive_trapezoidal() {
  return {
      .id = "adaptive_trapezoidal",
      .title = "Adaptive product trapezoidal rule",
      .source = "Young, Proc. R. Soc. A 224 (1954); steps as Gustafsson, ACM Trans. Math. Softw. 17 (1991)",
      .capabilities = {.resolution = ResolutionKind::tolerance, .implicit = true, .checkpoints = true},
      .solve = trapezoidal([](const Problem& problem, const Options& options) {
        return make_newton_solver(problem, options.newton_tolerance);
      })};
}

// The rule of adaptive_trapezoidal as a predictor-corrector. The prediction extrapolates f linearly from its
// last two values: the rectangle rule of adams_pc would need a second memory sum on variable steps.
Scheme adaptive_pc() {
  return {.id = "adaptive_pc",
          .title = "Adaptive predictor-corrector",
          .source =
              "Diethelm, Ford & Freed, Nonlinear Dynamics 29 (2002), with the predictor of rate 2; steps "
              "as Gustafsson, ACM Trans. Math. Softw. 17 (1991)",
          .capabilities = {.resolution = ResolutionKind::tolerance, .checkpoints = true},
          .solve = trapezoidal([](const Problem&, const Options& options) {
            return make_predictor_corrector(options.corrections);
          })};
}

}  // namespace fde
