// SPDX-License-Identifier: MIT
// Intervals contain the values of functions at all points of their arguments, and are not much larger.

#include "fdebench/schemes/problem/interval.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace fde::bench {
namespace {

struct IntervalOperation {
  std::string name;
  std::function<Interval(const Interval&, const Interval&)> enclosed;
  std::function<long double(long double, long double)> exact;
};

std::vector<IntervalOperation> operations() {
  using Long = long double;
  return {
      {"sum", [](auto& a, auto& b) { return a + b; }, [](Long a, Long b) { return a + b; }},
      {"difference", [](auto& a, auto& b) { return a - b; }, [](Long a, Long b) { return a - b; }},
      {"product", [](auto& a, auto& b) { return a * b; }, [](Long a, Long b) { return a * b; }},
      {"quotient", [](auto& a, auto& b) { return a / b; }, [](Long a, Long b) { return a / b; }},
      {"square", [](auto& a, auto&) { return square(a); }, [](Long a, Long) { return a * a; }},
      {"cube", [](auto& a, auto&) { return pow(a, 3.0); }, [](Long a, Long) { return a * a * a; }},
      {"reciprocal", [](auto& a, auto&) { return pow(a, -1.0); }, [](Long a, Long) { return 1 / a; }},
      {"power", [](auto& a, auto& b) { return pow(a, b); }, [](Long a, Long b) { return std::pow(a, b); }},
      {"sin", [](auto& a, auto&) { return sin(a); }, [](Long a, Long) { return std::sin(a); }},
      {"cos", [](auto& a, auto&) { return cos(a); }, [](Long a, Long) { return std::cos(a); }},
      {"tan", [](auto& a, auto&) { return tan(a); }, [](Long a, Long) { return std::tan(a); }},
      {"asin", [](auto& a, auto&) { return asin(a); }, [](Long a, Long) { return std::asin(a); }},
      {"acos", [](auto& a, auto&) { return acos(a); }, [](Long a, Long) { return std::acos(a); }},
      {"atan", [](auto& a, auto&) { return atan(a); }, [](Long a, Long) { return std::atan(a); }},
      {"atan2", [](auto& a, auto& b) { return atan2(a, b); },
       [](Long a, Long b) { return std::atan2(a, b); }},
      {"sinh", [](auto& a, auto&) { return sinh(a); }, [](Long a, Long) { return std::sinh(a); }},
      {"cosh", [](auto& a, auto&) { return cosh(a); }, [](Long a, Long) { return std::cosh(a); }},
      {"tanh", [](auto& a, auto&) { return tanh(a); }, [](Long a, Long) { return std::tanh(a); }},
      {"exp", [](auto& a, auto&) { return exp(a); }, [](Long a, Long) { return std::exp(a); }},
      {"log", [](auto& a, auto&) { return log(a); }, [](Long a, Long) { return std::log(a); }},
      {"sqrt", [](auto& a, auto&) { return sqrt(a); }, [](Long a, Long) { return std::sqrt(a); }},
      {"abs", [](auto& a, auto&) { return abs(a); }, [](Long a, Long) { return std::abs(a); }},
      {"min", [](auto& a, auto& b) { return min(a, b); }, [](Long a, Long b) { return std::min(a, b); }},
      {"max", [](auto& a, auto& b) { return max(a, b); }, [](Long a, Long b) { return std::max(a, b); }},
      {"gamma", [](auto& a, auto&) { return gamma(a); }, [](Long a, Long) { return std::tgamma(a); }},
      {"erf", [](auto& a, auto&) { return erf(a); }, [](Long a, Long) { return std::erf(a); }},
      {"erfc", [](auto& a, auto&) { return erfc(a); }, [](Long a, Long) { return std::erfc(a); }},
      {"floor", [](auto& a, auto&) { return floor(a); }, [](Long a, Long) { return std::floor(a); }},
      {"alternation", [](auto& a, auto&) { return alternation(a); },
       [](Long a, Long) {
         const Long n = std::rint(a);
         return std::fmod(n, 2.0L) == 0.0L ? a - n : n - a;
       }},
  };
}

// Intervals of all sizes, with 0 and whole numbers among their ends.
Interval drawn(std::mt19937& random) {
  std::uniform_real_distribution<double> middle(-4.0, 4.0), exponent(-12.0, 1.0);
  const double from = random() % 4 == 0 ? std::floor(middle(random)) : middle(random);
  return {from, from + std::pow(10.0, exponent(random))};
}

TEST(Interval, ContainsTheValuesOfFunctions) {
  std::mt19937 random(7);
  for (const auto& [name, enclosed, exact] : operations()) {
    for (int k = 0; k < 2000; ++k) {
      const Interval a = drawn(random), b = drawn(random), value = enclosed(a, b);
      for (int point = 0; point < 8; ++point) {
        const auto within = [&](const Interval& of) {
          const double part = point < 2 ? point : static_cast<double>(random() % 1000) / 1000.0;
          return std::min(of.high, of.low + part * of.width());
        };
        const double x = within(a), y = within(b);
        const long double f = exact(x, y);
        if (!std::isfinite(static_cast<double>(f))) continue;
        ASSERT_LE(value.low, f) << name << "(" << x << ", " << y << ")";
        ASSERT_GE(value.high, f) << name << "(" << x << ", " << y << ")";
      }
    }
  }
}

TEST(Interval, OfAPointIsARoundedPoint) {
  constexpr double few = 64.0 * std::numeric_limits<double>::epsilon();
  for (const auto& [name, enclosed, exact] : operations()) {
    const double x = 0.7, y = 1.3;
    EXPECT_LE(enclosed(x, y).width(), few * std::abs(static_cast<double>(exact(x, y)))) << name;
  }
}

TEST(Interval, KnowsTurningPointsAndPoles) {
  constexpr double pi = std::numbers::pi;
  EXPECT_EQ(sin(Interval(0.0, 2.0)).high, 1.0);
  EXPECT_LT(sin(Interval(0.0, 1.5)).high, 1.0);
  EXPECT_EQ(cos(Interval(3.0, 4.0)).low, -1.0);
  EXPECT_GT(cos(Interval(1e6 * pi + 0.1, 1e6 * pi + 3.0)).low, -1.0);
  EXPECT_EQ(square(Interval(-1.0, 2.0)).low, 0.0);
  EXPECT_LT((Interval(-1.0, 2.0) * Interval(-1.0, 2.0)).low, -1.9);
  EXPECT_EQ((Interval(1.0) / Interval(-1.0, 1.0)).high, std::numeric_limits<double>::infinity());
  EXPECT_EQ(tan(Interval(1.0, 2.0)).low, -std::numeric_limits<double>::infinity());
  EXPECT_EQ(exp(Interval(-1e4, -1e3)).low, 0.0);
  EXPECT_EQ(alternation(Interval(2.25, 2.75)).high, 0.5);
  EXPECT_EQ(alternation(Interval(3.0, 3.25)).high, 0.0);
  EXPECT_EQ(alternation(Interval(3.0, 3.5)).low, -0.5);
  EXPECT_EQ(alternation(Interval(0.0, 2.5)).low, -0.5);
}

}  // namespace
}  // namespace fde::bench
