// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/scene_facts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

namespace fde::bench {
namespace {

// "coefficient*D(unknown, order)", without a coefficient 1.
std::string text_of(const EquationFormula::Term& term, const std::string& unknown) {
  const auto& [coefficient, order] = term;
  auto derivative = fmt::format("D({}, {})", unknown, order);
  if (coefficient == "1") return derivative;
  const bool is_sum = coefficient.find_first_of("+-", 1) != std::string::npos;
  return fmt::format("{}*{}", is_sum ? fmt::format("({})", coefficient) : coefficient, derivative);
}

}  // namespace

DisplayEquation displayed(const EquationFormula& equation) {
  const auto& [unknown, terms, rhs, initial, final] = equation;
  const auto is_of_order_0 = [](const auto& term) { return term.order == "0"; };
  if (!terms.empty() && std::ranges::all_of(terms, is_of_order_0)) return {"0", rhs};
  std::vector<std::string> sum;
  for (const auto& term : terms) sum.push_back(text_of(term, unknown));
  return {fmt::format("{}", fmt::join(sum, " + ")), rhs};
}

}  // namespace fde::bench
