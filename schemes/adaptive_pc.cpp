#include "adaptive/adaptive_march.hpp"
#include "adaptive/trapezoidal_steps.hpp"

namespace fde {

// The same rule, predicted from a line through the last two values of f and corrected: adams_pc predicts by
// the rectangle rule, which on steps of any length would take a second sum over the past.
Scheme adaptive_pc() {
  return {.id = "adaptive_pc",
          .title = "Adaptive predictor-corrector",
          .source =
              "Diethelm, Ford & Freed, Nonlinear Dynamics 29 (2002), with the predictor of rate 2; steps "
              "as Gustafsson, ACM Trans. Math. Softw. 17 (1991)",
          .needs = {.takes_grid = false, .takes_accuracy = true, .checkpoints = true},
          .solve = [](const Problem& problem, const Resolution& resolution, const Options& options) {
            const auto accuracy = std::get<Accuracy>(resolution);
            return march_adaptively(problem, accuracy, options, [&](Run& run, double shortest) {
              return std::make_unique<TrapezoidalSteps>(problem, accuracy, options, run, shortest,
                                                        correct_predictions(options.corrections));
            });
          }};
}

}  // namespace fde
