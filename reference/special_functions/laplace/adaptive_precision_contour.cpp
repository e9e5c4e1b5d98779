// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/laplace/adaptive_precision_contour.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "fdebench/reference/special_functions/laplace/contour.hpp"

namespace fde::reference {
namespace {

DigitSearchOptions search_for(int wanted_digits) {
  return {.target_digits = wanted_digits, .guard = 8, .next_digits = [](int digits, int missing) {
            return digits + missing + 2;
          }};
}

std::vector<BoundedSum<BigReal>> evaluate_at(const EvaluateAt& evaluate, int digits, int extra) {
  const Precision precision(contour_precision(digits) + extra);
  return evaluate(digits);
}

}  // namespace

std::vector<Bounded<BigReal>> increase_digits_by_comparison(int wanted_digits, int extra,
                                                            const EvaluateAt& evaluate) {
  const auto compared = [&](int digits) {
    const auto coarse = evaluate_at(evaluate, digits, extra);
    const auto fine = evaluate_at(evaluate, digits + std::max(10, digits / 16), extra);
    std::vector<WorkingEstimate> estimates;
    for (std::size_t i = 0; i < fine.size(); ++i) {
      const BigComplex difference = fine[i].value - coarse[i].value;
      estimates.push_back({.value_and_bound = {fine[i].value, BigReal(4 * norm1(difference) + fine[i].error)},
                           .scale = fine[i].scale,
                           .is_final = fine[i].overflows});
    }
    return estimates;
  };
  return increase_digits(search_for(wanted_digits), compared).values;
}

Bounded<BigReal> increase_digits_by_bound(int wanted_digits, int extra,
                                          const std::function<BoundedSum<BigReal>(int digits)>& evaluate) {
  const auto bounded = [&](int digits) {
    const Precision precision(contour_precision(digits) + extra);
    const BoundedSum<BigReal> sum = evaluate(digits);
    return std::vector<WorkingEstimate>{
        {.value_and_bound = {sum.value, sum.error}, .is_final = sum.overflows}};
  };
  const DigitSearchResult raised = increase_digits(search_for(wanted_digits), bounded);
  if (raised.largest_missed_bound)
    throw std::runtime_error(fmt::format("no accurate value within {} digits", raised.digits));
  return raised.values.front();
}

}  // namespace fde::reference
