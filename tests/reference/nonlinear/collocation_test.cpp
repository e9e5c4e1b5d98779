// SPDX-License-Identifier: MIT
#include "fdebench/reference/nonlinear/collocation.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <limits>

#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"
#include "support/message_of.hpp"

namespace fde::reference {
namespace {

using ::testing::HasSubstr;

Problem scalar(double order, std::vector<double> initial, double end,
               std::function<double(double, double)> rhs) {
  return {.components = {{order, std::move(initial)}},
          .rhs = [rhs = std::move(rhs)](double t, In y, Out f) { f[0] = rhs(t, y[0]); },
          .end = end};
}

// D^order y = -y, y(0) = 1, y'(0) = 0.
Problem relaxation(double order, double end) {
  return scalar(order, order > 1.0 ? std::vector{1.0, 0.0} : std::vector{1.0}, end,
                [](double, double y) { return -y; });
}

Problem brusselator() {
  const auto rhs = [](double, In y, Out f) {
    const double reaction = y[0] * y[0] * y[1];
    f << 1.0 - 5.0 * y[0] + reaction, 4.0 * y[0] - reaction;
  };
  const DenseJacobian jacobian{[](double, In y, OutMatrix j) {
    const double xy = 2.0 * y[0] * y[1], xx = y[0] * y[0];
    j << xy - 5.0, xx, 4.0 - xy, -xx;
  }};
  return {.components = {{0.8, {1.2}}, {0.8, {2.8}}}, .rhs = rhs, .derivatives = jacobian, .end = 50.0};
}

// Damped fractional pendulum: orders beta, 1 - beta, alpha - 1, 2 - alpha of angle to acceleration.
Problem pendulum(double alpha, double beta, double end) {
  const double mu = 0.06 * std::pow(0.8, alpha), lambda = 0.1 * 0.8, nu = 0.1 * std::pow(0.8, beta);
  return {
      .components = {{beta, {1.0}}, {1.0 - beta, {0.0}}, {alpha - 1.0, {-0.3}}, {2.0 - alpha, {0.0}}},
      .rhs = [=](double, In y,
                 Out f) { f << y[1], y[2], y[3], -std::sin(y[0]) - mu * y[3] - lambda * y[2] - nu * y[1]; },
      .end = end};
}

// The first step of a grid graded like n^10 ends at 1e-57, where a solution of order 0.05 has changed by
// 1e-3.
TEST(Collocation, KnowsTheFirstStepsOfGradedGrids) {
  for (const double order : {0.05, 0.1, 0.3, 0.5}) {
    const Reference reference = reference_solution(relaxation(order, 1.0));
    for (const double t : {1e-57, 1e-45, 1e-33, 1e-25, 1e-10}) {
      const auto [value, bound] = reference.at(t);
      EXPECT_NEAR(value[0], mittag_leffler(order, 1.0, -std::pow(t, order)), bound[0] + 1e-15) << order;
      EXPECT_LT(bound[0], 1e-12) << "order " << order << ", t = " << t;
    }
  }
}

// E_order(-t^order) from its power series in mpmath with 400 digits.
struct MittagLeffler {
  double order, t, value;
};

class Relaxation : public testing::TestWithParam<MittagLeffler> {};

TEST_P(Relaxation, IsTheMittagLefflerFunctionWithinTheEstimate) {
  const auto [order, t, value] = GetParam();
  const ReferenceValue known = reference_solution(relaxation(order, 5.0)).at(t);
  EXPECT_NEAR(known.value[0], value, 1e-14);
  EXPECT_NEAR(known.value[0], value, known.bound[0]);
  EXPECT_LT(known.bound[0], 1e-13);
}

INSTANTIATE_TEST_SUITE_P(Orders, Relaxation,
                         testing::ValuesIn<MittagLeffler>(
                             {{0.2, 0.001, 0.78325996937213563276}, {0.2, 0.1, 0.58715676886206224599},
                              {0.2, 1.0, 0.47110068893348294927},   {0.2, 5.0, 0.39101477456746502669},
                              {0.5, 0.001, 0.9652942200040563267},  {0.5, 0.1, 0.72357843847761549756},
                              {0.5, 1.0, 0.42758357615580700441},   {0.5, 5.0, 0.23232629437646507431},
                              {0.8, 0.001, 0.9957367026175417764},  {0.8, 0.1, 0.84614678862630890532},
                              {0.8, 1.0, 0.38694857861897685146},   {0.8, 5.0, 0.087827430293285084475},
                              {1.0, 0.001, 0.99900049983337499167}, {1.0, 0.1, 0.90483741803595957316},
                              {1.0, 1.0, 0.3678794411714423216},    {1.0, 5.0, 0.0067379469990854670966},
                              {1.3, 0.001, 0.99989210055540249496}, {1.3, 0.1, 0.95771248461766722418},
                              {1.3, 1.0, 0.36894184906938253399},   {1.3, 5.0, -0.069759584576280238137},
                              {1.7, 0.001, 0.99999485767753155441}, {1.7, 0.1, 0.98712227477595220906},
                              {1.7, 1.0, 0.44454443263222341465},   {1.7, 5.0, 0.016646430823213578752}}));

// Diethelm, Ford and Freed (2004): a nonlinear equation with an exact solution that contains t^(order/2) and
// t^order.
class Manufactured : public testing::TestWithParam<double> {};

TEST_P(Manufactured, MatchesItsExactSolutionWithinTheEstimate) {
  const double g = GetParam();
  const auto rhs = [g](double t, double y) {
    return 40320.0 / std::tgamma(9.0 - g) * std::pow(t, 8.0 - g) -
           3.0 * std::tgamma(5.0 + g / 2) / std::tgamma(5.0 - g / 2) * std::pow(t, 4.0 - g / 2) +
           2.25 * std::tgamma(g + 1.0) + std::pow(1.5 * std::pow(t, g / 2) - std::pow(t, 4), 3) -
           std::pow(std::abs(y), 1.5);
  };
  const auto initial = g > 1.0 ? std::vector{0.0, 0.0} : std::vector{0.0};
  const Reference reference = reference_solution(scalar(g, initial, 1.0, rhs));
  for (const double t : {1e-6, 1e-3, 0.1, 0.5, 0.9, 1.0}) {
    const double exact = std::pow(t, 8) - 3.0 * std::pow(t, 4.0 + g / 2) + 2.25 * std::pow(t, g);
    const ReferenceValue known = reference.at(t);
    EXPECT_NEAR(known.value[0], exact, 1e-12 * exact) << t;
    // 8e-15: the coefficients and terms of the right-hand side are rounded too.
    EXPECT_NEAR(known.value[0], exact, known.bound[0] + 8e-15) << t;
  }
}

INSTANTIATE_TEST_SUITE_P(Orders, Manufactured, testing::Values(0.2, 0.5, 0.8, 1.3, 1.7));

TEST(ReferenceSolution, ResolvesTheSpikesOfTheBrusselator) {
  const ReferenceValue known = reference_solution(brusselator()).at(50.0);
  EXPECT_NEAR(known.value[0], 0.3864061360150, 1e-12);
  EXPECT_LT(known.bound.maxCoeff(), 1e-12);
}

// An independent check of the solution: tanh-sinh and Gauss quadrature of its Volterra integral.
TEST(ReferenceSolution, SatisfiesTheVolterraEquation) {
  const Problem problem = brusselator();
  const Reference reference = reference_solution(problem);
  const double order = 0.8, t = 20.0;
  const int pieces = 600;
  const double width = t / pieces;
  const auto rhs_at = [&](double s) {
    Vec f(2);
    problem.rhs(s, reference.at(std::min(s, t)).value, f);
    return f[0];
  };
  const auto integrand = [&](double s) { return std::pow(t - s, order - 1.0) * rhs_at(s); };
  boost::math::quadrature::tanh_sinh<double> singular;
  double integral = singular.integrate(integrand, 0.0, width, 1e-15);
  for (int k = 1; k + 1 < pieces; ++k) {
    integral += boost::math::quadrature::gauss<double, 15>::integrate(integrand, k * width, (k + 1) * width);
  }
  // s = t - u^(1/order) on the last piece
  integral += singular.integrate([&](double u) { return rhs_at(t - std::pow(u, 1.0 / order)) / order; }, 0.0,
                                 std::pow(t - (pieces - 1) * width, order), 1e-15);
  EXPECT_NEAR(reference.at(t).value[0], 1.2 + integral / std::tgamma(order), 1e-13);
}

TEST(ReferenceSolution, KeepsTheEnergyOfAPendulum) {
  const Problem problem{.components = {{1.0, {1.0}}, {1.0, {-0.3}}},
                        .rhs = [](double, In y, Out f) { f << y[1], -std::sin(y[0]); },
                        .end = 50.0};
  const Reference reference = reference_solution(problem);
  const auto energy = [&](double t) {
    const Vec y = reference.at(t).value;
    return y[1] * y[1] / 2 - std::cos(y[0]);
  };
  for (const double t : {0.1, 1.0, 7.3, 20.0, 50.0}) {
    EXPECT_NEAR(energy(t), energy(0.0), 1e-13) << t;
  }
}

TEST(ReferenceSolution, SecondOrderIsTheCosine) {
  const Reference reference = reference_solution(relaxation(2.0, 50.0));
  for (const double t : {0.3, 4.0, 50.0}) {
    const ReferenceValue known = reference.at(t);
    EXPECT_NEAR(known.value[0], std::cos(t), 1e-13);
    EXPECT_NEAR(known.value[0], std::cos(t), known.bound[0]);
  }
}

// The chain of four orders with sum 2 of the pendulum, undamped and linear: D^2 y = -y.
TEST(ReferenceSolution, ComposesAChainOfOrders) {
  for (const auto& [alpha, beta] : {std::pair{1.5, 0.5}, {1.25, 0.75}, {1.9, 0.1}}) {
    Problem problem = pendulum(alpha, beta, 20.0);
    problem.components[2].initial = {0.0};
    problem.rhs = [](double, In y, Out f) { f << y[1], y[2], y[3], -y[0]; };
    const Reference reference = reference_solution(problem);
    for (const double t : {1e-3, 1.0, 5.0, 20.0}) {
      const ReferenceValue known = reference.at(t);
      EXPECT_NEAR(known.value[0], std::cos(t), known.bound[0]) << t;
      EXPECT_NEAR(known.value[2], -std::sin(t), known.bound[2]) << t;
      EXPECT_LT(known.bound.maxCoeff(), 1e-12);
    }
  }
}

// Different ends give different panels: the values agree within the sum of both estimates.
TEST(ReferenceSolution, DoesNotDependOnTheEnd) {
  for (const auto& [alpha, beta] : {std::pair{1.5, 0.5}, {1.25, 0.75}, {1.9, 0.1}}) {
    const ReferenceValue shorter = reference_solution(pendulum(alpha, beta, 7.0)).at(5.0);
    const ReferenceValue longer = reference_solution(pendulum(alpha, beta, 20.0)).at(5.0);
    EXPECT_LT(longer.bound.maxCoeff(), 1e-13);
    EXPECT_TRUE(
        ((shorter.value - longer.value).cwiseAbs().array() <= (shorter.bound + longer.bound).array()).all());
  }
}

TEST(ReferenceSolution, TakesAnyFormOfTheJacobian) {
  const auto rhs = [](double t, In y, Out f) { f << y[1], std::cos(t) - 4.0 * y[0] - y[1]; };
  const Matrix matrix{{0.0, 1.0}, {-4.0, -1.0}};
  const Problem differences{.components = {{0.6, {1.0}}, {0.9, {0.0}}}, .rhs = rhs, .end = 10.0};
  Problem linear = differences, analytic = differences;
  linear.derivatives = DenseLinearPart{matrix};
  analytic.derivatives = DenseJacobian{[matrix](double, In, OutMatrix jacobian) { jacobian = matrix; }};
  const Vec expected = reference_solution(differences).at(10.0).value;
  EXPECT_LT((reference_solution(linear).at(10.0).value - expected).cwiseAbs().maxCoeff(), 1e-14);
  EXPECT_LT((reference_solution(analytic).at(10.0).value - expected).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(ReferenceSolution, FollowsAPermutationOfItsComponents) {
  const Problem problem = brusselator();
  Problem swapped{.components = {{0.8, {2.8}}, {0.8, {1.2}}}, .rhs = {}, .end = 10.0};
  swapped.rhs = [&](double t, In y, Out f) {
    Vec inner(2);
    problem.rhs(t, y.reverse(), inner);
    f = inner.reverse();
  };
  const Vec straight = reference_solution(problem).at(10.0).value;
  EXPECT_LT((reference_solution(swapped).at(10.0).value.reverse() - straight).cwiseAbs().maxCoeff(), 1e-13);
}

// The estimate includes the rounding noise of stiff terms: y = cos t - e^(-rate t) + O(1/rate).
TEST(ReferenceSolution, EstimatesTheNoiseOfStiffTerms) {
  const double rate = 1e6, t = 5.0;
  const Reference reference =
      reference_solution(scalar(1.0, {0.0}, t, [=](double s, double y) { return rate * (std::cos(s) - y); }));
  const double exact = rate * (rate * std::cos(t) + std::sin(t)) / (1.0 + rate * rate);
  const ReferenceValue known = reference.at(t);
  EXPECT_NEAR(known.value[0], exact, known.bound[0]);
  EXPECT_LT(known.bound[0], 1e-8);
}

// 1 - cos t has no correct digits near 0.
TEST(ReferenceSolution, TakesAForcingThatCancelsAtTheStart) {
  const auto forcing = [](double t, double) { return 1.0 - std::cos(t); };
  const Reference reference = reference_solution(scalar(1.0, {0.0}, 10.0, forcing));
  for (const double t : {1e-8, 1e-3, 1.0, 10.0}) {
    const ReferenceValue known = reference.at(t);
    EXPECT_NEAR(known.value[0], t - std::sin(t), known.bound[0] + 1e-16 * t) << t;
    EXPECT_LT(known.bound[0], 1e-13);
  }
}

TEST(ReferenceSolution, StartsAtTheInitialValues) {
  const ReferenceValue known = reference_solution(pendulum(1.5, 0.5, 1.0)).at(0.0);
  EXPECT_EQ(known.value, (Vec(4) << 1.0, 0.0, -0.3, 0.0).finished());
  EXPECT_EQ(known.bound, Vec::Zero(4));
}

TEST(ReferenceSolution, RefusesTimesOutsideTheProblem) {
  const Reference reference = reference_solution(relaxation(0.5, 1.0));
  for (const double t : {-1e-9, 1.0 + 1e-9, std::numeric_limits<double>::infinity(), std::nan("")}) {
    EXPECT_THROW(reference.at(t), std::invalid_argument) << t;
  }
}

TEST(ReferenceSolution, NamesTheTimeOfABlowUp) {
  const Problem problem = scalar(1.0, {4.0}, 1.0, [](double, double y) { return y * y; });  // 4 / (1 - 4 t)
  bench::expect_message<std::runtime_error>([&] { reference_solution(problem); }, "t = 0.25");
}

TEST(ReferenceSolution, NamesWhatIsWrongWithAProblem) {
  const auto message = [](const Problem& problem) {
    return bench::message_of<std::invalid_argument>([&] { reference_solution(problem); });
  };
  EXPECT_THAT(message(scalar(2.5, {0.0, 0.0, 0.0}, 1.0, {})),
              HasSubstr("component 0 needs an order in [0, 2], it has 2.5"));
  EXPECT_THAT(message(scalar(1.5, {0.0}, 1.0, {})),
              HasSubstr("component 0 needs ceil(order) initial values"));
  EXPECT_THAT(message(scalar(0.5, {0.0}, -1.0, {})), HasSubstr("end"));
  EXPECT_THAT(message(Problem{}), HasSubstr("no components"));
}

}  // namespace
}  // namespace fde::reference
