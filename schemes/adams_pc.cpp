// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/symbols/rule_symbols.hpp"
#include "fdebench/schemes/stepping/order_splitting.hpp"
#include "fdebench/schemes/stepping/predict_and_correct.hpp"
#include "fdebench/schemes/stepping/rates.hpp"

namespace fde {
namespace {

OrderSplitting expansion(const Problem& problem) { return commensurate_splitting(problem).value(); }

}  // namespace

Scheme adams_pc() {
  return {.id = "adams_pc",
          .title = "Fractional Adams predictor-corrector",
          .source = "Diethelm, Ford & Freed, Nonlinear Dynamics 29 (2002); Numerical Algorithms 36 (2004)",
          .capabilities = {.checkpoints = true},
          .expected_rate = expected_rate(predictor_corrector_theory),
          .solve = on_grid(predict_and_correct),
          .symbol = predictor_corrector_symbol};
}

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
