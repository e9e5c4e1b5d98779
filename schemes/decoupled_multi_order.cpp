// SPDX-License-Identifier: MIT
#include "fdebench/schemes/stepping/order_splitting.hpp"
#include "fdebench/schemes/stepping/predict_and_correct.hpp"
#include "fdebench/schemes/stepping/rates.hpp"

namespace fde {

// Each link of the chain D^(g_i) u_i = u_(i+1) is predicted and corrected with its own weights, from the
// predictions of all links (eqs 3.8-3.11). Orders above 1 are first split into links, because every order of
// the paper is at most 1. For a chain with orders up to 1 the formulas are those of adams_pc with one
// correction.
Scheme decoupled_multi_order() {
  return {
      .id = "decoupled_multi_order",
      .title = "Decoupled multi-order chain, predictor-corrector",
      .source = "Yin, Liu & Anh, J. Algorithms Comput. Technol. 1 (2007), eqs 3.8-3.11",
      .capabilities = {.checkpoints = true},
      .expected_rate = expected_rate(predictor_corrector_theory, splitting_up_to_one),
      .solve = with_split_orders(splitting_up_to_one, on_grid(predict_and_correct)),
      .symbol =
          [](const Problem& problem, double length) {
            return predictor_corrector_symbol(split_orders(problem, splitting_up_to_one(problem)), length);
          },
      .theorem = Theorem{
          .name = "Theorem 4.3 of Yin, Liu & Anh 2007", .hypothesis = "D^γ u in C²", .rate = "1 + min γ"}};
}

}  // namespace fde
