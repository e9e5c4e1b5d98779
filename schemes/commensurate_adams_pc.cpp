// SPDX-License-Identifier: MIT
#include "fdebench/schemes/stepping/order_splitting.hpp"
#include "fdebench/schemes/stepping/predict_and_correct.hpp"
#include "fdebench/schemes/stepping/rates.hpp"

namespace fde {
namespace {

OrderSplitting expansion(const Problem& problem) { return commensurate_splitting(problem).value(); }

}  // namespace

// adams_pc on the expansion in which every order is the same 1/M. Yin, Liu & Anh argue against it because of
// its many components (Cost::components); this scheme allows to measure the cost.
Scheme commensurate_adams_pc() {
  return {.id = "commensurate_adams_pc",
          .title = "Adams predictor-corrector on the commensurate expansion",
          .source = "Diethelm & Ford, BIT 42 (2002); the alternative of Yin, Liu & Anh 2007, eqs 1.5, 1.6",
          .capabilities = {.checkpoints = true},
          .expected_rate = expected_rate(predictor_corrector_theory, expansion),
          .solve = with_split_orders(expansion, on_grid(predict_and_correct)),
          .unsupported_problem_reason = [](const Problem& problem) -> std::optional<std::string> {
            if (commensurate_splitting(problem)) return std::nullopt;
            return "needs orders that are multiples of one 1/M with M at most 64";
          },
          .symbol =
              [](const Problem& problem, double length) {
                return predictor_corrector_symbol(split_orders(problem, expansion(problem)), length);
              },
          .expansion_of = "decoupled_multi_order"};
}

}  // namespace fde
