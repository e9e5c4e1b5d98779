// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/study/exact_numbers.hpp"

#include <fmt/format.h>

#include <boost/multiprecision/mpfr.hpp>

namespace fde::bench {
namespace {

// 38 digits are 128 bits.
using Real = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<38>,
                                           boost::multiprecision::et_off>;

Real exact(double number) { return Real(fmt::format("{}", number)); }

// The number at this part of the way from `from` to `to`.
double between(double from, double to, const Real& part, Spacing spacing) {
  const auto number_at = [&](const Real& a, const Real& b) { return Real(a * (1 - part) + b * part); };
  const Real first = exact(from), last = exact(to);
  if (spacing == Spacing::linear) return number_at(first, last).convert_to<double>();
  const Real size = exp(number_at(log(abs(first)), log(abs(last))));
  return (from < 0.0 ? -size : size).convert_to<double>();
}

// Uniform in (0, 1): the middles of 2^53 equal parts.
Real fraction(std::mt19937_64& engine) {
  constexpr unsigned unused = 11;
  constexpr int part = -54;
  return ldexp(Real(2 * (engine() >> unused) + 1), part);
}

}  // namespace

double spaced_number(double from, double to, int i, int count, Spacing spacing) {
  if (i == 0) return from;
  if (i == count - 1) return to;
  return between(from, to, Real(i) / (count - 1), spacing);
}

double NumberSource::uniform(double from, double to, Spacing spacing) {
  return between(from, to, fraction(engine_), spacing);
}

double NumberSource::normal(double mean, double deviation) {
  const Real radius = sqrt(-2 * log(fraction(engine_))), turn = 2 * acos(Real(-1));
  return Real(radius * cos(fraction(engine_) * turn) * exact(deviation) + exact(mean)).convert_to<double>();
}

}  // namespace fde::bench
