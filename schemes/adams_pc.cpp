// SPDX-License-Identifier: MIT
#include "fdebench/schemes/stepping/predict_and_correct.hpp"
#include "fdebench/schemes/stepping/rates.hpp"

namespace fde {

Scheme adams_pc() {
  return {.id = "adams_pc",
          .title = "Fractional Adams predictor-corrector",
          .source = "Diethelm, Ford & Freed, Nonlinear Dynamics 29 (2002); Numerical Algorithms 36 (2004)",
          .capabilities = {.checkpoints = true},
          .expected_rate = expected_rate(predictor_corrector_theory),
          .solve = on_grid(predict_and_correct),
          .symbol = predictor_corrector_symbol};
}

}  // namespace fde
