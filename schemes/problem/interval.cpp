// SPDX-License-Identifier: MIT
#include "fdebench/schemes/problem/interval.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fde {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// At least `units` units in the last place of x.
double units_of(double x, double units) {
  return units * std::numeric_limits<double>::epsilon() * std::abs(x) +
         units * std::numeric_limits<double>::denorm_min();
}

Interval outward(double low, double high, double units = 1.0) {
  if (std::isnan(low) || std::isnan(high)) return Interval::all();
  // An infinite lower end that is +infinity is an overflow: the true value is finite and large.
  const double from = low == infinity ? std::numeric_limits<double>::max() : low - units_of(low, units);
  const double to = high == -infinity ? std::numeric_limits<double>::lowest() : high + units_of(high, units);
  return {std::isnan(from) ? low : from, std::isnan(to) ? high : to};
}

// A sum or difference that is rounded to 0 is 0.
Interval sum(double low, double high) {
  const Interval value = outward(low, high);
  return {low == 0.0 ? 0.0 : value.low, high == 0.0 ? 0.0 : value.high};
}

constexpr double library = 8.0;

// Of a function that increases.
template <class Function>
Interval increasing(Function f, const Interval& a) {
  return outward(f(a.low), f(a.high), library);
}

Interval within(const Interval& a, double low, double high) {
  return {std::clamp(a.low, low, high), std::clamp(a.high, low, high)};
}

// 0 * infinity is 0: an infinite end is the limit of finite ones.
double product(double a, double b) { return a == 0.0 || b == 0.0 ? 0.0 : a * b; }

// Whether a contains offset + k period for a whole number k, or may do so within rounding.
bool may_contain(const Interval& a, double offset, double period) {
  constexpr double slack = 1e-15;
  const double from = (a.low - offset) / period, to = (a.high - offset) / period;
  const double room = slack * std::max({1.0, std::abs(from), std::abs(to)});
  return std::floor(to + room) >= std::ceil(from - room);
}

// sin(x + phase) with its maxima at `maximum` + 2 pi k; the arguments are so small that whole periods are
// distinguished.
template <class Function>
Interval wave(Function f, const Interval& a, double maximum) {
  constexpr double largest = 1e12, period = 2.0 * std::numbers::pi;
  if (!(a.magnitude() <= largest) || a.width() >= period) return {-1.0, 1.0};
  const Interval ends = outward(std::min(f(a.low), f(a.high)), std::max(f(a.low), f(a.high)), library);
  const bool top = may_contain(a, maximum, period);
  const bool bottom = may_contain(a, maximum - std::numbers::pi, period);
  return within({bottom ? -1.0 : ends.low, top ? 1.0 : ends.high}, -1.0, 1.0);
}

Interval whole_power(const Interval& a, double n) {
  const auto power = [n](double x) { return std::pow(x, n); };
  const bool odd = std::fmod(std::abs(n), 2.0) == 1.0;
  if (n < 0.0) return Interval(1.0) / whole_power(a, -n);
  if (odd) return increasing(power, a);
  const Interval size = abs(a);
  const Interval value = increasing(power, size);
  return {std::max(value.low, 0.0), value.high};
}

}  // namespace

Interval widened(const Interval& a) { return outward(a.low, a.high, library); }

Interval operator+(const Interval& a, const Interval& b) { return sum(a.low + b.low, a.high + b.high); }
Interval operator-(const Interval& a, const Interval& b) { return sum(a.low - b.high, a.high - b.low); }
Interval operator-(const Interval& a) { return {-a.high, -a.low}; }

Interval operator*(const Interval& a, const Interval& b) {
  const auto [low, high] = std::minmax(
      {product(a.low, b.low), product(a.low, b.high), product(a.high, b.low), product(a.high, b.high)});
  return outward(low, high);
}

Interval operator/(const Interval& a, const Interval& b) {
  if (b.low > 0.0 || b.high < 0.0) return a * outward(1.0 / b.high, 1.0 / b.low);
  if (b.low == 0.0 && b.high == 0.0) return Interval::all();
  if (b.low == 0.0) return a * Interval(outward(1.0 / b.high, 1.0 / b.high).low, infinity);
  if (b.high == 0.0) return a * Interval(-infinity, outward(1.0 / b.low, 1.0 / b.low).high);
  return Interval::all();
}

Interval square(const Interval& a) { return whole_power(a, 2.0); }

Interval pow(const Interval& base, const Interval& exponent) {
  constexpr double largest_whole = 0x1p53;
  const bool point = exponent.low == exponent.high;
  if (point && exponent.low == std::floor(exponent.low) && std::abs(exponent.low) < largest_whole)
    return whole_power(base, exponent.low);
  // A negative base has powers with whole exponents only.
  const bool has_whole = std::floor(exponent.high) >= std::ceil(exponent.low);
  if (base.high < 0.0 || (base.low < 0.0 && has_whole)) return Interval::all();
  const double from = std::max(base.low, 0.0);
  // x^p is monotone in x for each p and in p for each x.
  const auto corners = {std::pow(from, exponent.low), std::pow(from, exponent.high),
                        std::pow(base.high, exponent.low), std::pow(base.high, exponent.high)};
  const auto [low, high] = std::minmax(corners);
  const Interval value = outward(low, high, library);
  return {std::max(value.low, 0.0), value.high};
}

