// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/exact_number.hpp"

#include <cmath>

#include "fdebench/benchmarks/equation_files/rounded_values.hpp"

namespace fde::bench {

std::optional<ExactNumber> exact_number(Expression of, const ExpressionPool& pool) {
  // More digits than the exponents of doubles have: cancellation of numbers of any size leaves a double.
  constexpr int digits = 700;
  const auto& node = pool[of];
  if (node.operation == Operation::number && !node.text.empty())
    return ExactNumber{reference::Rational(node.text), true};
  if (const auto about = pool.value(of); !about || !std::isfinite(*about)) return std::nullopt;
  const reference::Precision precision(digits);
  const auto [value, size] = rounded_values(pool, {of}, reference::BigReal(0)).front();
  if (!isfinite(value)) return std::nullopt;
  if (value == 0 && size == 0) return ExactNumber{reference::Rational(0), true};  // 0/gamma(x), for example
  const auto rounding = reference::BigReal(reference::closed_form_rounding_factor *
                                           reference::epsilon<reference::BigReal>() * size);
  return ExactNumber{abs(value) <= rounding ? reference::Rational(0) : reference::fraction_of(value), false};
}

}  // namespace fde::bench
