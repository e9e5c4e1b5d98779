// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/rounded_values.hpp"

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>

#include "fdebench/benchmarks/expressions/apply.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"
#include "fdebench/reference/special_functions/numbers/rational.hpp"

namespace fde::bench {

template <>
struct SpecialFunctions<reference::BigReal> {
  static reference::BigReal pi() { return fde::reference::pi<reference::BigReal>(); }
  static reference::BigReal gamma(const reference::BigReal& x) { return fde::reference::gamma(x); }
  static reference::BigReal erf(const reference::BigReal& x) { return fde::reference::erf(x); }
  static reference::BigReal erfc(const reference::BigReal& x) { return fde::reference::erfc(x); }
  static reference::BigReal mittag_leffler(const reference::BigReal& /*a*/, const reference::BigReal& /*b*/,
                                           const reference::BigReal& /*z*/) {
    return {};
  }
};

namespace {

// E_(a,b)(z), with its own error in units of rounding of Real. If a and b are doubles, the evaluation in
// double takes microseconds, with z rounded to double; other orders, such as 0.7, are evaluated as decimals,
// not as their nearest doubles.
reference::ConditionedValue<long double> mittag_leffler_of(long double alpha, long double beta,
                                                           long double z) {
  constexpr long double unit =
      reference::closed_form_rounding_factor * std::numeric_limits<long double>::epsilon();
  constexpr long double double_unit = std::numeric_limits<double>::epsilon();
  const auto is_double = [](long double x) { return static_cast<double>(x) == x; };
  if (!std::isfinite(z)) return {z, z};
  const auto text = [](long double x) { return fmt::format("{:.19g}", x); };
  const bool quick = is_double(alpha) && is_double(beta) && std::isfinite(static_cast<double>(z));
  const auto [value, bound] =
      quick ? fde::reference::mittag_leffler(static_cast<double>(alpha), static_cast<double>(beta),
                                             std::complex<double>(static_cast<double>(z)))
            : reference::mittag_leffler_in_double(text(alpha), text(beta), text(z), "0");
  long double error = bound;
  if (quick && !is_double(z)) {
    const auto before =
        fde::reference::mittag_leffler(static_cast<double>(alpha), static_cast<double>(beta) - 1.0,
                                       std::complex<double>(static_cast<double>(z)));
    error += double_unit * (std::abs(before.value) + std::abs(beta - 1.0L) * std::abs(value)) / alpha;
  }
  return {value.real(), std::abs(static_cast<long double>(value.real())) + error / unit};
}
reference::ConditionedValue<reference::BigReal> mittag_leffler_of(const reference::BigReal& alpha,
                                                                  const reference::BigReal& beta,
                                                                  const reference::BigReal& z) {
  const int digits = static_cast<int>(-log10(reference::epsilon<reference::BigReal>())) + 2;
  const auto known =
      reference::mittag_leffler(reference::to_text(alpha, digits), reference::to_text(beta, digits),
                                reference::to_text(z, digits), "0", digits);
  const auto value = reference::parse<reference::BigReal>(known.re);
  return {value, reference::BigReal(abs(value))};
}

// The size that stands for an error of 1 where the rounding of x may have passed a whole number; 0 elsewhere,
// and where x itself is one.
template <class Real>
Real unknown_whole_number(const Real& x, const Real& size) {
  using std::floor;
  const Real unit = reference::closed_form_rounding_factor * reference::epsilon<Real>();
  const Real error = unit * size;
  if (!isfinite(x) || x == floor(x) || floor(Real(x - error)) == floor(Real(x + error))) return Real(0);
  return Real(1 / unit);
}

// The value of an operation and its size (closed_form.hpp): the sizes of the arguments times the derivatives.
template <class Real>
reference::ConditionedValue<Real> rounded_apply(const ExpressionPool::Node& node,
                                                const reference::ConditionedValue<Real>& a,
                                                const reference::ConditionedValue<Real>& b,
                                                const reference::ConditionedValue<Real>& c) {
  using std::abs, std::cos, std::exp, std::log, std::sin, std::sqrt;
  const auto operation = node.operation;
  if (operation == Operation::mittag_leffler) {
    auto f = mittag_leffler_of(a.value, b.value, c.value);
    // z E' = (E_(a,b-1) - (b-1) E_(a,b)) / a
    const auto before = mittag_leffler_of(a.value, Real(b.value - 1), c.value);
    const Real slope = (before.value - (b.value - 1) * f.value) / a.value;
    const Real relative = c.value == 0 ? Real(0) : Real(c.size / abs(c.value));
    f.size += abs(slope) * relative + abs(f.value);
    return f;
  }
  const Real f = apply<Real>(node, a.value, b.value, c.value);
  const Real x = a.value;
  const auto handed = [&](const Real& slope) { return Real(abs(slope) * a.size); };
  Real size = abs(f);
  switch (operation) {
    case Operation::add:
    case Operation::subtract:
    case Operation::min:
    case Operation::max:
    case Operation::atan2:
      size += a.size + b.size;
      break;
    case Operation::multiply:
      size += a.size * abs(b.value) + b.size * abs(x);
      break;
    case Operation::divide:
      size += (a.size + abs(f) * b.size) / abs(b.value);
      break;
    case Operation::power:
      if (x != 0) size += abs(f) * (abs(b.value / x) * a.size + abs(Real(log(abs(x)))) * b.size);
      break;
    case Operation::sin:
    case Operation::cos:
      size += handed(operation == Operation::sin ? Real(cos(x)) : Real(sin(x)));
      break;
    case Operation::tan:
      size += handed(Real(1 + f * f));
      break;
    case Operation::asin:
    case Operation::acos:
      size += handed(Real(1 / sqrt(Real(1 - x * x))));
      break;
    case Operation::sinh:
    case Operation::cosh:
      size += handed(Real(1 + abs(f)));
      break;
    case Operation::exp:
      size += handed(f);
      break;
    case Operation::log:
      size += handed(Real(1 / x));
      break;
    case Operation::sqrt:
      if (x != 0) size += handed(Real(f / (2 * x)));
      break;
    case Operation::erf:
    case Operation::erfc:
      size += handed(Real(2 * exp(Real(-x * x))));
      break;
    case Operation::floor:
      size += unknown_whole_number(x, a.size);
      break;
    case Operation::gamma: {  // |digamma| <= |log x| + 1/x + 1 for x > 0
      size += handed(Real(f * (abs(Real(log(abs(x)))) + abs(Real(1 / x)) + 1)));
      break;
    }
    case Operation::sampled:
      size = node.function->at_with_size(x).second;
      if (const auto& slope = node.function->derivative()) size += handed(slope->at(x));
      break;
    case Operation::sign:
    case Operation::step:
    case Operation::pi:
      break;
    default:  // slope at most 1
      size += a.size;
      break;
  }
  return {f, size};
}

// The values of expressions of t and of rows at a time.
template <class Real>
std::vector<reference::ConditionedValue<Real>> values_at(
    const ExpressionPool& pool, const std::vector<Expression>& of, const Real& time,
    const std::vector<reference::ConditionedValue<Real>>& rows) {
  using std::abs;
  using Value = reference::ConditionedValue<Real>;
  const Value absent{Real(0), Real(0)};
  return values_from_parts(
      pool, of, absent, [&](Expression, const ExpressionPool::Node& node, const auto& parts) {
        if (node.operation == Operation::variable) {
          return node.variable == 0 ? Value{time, time}
                                    : rows.at(static_cast<std::size_t>(node.variable) - 1);
        }
        if (node.operation != Operation::number)
          return rounded_apply<Real>(node, parts(0), parts(1), parts(2));
        const Real number = node.text.empty()      ? Real(node.value)
                            : pool.has_fractions() ? reference::rounded<Real>(reference::Rational(node.text))
                                                   : reference::parse<Real>(node.text);
        return Value{number, Real(abs(number))};
      });
}

}  // namespace

std::vector<reference::ConditionedValue<long double>> rounded_values(
    const ExpressionPool& pool, const std::vector<Expression>& of, const long double& time,
    const std::vector<reference::ConditionedValue<long double>>& rows) {
  return values_at<long double>(pool, of, time, rows);
}

std::vector<reference::ConditionedValue<reference::BigReal>> rounded_values(const ExpressionPool& pool,
                                                                            const std::vector<Expression>& of,
                                                                            const reference::BigReal& time) {
  return values_at<reference::BigReal>(pool, of, time, {});
}

}  // namespace fde::bench