Interval sin(const Interval& a) {
  return wave([](double x) { return std::sin(x); }, a, std::numbers::pi / 2.0);
}
Interval cos(const Interval& a) {
  return wave([](double x) { return std::cos(x); }, a, 0.0);
}

Interval tan(const Interval& a) {
  constexpr double largest = 1e12;
  if (!(a.magnitude() <= largest) || a.width() >= std::numbers::pi ||
      may_contain(a, std::numbers::pi / 2.0, std::numbers::pi))
    return Interval::all();
  return increasing([](double x) { return std::tan(x); }, a);
}

Interval asin(const Interval& a) {
  if (a.high < -1.0 || a.low > 1.0) return Interval::all();
  return increasing([](double x) { return std::asin(x); }, within(a, -1.0, 1.0));
}
Interval acos(const Interval& a) {
  if (a.high < -1.0 || a.low > 1.0) return Interval::all();
  const Interval of = within(a, -1.0, 1.0);
  return outward(std::acos(of.high), std::acos(of.low), library);
}
Interval atan(const Interval& a) {
  return increasing([](double x) { return std::atan(x); }, a);
}

Interval atan2(const Interval& y, const Interval& x) {
  if (x.low <= 0.0 && y.contains(0.0)) return outward(-std::numbers::pi, std::numbers::pi, library);
  // The angle of a box that does not contain the negative axis is largest and smallest at corners.
  const auto corners = {std::atan2(y.low, x.low), std::atan2(y.low, x.high), std::atan2(y.high, x.low),
                        std::atan2(y.high, x.high)};
  const auto [low, high] = std::minmax(corners);
  return outward(low, high, library);
}

Interval sinh(const Interval& a) {
  return increasing([](double x) { return std::sinh(x); }, a);
}
Interval cosh(const Interval& a) {
  const Interval value = increasing([](double x) { return std::cosh(x); }, abs(a));
  return {std::max(value.low, 1.0), value.high};
}
Interval tanh(const Interval& a) {
  return within(increasing([](double x) { return std::tanh(x); }, a), -1.0, 1.0);
}

Interval exp(const Interval& a) {
  const Interval value = increasing([](double x) { return std::exp(x); }, a);
  return {std::max(value.low, 0.0), value.high};
}

Interval log(const Interval& a) {
  if (a.high < 0.0) return Interval::all();
  return increasing([](double x) { return std::log(x); }, {std::max(a.low, 0.0), a.high});
}

Interval sqrt(const Interval& a) {
  if (a.high < 0.0) return Interval::all();
  const Interval value = outward(std::sqrt(std::max(a.low, 0.0)), std::sqrt(a.high));
  return {std::max(value.low, 0.0), value.high};
}

Interval abs(const Interval& a) {
  if (a.low >= 0.0) return a;
  if (a.high <= 0.0) return -a;
  return {0.0, a.magnitude()};
}

Interval sign(const Interval& a) {
  const auto of = [](double x) { return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : 0.0; };
  return {of(a.low), of(a.high)};
}

Interval min(const Interval& a, const Interval& b) {
  return {std::min(a.low, b.low), std::min(a.high, b.high)};
}
Interval max(const Interval& a, const Interval& b) {
  return {std::max(a.low, b.low), std::max(a.high, b.high)};
}

Interval gamma(const Interval& a) {
  constexpr double minimum = 1.4616321449683623, least = 0.8856031944108887;
  if (a.low <= 0.0) return Interval::all();
  const double at_low = std::tgamma(a.low), at_high = std::tgamma(a.high);
  const Interval ends = outward(std::min(at_low, at_high), std::max(at_low, at_high), library);
  return {a.contains(minimum) ? outward(least, least, library).low : ends.low, ends.high};
}

Interval erf(const Interval& a) {
  return within(increasing([](double x) { return std::erf(x); }, a), -1.0, 1.0);
}
Interval erfc(const Interval& a) {
  return within(outward(std::erfc(a.high), std::erfc(a.low), library), 0.0, 2.0);
}

Interval floor(const Interval& a) { return {std::floor(a.low), std::floor(a.high)}; }

// With its maxima 1/2 at 1/2 + 2k; the difference from the nearest whole number has no rounding.
Interval alternation(const Interval& a) {
  constexpr double largest = 1e12, half = 0.5;
  if (!(a.magnitude() <= largest) || a.width() >= 2.0) return {-half, half};
  const auto at = [](double x) {
    const double n = std::floor(x + half);
    return std::fmod(n, 2.0) == 0.0 ? x - n : n - x;
  };
  const auto [low, high] = std::minmax({at(a.low), at(a.high)});
  return {may_contain(a, -half, 2.0) ? -half : low, may_contain(a, half, 2.0) ? half : high};
}

}  // namespace fde
