// SPDX-License-Identifier: MIT
// Linear stability with delays: D^g y = a y + b y(t - lag), of the equation and of schemes.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "fdebench/benchmarks/programs/stability/late_growth.hpp"
#include "fdebench/schemes/diagnostics/modes.hpp"
#include "fdebench/schemes/diagnostics/stability_region.hpp"
#include "fdebench/schemes/history/symbols/delayed_part.hpp"
#include "fdebench/schemes/problem/delays.hpp"
#include "fdebench/schemes/problem/scalar_equation.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

using std::numbers::pi;

const Scheme& named(std::string_view id) { return *find_scheme(id); }

// A mode s = iw of the equation with lag 1: w^g e^(i g pi/2) = a + b e^(-iw). Beyond a + b = 0 a real mode
// grows too, for w below pi (1 - g).
std::pair<double, double> boundary_of_equation(double g, double w) {
  const double power = std::pow(w, g) / std::sin(w);
  return {power * std::sin(w + 0.5 * g * pi), -power * std::sin(0.5 * g * pi)};
}

TEST(EquationWithDelay, GainsTwoModesAcrossItsBoundary) {
  for (const double g : {0.4, 0.7, 1.0}) {
    for (const double part : {0.1, 0.5, 0.9}) {
      const double w = pi - pi * (1.0 - part) * g;
      const auto [a, b] = boundary_of_equation(g, w);
      EXPECT_EQ(count_growing_modes(delayed_equation(g, a, 0.999 * b, 1.0), 0.01), 0) << g << ' ' << w;
      EXPECT_EQ(count_growing_modes(delayed_equation(g, a, 1.001 * b, 1.0), 0.01), 2) << g << ' ' << w;
    }
  }
}

// The modes of D^g y = b y(t - lag), b < 0, cross the imaginary axis at w lag = pi (1 - g/2) + 2 pi k, where
// -b = w^g, and then grow.
TEST(EquationWithDelay, HasTwoMoreGrowingModesFromEachCrossingOn) {
  for (const double g : {0.3, 0.8, 1.0, 1.7}) {
    for (const double lag : {0.1, 1.0, 30.0}) {
      EXPECT_NEAR(real_stability_interval(g, lag), std::pow(pi * (1.0 - 0.5 * g) / lag, g), 1e-14);
      for (const int k : {0, 1, 7, 100}) {
        const auto count_at = [&](double turn) {
          const double rate = -std::pow((pi * (1.0 - 0.5 * g) + 2.0 * pi * k + turn) / lag, g);
          return count_growing_modes(delayed_equation(g, 0.0, rate, lag), 0.01 * lag);
        };
        EXPECT_EQ(count_at(-0.3), 2 * k) << g << ' ' << lag;
        EXPECT_EQ(count_at(0.3), 2 * k + 2) << g << ' ' << lag;
      }
    }
  }
}

// |(iw)^g - a| >= -a for a < 0 and g <= 1, with equality for w = 0 alone: where a < -|b| no mode reaches the
// axis, and otherwise some lag makes one grow.
TEST(EquationWithDelay, IsStableForAllDelaysWhereTheNewestValueDominates) {
  for (const double g : {0.3, 0.6, 1.0}) {
    for (const double lag : {1e-3, 1.0, 1e3}) {
      for (const double b : {-0.99, 0.5, 0.99})
        EXPECT_EQ(count_growing_modes(delayed_equation(g, -2.0, 2.0 * b, lag), 1e-3), 0) << g << ' ' << lag;
      EXPECT_EQ(count_growing_modes(delayed_equation(g, -2.0, 2.1, lag), 1e-3).value_or(0) % 2, 1) << g;
    }
    EXPECT_GT(count_growing_modes(delayed_equation(g, -2.0, -3.0, 1e3), 1e-3), 0) << g;
  }
}

// Without delays a mode of D^g y = lambda y grows for |arg lambda| < g pi/2 (Matignon 1996).
TEST(EquationWithoutDelay, GrowsInItsSector) {
  for (const double g : {0.2, 0.9, 1.0, 1.6}) {
    for (const double size : {1e-2, 1.0, 1e4}) {
      const auto count = [&](double arg) {
        return count_growing_modes(scalar_equation(g, std::polar(size, arg)), 1.0);
      };
      EXPECT_EQ(count(0.499 * g * pi), 2) << g << ' ' << size;
      EXPECT_EQ(count(0.501 * g * pi), 0) << g << ' ' << size;
    }
  }
}

