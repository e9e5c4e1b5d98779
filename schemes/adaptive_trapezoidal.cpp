#include "adaptive/adaptive_march.hpp"
#include "adaptive/trapezoidal_steps.hpp"

namespace fde {

// The rule of product_trapezoidal with adaptive step size.
Scheme adaptive_trapezoidal() {
  return {
      .id = "adaptive_trapezoidal",
      .title = "Adaptive product trapezoidal rule",
      .source = "Young, Proc. R. Soc. A 224 (1954); steps as Gustafsson, ACM Trans. Math. Softw. 17 (1991)",
      .needs = {.takes_grid = false, .takes_accuracy = true, .implicit = true, .checkpoints = true},
      .solve = [](const Problem& problem, const Resolution& resolution, const Options& options) {
        const auto accuracy = std::get<Accuracy>(resolution);
        return march_adaptively(problem, accuracy, options, [&](Run& run, double shortest) {
          return std::make_unique<TrapezoidalSteps>(problem, accuracy, options, run, shortest,
                                                    newton_on_trapezoids(problem, options.tolerance));
        });
      }};
}

}  // namespace fde
