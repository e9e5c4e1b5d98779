#include "fdebench/schemes/stepping/predict_and_correct.hpp"
#include "fdebench/schemes/stepping/rates.hpp"

namespace fde {

Scheme adams_pc() {
  return {.id = "adams_pc",
          .title = "Fractional Adams predictor-corrector",
          .source = "Diethelm, Ford & Freed, Nonlinear Dynamics 29 (2002); Numerical Algorithms 36 (2004)",
          .needs = {.checkpoints = true},
          .expected_rate =
              [](const Problem& problem, const Smoothness& smoothness, double grading, Norm norm) {
                return rate(predictor_corrector_theory, problem, smoothness, grading, norm);
              },
          .solve = on_grid(predict_and_correct),
          .symbol = predictor_corrector_symbol};
}

}  // namespace fde