// A zero of 1 - b zeta^m K at zeta = e^(i theta), K^-1 = (1 - zeta)^g for backward Euler and
// (2 (1 - zeta) / (1 + zeta))^g for the fractional trapezoidal rule.
TEST(DelayedInterval, HasClosedForms) {
  for (const double g : {0.1, 0.5, 1.0, 1.5, 1.9}) {
    for (const int m : {1, 2, 32, 3000}) {
      const double euler = std::pow(2.0 * std::sin(0.5 * pi * (1.0 - 0.5 * g) / (m - 0.5 * g)), g);
      EXPECT_NEAR(real_stability_interval(named("grunwald_letnikov"), g, m) / euler, 1.0, 1e-11)
          << g << ' ' << m;
      if (m < 32) continue;  // the fractional trapezoidal rule starts with more steps
      const double trapezoidal = std::pow(2.0 * std::tan(0.5 * pi * (1.0 - 0.5 * g) / m), g);
      EXPECT_NEAR(real_stability_interval(named("fractional_trapezoidal"), g, m) / trapezoidal, 1.0, 1e-11)
          << g << ' ' << m;
    }
  }
}

// Of backward Euler two modes cross at each theta = (pi (1 - g/2) + 2 pi k) / (m - g/2) below pi.
TEST(GrowingModesWithDelay, AreCountedForThousandsOfSteps) {
  for (const double g : {0.4, 1.0, 1.6}) {
    for (const int m : {7, 400, 3000}) {
      for (const double theta : {0.01, 0.3, 1.0, 3.0}) {
        const double x = std::pow(2.0 * std::sin(0.5 * theta), g);
        const double crossed = (theta * (m - 0.5 * g) - pi * (1.0 - 0.5 * g)) / (2.0 * pi);
        if (std::abs(crossed - std::round(crossed)) < 1e-3) continue;
        EXPECT_EQ(count_growing_modes(named("grunwald_letnikov"), delayed_equation(g, 0.0, -x, m), 1.0),
                  2 * static_cast<int>(std::ceil(std::max(0.0, crossed))))
            << g << ' ' << m << ' ' << theta;
      }
    }
  }
}

class SchemesWithDelay : public testing::TestWithParam<const Scheme*> {};

TEST_P(SchemesWithDelay, DecayInsideTheIntervalAndGrowOutside) {
  for (const double g : {0.4, 0.75, 1.0, 1.5}) {
    for (const int m : {1, 2, 8, 32}) {
      const auto run = [&](double rate) {
        return late_growth(*GetParam(), delayed_equation(g, 0.0, rate, m), 1.0, 800 + 100 * m);
      };
      if (unsupported_reason(*GetParam(), delayed_equation(g, 0.0, 1.0, m), Grid{})) continue;
      const double x = real_stability_interval(*GetParam(), g, m);
      EXPECT_TRUE(decays(run(-0.95 * x))) << g << ' ' << m << ' ' << x;
      EXPECT_TRUE(grows(run(-1.05 * x))) << g << ' ' << m << ' ' << x;
    }
  }
}

// Orders 0.6 and 0.9, coupled with and without a delay; `rate` times the part that looks back.
Problem coupled(double rate, double lag) {
  const Matrix a{{-0.3, 0.2}, {-0.1, -0.2}}, b{{0.5, 0.2}, {-0.3, 1.0}};
  return {.components = {{0.6, {1.0}}, {0.9, {-0.5}}},
          .derivatives = DenseLinearPart{a},
          .delays = linear_delays({lag}, a, {-rate * b}, Vec{{1.0, -0.5}})};
}

// With a term that does not look back, which predictors predict, and with lags between steps.
TEST_P(SchemesWithDelay, GrowWhereTheirSymbolsHaveGrowingModes) {
  for (const double m : {1.0, 2.0, 5.37, 9.0}) {
    for (const auto& problem :
         {std::function([m](double rate) { return delayed_equation(0.7, -0.4, -rate, m); }),
          std::function([m](double rate) { return coupled(rate, m); })}) {
      if (unsupported_reason(*GetParam(), problem(1.0), Grid{})) continue;
      double stable = 0.0, unstable = 4.0;
      while (unstable - stable > 1e-3) {
        const double middle = 0.5 * (stable + unstable);
        (is_linearly_stable(*GetParam(), problem(middle), 1.0) ? stable : unstable) = middle;
      }
      EXPECT_GT(stable, 0.1) << m;
      EXPECT_TRUE(decays(late_growth(*GetParam(), problem(0.95 * stable), 1.0, 2000))) << m << ' ' << stable;
      EXPECT_TRUE(grows(late_growth(*GetParam(), problem(1.05 * stable), 1.0, 2000))) << m << ' ' << stable;
    }
  }
}

std::vector<const Scheme*> schemes_with_delays() {
  auto some = schemes_with_symbol();
  std::erase_if(some, [](const Scheme* one) { return one->capabilities.discretises_equations; });
  return some;
}
INSTANTIATE_TEST_SUITE_P(, SchemesWithDelay, testing::ValuesIn(schemes_with_delays()), id_of_param);

