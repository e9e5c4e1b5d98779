// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <limits>
#include <numbers>

#include "fdebench/benchmarks/expressions/expressions.hpp"
#include "fdebench/benchmarks/expressions/sampled_function.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"
#include "fdebench/schemes/problem/interval.hpp"

namespace fde::bench {

// Functions without an implementation in the standard library for every Real.
template <class Real>
struct SpecialFunctions {
  static Real pi() { return std::numbers::pi_v<Real>; }
  static Real gamma(const Real& x) { return std::tgamma(x); }
  static Real erf(const Real& x) { return std::erf(x); }
  static Real erfc(const Real& x) { return std::erfc(x); }
  // Evaluated in double; NaN outside the ranges of the arguments.
  static Real mittag_leffler(const Real& alpha, const Real& beta, const Real& z) {
    constexpr double max_order = 5.0, largest_parameter = 1e4;
    const bool known = alpha > 0 && alpha <= max_order && std::abs(beta) <= largest_parameter &&
                       std::isfinite(static_cast<double>(z));
    if (!known) return std::numeric_limits<Real>::quiet_NaN();
    return fde::reference::mittag_leffler(static_cast<double>(alpha), static_cast<double>(beta),
                                          static_cast<double>(z));
  }
};

template <>
struct SpecialFunctions<Interval> {
  static Interval pi() { return {std::numbers::pi, std::nextafter(std::numbers::pi, 4.0)}; }
  static Interval gamma(const Interval& x) { return fde::gamma(x); }
  static Interval erf(const Interval& x) { return fde::erf(x); }
  static Interval erfc(const Interval& x) { return fde::erfc(x); }
  // E_{alpha,beta} increases along the real axis for 0 < alpha <= 1, beta >= alpha, where E(-x) is completely
  // monotone (Schneider, Expositiones Math. 14, 1996). Elsewhere no range is known.
  static Interval mittag_leffler(const Interval& alpha, const Interval& beta, const Interval& z) {
    const bool known = alpha.width() == 0.0 && beta.width() == 0.0 && alpha.low > 0.0 && alpha.high <= 1.0 &&
                       beta.low >= alpha.high;
    if (!known) return Interval::all();
    const auto value = [&](double x) {
      return SpecialFunctions<double>::mittag_leffler(alpha.low, beta.low, x);
    };
    return widened({value(z.low), value(z.high)});
  }
};

template <class Real>
Real sign_of(const Real& x) {
  return x > 0 ? Real(1) : x < 0 ? Real(-1) : Real(x);
}
template <class Real>
Real smaller_of(const Real& a, const Real& b) {
  return b < a ? b : a;
}
template <class Real>
Real larger_of(const Real& a, const Real& b) {
  return a < b ? b : a;
}
// (-1)^n (x - n) with the whole number n nearest to x.
template <class Real>
Real alternation_of(const Real& x) {
  using std::floor;
  const Real n = floor(Real(x + Real(0.5))), from = x - n;
  return n == Real(2) * floor(Real(n / Real(2))) ? from : Real(-from);
}
inline Interval alternation_of(const Interval& x) { return alternation(x); }
inline Interval sign_of(const Interval& x) { return sign(x); }
inline Interval smaller_of(const Interval& a, const Interval& b) { return min(a, b); }
inline Interval larger_of(const Interval& a, const Interval& b) { return max(a, b); }

// The value of an operation on its arguments. `function`: of a table.
template <Operation operation, class Real>
Real value_of([[maybe_unused]] const Real& a, [[maybe_unused]] const Real& b, [[maybe_unused]] const Real& c,
              [[maybe_unused]] const SampledFunction* function) {
  using std::abs, std::acos, std::asin, std::atan, std::atan2, std::cos, std::cosh, std::exp, std::floor,
      std::log, std::pow, std::sin, std::sinh, std::sqrt, std::tan, std::tanh;
#define FDE_OPERATION(name, arguments, value) \
  if constexpr (operation == Operation::name) return Real(value);
#include "fdebench/benchmarks/expressions/operations.def"
}

// The same for an operation that is known at run time only; number and variable are not operations.
template <class Real>
Real apply(Operation operation, const Real& a, const Real& b, const Real& c,
           const SampledFunction* function = nullptr) {
  switch (operation) {
#define FDE_OPERATION(name, arguments, value) \
  case Operation::name:                       \
    return value_of<Operation::name>(a, b, c, function);
#include "fdebench/benchmarks/expressions/operations.def"
    case Operation::pi:
      return SpecialFunctions<Real>::pi();
    case Operation::number:
    case Operation::variable:
      break;
  }
  return Real(0);
}
template <class Real>
Real apply(const ExpressionPool::Node& node, const Real& a, const Real& b, const Real& c) {
  return apply(node.operation, a, b, c, node.function.get());
}

}  // namespace fde::bench
