// SPDX-License-Identifier: MIT
#include "fdebench/reference/linear/linear_equation.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"
#include "support/worst_row.hpp"

namespace fde::reference {
namespace {

using Value = std::complex<double>;

LinearEquation relaxation(double gamma, double lambda, std::vector<double> initial) {
  return {{{1.0, gamma}, {-lambda, 0.0}}, std::move(initial)};
}

LinearEquation bagley_torvik() {
  return {{{1.0, 2.0}, {0.5, 1.5}, {0.5, 0.0}}, {0.0, 0.0}, {{8.0, 0.0, 0.0}, {-8.0, 0.0, 1.0}}};
}

struct NamedRelaxation {
  const char* name;
  double gamma, lambda;
};

class RelaxationEquation : public testing::TestWithParam<NamedRelaxation> {};

// D^gamma u = lambda u: u = E_gamma(lambda t^gamma). The tolerance includes the rounding of the argument.
TEST_P(RelaxationEquation, IsSolvedByTheMittagLefflerFunction) {
  const auto& [name, gamma, lambda] = GetParam();
  std::vector<double> initial{1.0};
  if (gamma > 1.0) initial.push_back(0.0);
  const Reference solution = linear_reference(relaxation(gamma, lambda, initial), {0.0, gamma});
  bench::WorstRow worst;
  for (const double t : {0.0, 1e-3, 0.1, 1.0, 10.0, 1e3}) {
    const double z = lambda * std::pow(t, gamma);
    const auto [exact, bound] = mittag_leffler(gamma, 1.0, Value(z));
    if (!std::isfinite(bound)) continue;
    const double slope = z * (mittag_leffler(gamma, 0.0, z) / (gamma * (z == 0.0 ? 1.0 : z)));  // z E'
    const double allowed = 1e-15 * (std::abs(exact.real()) + 3.0 * std::abs(slope)) + 1e-40;
    const ReferenceValue known = solution.at(t);
    worst.update(known.value[0], exact.real(), allowed, fmt::format("u({})", t));
    worst.update(known.value[1], lambda * exact.real(), std::abs(lambda) * allowed,
                 fmt::format("D^gamma u({})", t));
    const double scale = std::max(std::abs(exact.real()), gamma * std::abs(slope));  // max(|u|, |t u'|)
    EXPECT_LE(known.bound[0], 1e-15 * scale + 1e-50) << t;
  }
  expect_within(worst);
}

INSTANTIATE_TEST_SUITE_P(
    LinearEquation, RelaxationEquation,
    testing::Values(NamedRelaxation{"Slow", 0.25, -1.0}, NamedRelaxation{"Half", 0.5, -2.0},
                    NamedRelaxation{"NearlyExponential", 0.999, -3.0}, NamedRelaxation{"Stiff", 0.5, -1e8},
                    NamedRelaxation{"Growing", 0.75, 10.0}, NamedRelaxation{"Exponential", 1.0, -3.0},
                    NamedRelaxation{"Oscillating", 1.5, -4.0}, NamedRelaxation{"NearlyHarmonic", 1.99, -1.0}),
    [](const auto& test) { return std::string(test.param.name); });

// If a zero were missed or found twice, the two functions would differ by a term e^(s* t).
TEST(LinearEquation, FindsEveryZero) {
  std::mt19937_64 random(
      20240517);  // NOLINT(bugprone-random-generator-seed,cert-msc51-cpp): the same rows each time
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  bench::WorstRow worst;
  for (int i = 0; i < 100; ++i) {
    const double gamma = 1.0 + unit(random), lambda = -std::pow(10.0, 3.0 * unit(random) - 1.0);
    const Reference solution = linear_reference(relaxation(gamma, lambda, {1.0, 0.0}), {0.0});
    worst.update(solution.at(1.0).value[0], mittag_leffler(gamma, 1.0, lambda), 1e-13,
                 fmt::format("gamma {}, lambda {}", gamma, lambda));
  }
  expect_within(worst);
}

// D^nu q + w2 q = c0 + c1 t: q = q0 E_nu + v0 t E_{nu,2} + sum_k c_k Gamma(k+1) t^(nu+k) E_{nu,nu+k+1}(-w2
// t^nu)
TEST(FractionalOscillator, IsSolvedByMittagLefflerFunctions) {
  constexpr double nu = 1.5, w2 = 2.0;
  const Reference solution =
      linear_reference({{{1.0, nu}, {w2, 0.0}}, {1.0, 0.5}, {{1.0, 0.0}, {0.25, 1.0}}}, {0.0, nu});
  bench::WorstRow worst;
  for (const double t : {0.0, 0.25, 1.0, 4.0, 16.0, 100.0}) {  // t^nu is exact at the squares
    const double power = std::pow(t, nu), z = -w2 * power;
    const double exact = mittag_leffler(nu, 1.0, z) + 0.5 * t * mittag_leffler(nu, 2.0, z) +
                         power * mittag_leffler(nu, nu + 1.0, z) +
                         0.25 * power * t * mittag_leffler(nu, nu + 2.0, z);
    const ReferenceValue known = solution.at(t);
    worst.update(known.value[0], exact, 1e-15 * (1.0 + std::abs(exact)), fmt::format("q({})", t));
    worst.update(known.value[1], 1.0 + 0.25 * t - w2 * exact, 2e-15 * (2.0 + t),
                 fmt::format("D^nu q({})", t));
  }
  expect_within(worst);
}

struct IntegerOrders {
  const char* name;
  LinearEquation equation;
  double (*solution)(double t);
  double (*derivative)(double t);
};

class IntegerOrderEquation : public testing::TestWithParam<IntegerOrders> {};

TEST_P(IntegerOrderEquation, HasItsElementarySolution) {
  const auto& [name, equation, solution, derivative] = GetParam();
  const Reference exact = linear_reference(equation, {0.0, 1.0});
  bench::WorstRow worst;
  for (const double t : {0.0, 0.0625, 0.5, 2.0, 5.0, 17.0}) {
    const ReferenceValue known = exact.at(t);
    worst.update(known.value[0], solution(t), 1e-15 * std::abs(solution(t)), fmt::format("u({})", t));
    worst.update(known.value[1], derivative(t), 1e-15 * std::abs(derivative(t)), fmt::format("u'({})", t));
  }
  expect_within(worst);
}

const std::vector<IntegerOrders> integer_orders{{"Harmonic",
                                                 {{{1.0, 2.0}, {1.0, 0.0}}, {1.0, 0.0}},
                                                 [](double t) { return std::cos(t); },
                                                 [](double t) { return -std::sin(t); }},
                                                {"CriticallyDamped",
                                                 {{{1.0, 2.0}, {2.0, 1.0}, {1.0, 0.0}}, {1.0, 0.0}},
                                                 [](double t) { return (1.0 + t) * std::exp(-t); },
                                                 [](double t) { return -t * std::exp(-t); }},
                                                {"Overdamped",
                                                 {{{1.0, 2.0}, {3.0, 1.0}, {2.0, 0.0}}, {1.0, -1.0}},
                                                 [](double t) { return std::exp(-t); },
                                                 [](double t) { return -std::exp(-t); }},
                                                {"DoubleZeroToTheRight",
                                                 {{{1.0, 2.0}, {-2.0, 1.0}, {1.0, 0.0}}, {0.0, 1.0}},
                                                 [](double t) { return t * std::exp(t); },
                                                 [](double t) { return (1.0 + t) * std::exp(t); }},
                                                {"ForcedExponential",
                                                 {{{1.0, 1.0}, {1.0, 0.0}}, {2.0}, {{1.0, 0.0}}},
                                                 [](double t) { return 1.0 + std::exp(-t); },
                                                 [](double t) { return -std::exp(-t); }},
                                                {"ZeroTermsDoNotCount",
                                                 {{{1.0, 1.0}, {0.0, 2.0}, {0.0, 1.5}, {1.0, 0.0}}, {1.0}},
                                                 [](double t) { return std::exp(-t); },
                                                 [](double t) { return -std::exp(-t); }}};

INSTANTIATE_TEST_SUITE_P(LinearEquation, IntegerOrderEquation, testing::ValuesIn(integer_orders),
                         [](const auto& test) { return std::string(test.param.name); });

struct Row {
  double t;
  std::vector<double> values;
};

// mpmath 1.3, invertlaplace by Talbot's contour at 60 digits with 120 and 160 nodes, which agree to 60
// digits.
TEST(BagleyTorvik, MeetsAnIndependentInversion) {
  const std::vector<Row> rows{
      {0.1, {0.036487479900904341841, 2.4944000836416553662, 6.7345562182287201460}},
      {1.5, {5.2260953489377097183, 0.62671476434272268212, -2.9264050566402162002}},
      {5.0, {2.9439356637512437760, -2.2955108166567549372, -0.32421242354724441939}},
      {20.0, {-1.4843294639920563447, 0.61465193165511622462, 0.43483876616847006004}},
      {50.0, {0.0084969608995445852931, -0.020712550266463374095, 0.0061077946834593944010}},
  };
  const Reference solution = linear_reference(bagley_torvik(), {0.0, 1.5, 2.0});
  bench::WorstRow worst;
  for (const auto& [t, values] : rows) {
    const ReferenceValue known = solution.at(t);
    for (std::size_t j = 0; j < values.size(); ++j) {
      worst.update(known.value[static_cast<Eigen::Index>(j)], values[j], 1e-15 * std::abs(values[j]),
                   fmt::format("component {} at {}", j, t));
    }
  }
  expect_within(worst);
}

TEST(BagleyTorvik, SolvesItsEquation) {
  const Reference solution = linear_reference(bagley_torvik(), {0.0, 1.5, 2.0});
  bench::WorstRow worst;
  for (const double t : {0.0, 0.01, 0.5, 0.99, 1.0, 1.01, 3.0, 10.0, 50.0}) {
    const Vec u = solution.at(t).value;
    worst.update(u[2] + 0.5 * u[1] + 0.5 * u[0], t < 1.0 ? 8.0 : 0.0, 1e-14, fmt::format("t = {}", t));
  }
  expect_within(worst);
}

// u'' + 0.043 D^1.5 u + 0.08 u' + 0.09 D^0.5 u + u = 0, u(0) = 1: mpmath as above.
TEST(DampedOscillator, MeetsAnIndependentInversion) {
  const Reference solution =
      linear_reference({{{1.0, 2.0}, {0.043, 1.5}, {0.08, 1.0}, {0.09, 0.5}, {1.0, 0.0}}, {1.0, 0.0}}, {0.0});
  bench::WorstRow worst;
  for (const auto& [t, values] : std::vector<Row>{{1.0, {0.56928013702285318479}},
                                                  {5.0, {0.18237137944541475918}},
                                                  {20.0, {0.052918320126998222225}},
                                                  {50.0, {0.019409717529782916529}}})
    worst.update(solution.at(t).value[0], values[0], 1e-15 * std::abs(values[0]), fmt::format("u({})", t));
  expect_within(worst);
  EXPECT_EQ(solution.digits(20.0, 28)[0].value, "0.05291832012699822222537727892");
}

TEST(LinearEquation, StartsWithTheLimitFromTheRight) {
  const Reference bagley = linear_reference(bagley_torvik(), {0.0, 1.0, 1.5, 2.0});
  EXPECT_EQ(bagley.at(0.0).value, (Vec(4) << 0.0, 0.0, 0.0, 8.0).finished());
  EXPECT_NEAR(bagley.at(1.0).value[3], bagley.at(1.0 - 1e-9).value[3] - 8.0, 1e-3);  // the load jumps at 1
  const Reference half = linear_reference(relaxation(0.5, -3.0, {2.0}), {0.0, 0.25, 0.5, 1.0});
  const Vec start = half.at(0.0).value;
  EXPECT_EQ(start.head(3), (Vec(3) << 2.0, 0.0, -6.0).finished());
  EXPECT_EQ(start[3], -std::numeric_limits<double>::infinity());  // u' ~ -6 t^(-1/2) / Gamma(1/2)
  const Reference second =
      linear_reference({{{2.0, 2.0}, {1.0, 1.0}, {1.0, 0.0}}, {3.0, 5.0}}, {0.0, 1.0, 1.5, 2.0});
  EXPECT_EQ(second.at(0.0).value, (Vec(4) << 3.0, 5.0, 0.0, -4.0).finished());
}

TEST(LinearEquation, GrowsToInfinityBeyondDouble) {
  const Reference growing = linear_reference(relaxation(0.5, 10.0, {-1.0}), {0.0});
  EXPECT_EQ(growing.at(1e3).value[0], -std::numeric_limits<double>::infinity());
  EXPECT_EQ(growing.digits(1e3, 5)[0].value.substr(7), "e+43429");  // -2 e^100000
}

TEST(LinearEquation, EquilibriumStays) {
  const Reference solution = linear_reference({{{1.0, 0.5}, {1.0, 0.0}}, {1.0}, {{1.0, 0.0}}}, {0.0, 0.5});
  for (const double t : {0.0, 0.1, 10.0}) {
    EXPECT_EQ(solution.at(t).value[0], 1.0);
    EXPECT_NEAR(solution.at(t).value[1], 0.0, 1e-30);
  }
}

TEST(LinearEquation, DigitsAgreeWithDoubles) {
  const Reference solution = linear_reference(bagley_torvik(), {0.0, 1.5, 2.0});
  for (const double t : {0.3, 1.0, 7.0}) {
    const ReferenceValue known = solution.at(t);
    const auto digits = solution.digits(t, 40);
    for (std::size_t j = 0; j < digits.size(); ++j) {
      const auto i = static_cast<Eigen::Index>(j);
      EXPECT_NEAR(std::stod(digits[j].value), known.value[i],
                  1.1 * known.bound[i] + 1e-16 * std::abs(known.value[i]));
      EXPECT_LE(std::stod(digits[j].bound), 1e-38 * std::abs(known.value[i]));
    }
  }
}

TEST(LinearEquation, RejectsWhatItCannotSolve) {
  EXPECT_THROW(linear_reference({{{1.0, 0.0}}, {}}, {0.0}), std::invalid_argument);
  EXPECT_THROW(linear_reference({{{1.0, 10.5}, {1.0, 0.0}}, std::vector(11, 1.0)}, {0.0}),
               std::invalid_argument);
  EXPECT_THROW(linear_reference({{{1.0, 1.5}, {1.0, 0.0}}, {1.0}}, {0.0}), std::invalid_argument);
  EXPECT_THROW(linear_reference(relaxation(0.5, -1.0, {1.0}), {1.5}), std::invalid_argument);
  EXPECT_THROW(linear_reference({{{1.0, 0.5}, {1.0, 0.0}}, {1.0}, {{1.0, -1.0}}}, {0.0}),
               std::invalid_argument);
  EXPECT_THROW(linear_reference(relaxation(0.5, -1.0, {1.0}), {0.0}).at(-1.0), std::invalid_argument);
}

}  // namespace
}  // namespace fde::reference