// With the relative error delta of K^-1 at the crossing theta_0 = pi (1 - g/2) / m the end of the interval
// has the relative error Re delta + g Im delta / (pi (1 - g/2)): the rate of the rule for smooth functions. A
// prediction does not count, as the corrector looks back at results; in a chain it does, of links of order
// 1/M with the rate 1 + 1/M.
TEST(DelayedInterval, TendsToThatOfTheEquationAtTheRateOfTheRule) {
  struct Rule {
    std::string_view id;
    std::function<double(double g)> rate;
    int steps;
    std::vector<double> orders{0.3, 0.5, 0.9, 1.0};
  };
  const std::vector<Rule> rules{
      {"grunwald_letnikov", [](double) { return 1.0; }, 1024, {0.3, 0.9, 1.5}},
      {"l1", [](double g) { return g > 1.0 ? 1.0 : 2.0 - g; }, 1024, {0.3, 0.5, 0.9, 1.0, 1.5}},
      {"l1_2", [](double g) { return g > 1.0 ? 2.0 : 3.0 - g; }, 512, {0.3, 0.5, 0.9, 1.0, 1.5}},
      {"l2_1_sigma", [](double g) { return g > 1.0 ? 2.0 : 3.0 - g; }, 512, {0.3, 0.5, 0.9, 1.0, 1.5}},
      {"product_trapezoidal", [](double) { return 2.0; }, 2048, {0.3, 0.9, 1.5}},
      {"adams_pc", [](double) { return 2.0; }, 2048, {0.3, 0.9, 1.5}},
      {"decoupled_multi_order", [](double) { return 2.0; }, 2048, {0.5, 1.0, 1.5, 1.75}},
      {"commensurate_adams_pc", [](double) { return 1.25; }, 512, {0.75, 1.25, 1.75}},
      {"fractional_trapezoidal", [](double) { return 2.0; }, 1024},
      {"bdf2", [](double) { return 2.0; }, 1024},
      {"bdf3", [](double) { return 3.0; }, 512},
      {"bdf4", [](double) { return 4.0; }, 64},
      {"bdf5", [](double) { return 5.0; }, 64, {0.9, 1.0}},
      {"bdf6", [](double) { return 6.0; }, 32}};
  for (const auto& rule : rules) {
    for (const double g : rule.orders) {
      const auto error = [&](int m) {
        return real_stability_interval(named(rule.id), g, m) /
                   real_stability_interval(g, static_cast<double>(m)) -
               1.0;
      };
      EXPECT_NEAR(std::log2(error(rule.steps) / error(2 * rule.steps)), rule.rate(g), 0.1)
          << rule.id << ' ' << g << ' ' << error(rule.steps);
    }
  }
}

// |L(zeta)| <= 1 for a lag of m steps and for odd polynomials with the time in their middle interval (Strang
// 1962); not for those that end at the newest result.
TEST(DelayedPart, DoesNotMagnifyOscillationsFromFourStepsOn) {
  const auto largest = [](double steps) {
    const DelayedPart part({steps}, {Matrix::Ones(1, 1)}, 1.0, Vec::Ones(1));
    double size = 0.0;
    for (int i = 1; i <= 200; ++i) size = std::max(size, std::abs(part.at({0.0, pi * i / 200})(0, 0)));
    return size;
  };
  for (const double steps : {1.0, 2.0, 3.0, 4.1, 4.5, 17.3, 1000.9})
    EXPECT_LT(largest(steps), 1.0 + 1e-12) << steps;
  for (const double steps : {1.5, 2.5, 3.5}) EXPECT_GT(largest(steps), 1.005) << steps;
}

// Stable for all lags where a < -|b|, up to order 1: a + b zeta^m is in the left half plane, which belongs to
// the stability region of a rule. Formulas of backward differences have it up to the order at which their
// angle is a right one.
struct Kept {
  std::string_view id;
  double until;
};
const std::vector<Kept> kept{{"grunwald_letnikov", 1.0},
                             {"l1", 1.0},
                             {"l1_2", 1.0},
                             {"product_trapezoidal", 1.0},
                             {"bdf2", 1.0},
                             {"bdf3", 90.0 / 93.97},
                             {"bdf4", 90.0 / 106.65},
                             {"bdf5", 90.0 / 128.16},
                             {"bdf6", 90.0 / 162.16},
                             {"newton_gregory_2", 1.0},
                             {"newton_gregory_3", 0.5},
                             {"fractional_trapezoidal", 1.0}};

