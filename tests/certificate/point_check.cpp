// SPDX-License-Identifier: MIT
#include "certificate/point_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <limits>
#include <tuple>

#include "certificate/enclosure.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"
#include "fdebench/reference/special_functions/numbers/real.hpp"

namespace fde::reference::certificate {
namespace {

template <class Function>
auto timed(double& seconds, Function function) {
  const auto start = std::chrono::steady_clock::now();
  auto result = function();
  seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

// Acquires the lock of the library's multiprecision first, so that waiting for it is not timed.
template <class Function>
auto timed_evaluation(double& seconds, Function function) {
  const Precision lock(20);
  return timed(seconds, function);
}

// False only if size > allowed is certain or one of the two is not finite.
bool is_not_certainly_above(const Ball& size, const Ball& allowed) {
  return acb_is_finite(size.get()) != 0 && acb_is_finite(allowed.get()) != 0 && !(size > allowed);
}

double ulp(double x) {
  constexpr double least = std::numeric_limits<double>::denorm_min();
  return x == 0.0 ? least : std::max(least, std::ldexp(1.0, std::ilogb(x) - 52));
}

double in_ulps(const Ball& error, const Ball& size) {
  return (error / Ball(ulp(abs(size).mid().real()))).mid().real();
}

struct Slope {
  Ball size;  // |z E'|
  bool near_zero;
};

// By z E'_b = (E_{b-1} - (b-1) E_b)/alpha, and once more for (z d/dz)^2 E = z^2 E'' + z E'.
Slope slope_at(const Arguments& x, const Ball& value) {
  constexpr int digits = 30;
  const Ball one(1.0), two(2.0);
  const Ball first = enclose({x.alpha, x.beta - one, x.z}, digits),
             second = enclose({x.alpha, x.beta - two, x.z}, digits);
  const Ball slope = (first - (x.beta - one) * value) / x.alpha;
  const Ball slope_of_first = (second - (x.beta - two) * first) / x.alpha;
  const Ball bend = (slope_of_first - (x.beta - one) * slope) / x.alpha - slope;
  const bool like_a_zero = abs(value * bend) < Ball(0.625) * abs(slope) * abs(slope);
  return {abs(slope), like_a_zero && Ball(4.0) * abs(value) < abs(slope)};
}

// Whether each infinite part of `value_in_double` is justified: the value overflows a double with that sign.
bool overflows(const Ball& value, std::complex<double> computed) {
  const Ball largest(std::numeric_limits<double>::max());
  const auto holds = [&](const Ball& part, double said) {
    return std::isfinite(said) || (said > 0.0 && part > largest) || (said < 0.0 && part < -largest);
  };
  return holds(real(value), computed.real()) && holds(imag(value), computed.imag());
}

void judge_double(PointCheck& row, const Arguments& x, const Ball& value, const Implementations& faces) {
  const auto [computed, bound] =
      timed_evaluation(row.double_seconds, [&] { return faces.evaluate_in_double(row.point); });
  row.value_in_double = computed;
  row.bound = bound;
  if (!std::isfinite(computed.real()) || !std::isfinite(computed.imag())) {
    if (!overflows(value, computed))
      row.failures.emplace_back("not finite, where the value does not overflow");
    return;
  }
  const Ball error = abs(Ball(computed) - value);
  row.ulps = row.conditioned_ulps = in_ulps(error, value);
  if (!is_not_certainly_above(error, Ball(bound))) row.failures.emplace_back("error above the stated bound");
  if (row.ulps <= allowed_ulps) return;
  const auto [slope, near_zero] = slope_at(x, value);
  if (near_zero) row.conditioned_ulps = in_ulps(error, slope);
  if (row.conditioned_ulps > allowed_ulps)
    row.failures.emplace_back(fmt::format("error above {} ulp", allowed_ulps));
}

void judge_digits(PointCheck& row, const Ball& value, int digits, const Implementations& faces) {
  const DecimalComplex text =
      timed_evaluation(row.digits_seconds, [&] { return faces.in_digits(row.point, digits); });
  const Ball bound = Ball::parse(text.bound, "0"), error = abs(Ball::parse(text.re, text.im) - value);
  if (!is_not_certainly_above(error, bound))
    row.failures.push_back(fmt::format("{} digits: error above the stated bound", digits));
  const Ball unit = abs(value) * exp(Ball(1.0 - digits) * log(Ball(10.0)));
  if (!is_not_certainly_above(bound, unit))
    row.failures.push_back(fmt::format("{} digits: the bound is not as small as promised", digits));
}

}  // namespace

std::string exact_text(double x) {
  std::array<char, 1200> text{};
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), x, std::chars_format::general, 780);
  return {text.data(), end};
}

Implementations library_implementations() {
  return {.evaluate_in_double = [](const Point& x) { return mittag_leffler(x.alpha, x.beta, x.z); },
          .in_digits =
              [](const Point& x, int digits) {
                return mittag_leffler(exact_text(x.alpha), exact_text(x.beta), exact_text(x.z.real()),
                                      exact_text(x.z.imag()), digits);
              }};
}

PointCheck check_point(const Point& point, int digits, const Implementations& faces) {
  constexpr int least_digits = 30, guard = 6;
  PointCheck row;
  row.point = point;
  const Arguments x{Ball(point.alpha), Ball(point.beta), Ball(point.z)};
  const int certified = std::max(digits, least_digits) + guard;
  const WorkingBits bits(8 * certified + 64);
  const Ball value = timed(row.ball_seconds, [&] { return enclose(x, certified); });
  std::tie(row.re, row.im) = value.text(certified);
  const Ball distance = abs(value - Ball::parse(row.re, row.im));
  row.radius = distance.upper_bound_text();
  judge_double(row, x, value, faces);
  if (digits > 0) judge_digits(row, value, digits, faces);
  return row;
}

}  // namespace fde::reference::certificate