TEST(StabilityForAllDelays, IsKeptByImplicitRules) {
  std::mt19937 random(11);
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  for (const auto& [id, until] : kept) {
    for (int i = 0; i < 60; ++i) {
      const double g = uniform(0.2, until - 0.01), a = -std::pow(10.0, uniform(-2.0, 2.0)),
                   b = uniform(-0.999, 0.999) * a;
      const double m = i % 2 == 0 ? std::floor(uniform(1.0, 60.0)) : uniform(4.0, 60.0);
      const Problem problem = delayed_equation(g, a, b, m);
      if (unsupported_reason(named(id), problem, Grid{})) continue;
      EXPECT_EQ(count_growing_modes(named(id), problem, 1.0), 0)
          << id << ' ' << g << ' ' << a << ' ' << b << ' ' << m;
    }
  }
}

// Whether a + b zeta^m reaches a point of the boundary left of the imaginary axis, for an a < -|b| and an m.
bool is_lost(const Scheme& scheme, double g) {
  for (double theta = 0.1; theta < 3.1; theta += 0.1) {
    const ComplexValue z = root_locus(scheme, g, theta).front();
    if (z.real() > -0.01 * std::abs(z)) continue;
    const double a = 0.75 * std::norm(z) / z.real(), b = 0.5 * (std::abs(z - a) - a);
    for (int m = 16; m < 200; ++m) {
      if (!is_linearly_stable(scheme, delayed_equation(g, a, b, m), 1.0) ||
          !is_linearly_stable(scheme, delayed_equation(g, a, -b, m), 1.0)) {
        return true;
      }
    }
  }
  return false;
}

TEST(StabilityForAllDelays, IsLostBeyond) {
  for (const auto& [id, until] : kept) {
    if (until == 1.0 || !id.starts_with("bdf")) continue;
    EXPECT_TRUE(is_lost(named(id), std::min(1.0, until + 0.04))) << id;
  }
  const auto grow = [](std::string_view id, double a, double b, int m) {
    return count_growing_modes(named(id), delayed_equation(0.5, a, b, m), 1.0).value_or(0) > 0;
  };
  // A prediction ends the region at z = -Gamma(g+2); L2-1-sigma takes y between two results for a and a
  // polynomial through eight for b, and the first is the smaller one at zeta = -1.
  EXPECT_TRUE(grow("adams_pc", -1.5, 0.1, 4));
  EXPECT_TRUE(grow("l2_1_sigma", -100.0, 99.0, 4) || grow("l2_1_sigma", -100.0, -99.0, 4));
}

// D^0.9 x = -60 x + 20 y(t - 1) + [sin(x(t - 1)) y], D^0.8 y = x - y: stable, but not for a predictor with
// steps above (Gamma(2.9) / 60)^(1/0.9) = 0.022.
Problem stiff_with_delay(bool is_linear) {
  const auto rhs = [is_linear](double t, In y, const Past& past, Out f) {
    Vec earlier(2);
    past(t - 1.0, earlier);
    f << -60.0 * y[0] + 20.0 * earlier[1], y[0] - y[1];
    if (!is_linear) f[0] += std::sin(earlier[0]) * y[1];
  };
  return {.components = {{0.9, {1.0}}, {0.8, {1.0}}},
          .derivatives = is_linear ? Derivatives{DenseLinearPart{Matrix{{-60.0, 0.0}, {1.0, -1.0}}}}
                                   : Derivatives{NoDerivatives{}},
          .end = 5.0,
          .delays = {.lags = {1.0}, .before = [](double, Out y) { y.setOnes(); }, .rhs = rhs}};
}

TEST(UnstableModes, AreFoundWithDelaysWhereStepsAreTooLong) {
  const auto warns = [](std::string_view id, const Problem& problem, int steps) {
    const Grid grid{problem.end, steps};
    const Options options;
    const auto path = named(id).solve(problem, grid, options);
    EXPECT_EQ(path.status, SolveStatus::finished);
    return unstable_modes({named(id), problem, grid, options, path}).has_value();
  };
  for (const bool is_linear : {true, false}) {
    const Problem problem = stiff_with_delay(is_linear);
    EXPECT_TRUE(warns("adams_pc", problem, 210)) << is_linear;
    EXPECT_FALSE(warns("adams_pc", problem, 250)) << is_linear;
    EXPECT_FALSE(warns("l1", problem, 100)) << is_linear;
    EXPECT_FALSE(warns("product_trapezoidal", problem, 100)) << is_linear;
  }
  // Growing modes of the equation itself are none of the scheme.
  const Problem growing = delayed_equation(0.9, 0.0, -2.5, 1.0, 20.0);
  EXPECT_EQ(count_growing_modes(growing, 0.01), 2);
  EXPECT_FALSE(warns("adams_pc", growing, 100));
}

}  // namespace
}  // namespace fde::bench
