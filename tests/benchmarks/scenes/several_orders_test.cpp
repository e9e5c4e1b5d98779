// SPDX-License-Identifier: MIT
// Equations of several orders and the limits of the orders of damping, each against an independent value:
// power series in t^(1/10), Talbot's inversion of the transform and Taylor's method, in 30 digits.

#include <gtest/gtest.h>

#include <cmath>

#include "fdebench/benchmarks/references/reference_of.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

using Numbers = std::vector<double>;

Vec reference_at(std::string_view scene, const ParameterValues& values, double t) {
  Scene made = scene_of(scene, values);
  made.problem.end = t;
  return reference_of(made).at(t).value;
}

TEST(MultiTerm, WithAllKindsOfTermsIsItsSeries) {
  EXPECT_NEAR(reference_at("multi_term", {}, 0.5)[0], 0.796392178397158198, 1e-13);
  EXPECT_NEAR(reference_at("multi_term", {}, 1.0)[0], 0.519406339214479610, 1e-13);
  Scene scene = scene_of("multi_term");
  scene.problem.end = 1.0;
  const auto path = solve("product_trapezoidal", scene.problem, 4096, {.output_times = {1.0}});
  EXPECT_NEAR(path.y(0, 0), 0.519406339214479610, 5e-6);
}

// D^(3/2) x + 0.4 x' + 0.3 D^(1/2) x + x = 1.
TEST(MultiTerm, IsWangsEquationWithAnotherLeadingOrder) {
  const ParameterValues wang{{"order", 1.5},      {"alpha", Numbers{}},   {"b", Numbers{}},
                             {"c", 0.4},          {"beta", Numbers{0.5}}, {"d", Numbers{0.3}},
                             {"force", "linear"}, {"load", "constant"},   {"g0", 1.0}};
  EXPECT_NEAR(reference_at("multi_term", wang, 2.0)[0], 0.829656987952606707, 1e-15);
}

// D^1.9 x + 0.05 D^1.7 x + 0.1 D^1.4 x + 0.2 D^1.1 x + 0.1 D^0.4 x + x = 0.3 t.
TEST(MultiTerm, IsDiethelmsEquationWithAsManyTermsAsItHas) {
  const ParameterValues diethelm{{"order", 1.9},
                                 {"alpha", Numbers{1.7, 1.4, 1.1}},
                                 {"b", Numbers{0.05, 0.1, 0.2}},
                                 {"c", 0.0},
                                 {"beta", Numbers{0.4}},
                                 {"d", Numbers{0.1}},
                                 {"force", "linear"},
                                 {"load", "ramp"}};
  EXPECT_NEAR(reference_at("multi_term", diethelm, 2.0)[0], -0.0997143022010123588, 1e-15);
  EXPECT_EQ(scene_of("multi_term", diethelm).outputs.names,
            (std::vector<std::string>{"u", "Dbeta1_u", "du", "Dalpha1_u", "Dalpha2_u", "Dalpha3_u"}));
}

// The pendulum of Yin, Liu & Anh is the multi-term equation with one term of each kind.
TEST(MultiTerm, WithOneTermOfEachKindIsThePendulum) {
  const double tau = 0.8;
  const ParameterValues one{
      {"alpha", Numbers{1.5}}, {"b", Numbers{0.06 * std::pow(tau, 1.5)}}, {"c", 0.1 * tau},
      {"beta", Numbers{0.5}},  {"d", Numbers{0.1 * std::sqrt(tau)}},      {"load", "none"}};
  const Vec pendulum = reference_at("pendulum", {}, 5.0), several = reference_at("multi_term", one, 5.0);
  EXPECT_LT((pendulum - several).cwiseAbs().maxCoeff(), 1e-13);
}

TEST(MultiTerm, RefusesListsThatDoNotFit) {
  const auto making = [](const ParameterValues& values) { return [=] { scene_of("multi_term", values); }; };
  expect_message(making({{"b", Numbers{1.0}}}), "b = 1: must be as many numbers as alpha");
  expect_message(making({{"beta", Numbers{0.3, 1.2}}}),
                 "beta = 0.3,1.2: must be a list, each a number in [0, 1]");
  expect_message(making({{"beta", 0.3}}), "beta = 0.3: must be a list");
  expect_message(making({{"order", 1.0}}), "c = 0.1: must be 0 where `order` is not above 1");
  expect_message(making({{"order", 1.5}}), "alpha = 1.2,1.6: must be a list of orders below `order`");
}

TEST(ListsOfNumbers, KeepTheirCommasInALabel) {
  const auto variant = parse_variant("multi_term:alpha=1.2,b=0.5,beta=,d=,until=3");
  EXPECT_EQ(std::get<Numbers>(variant.values.at("alpha")), Numbers{1.2});
  EXPECT_TRUE(std::get<Numbers>(variant.values.at("beta")).empty());
  EXPECT_EQ(variant.label(), "multi_term:alpha=1.2,b=0.5,beta=,d=,until=3");
  const auto two = parse_variant("multi_term:alpha=1.3,1.7,c=0");
  EXPECT_EQ(std::get<Numbers>(two.values.at("alpha")), (Numbers{1.3, 1.7}));
  EXPECT_EQ(parse_variant(two.label()).values, two.values);
  expect_message([] { parse_variant("multi_term:alpha=1.2,x"); }, "alpha = 1.2,x");
}

// (1 + mu tau^2) u'' + (lambda + nu) tau u' + w2 u = 0.
TEST(DampingOfWholeOrders, IsInertiaAndFriction) {
  const double mass = 1.0 + 0.06 * 0.64, friction = 0.2 * 0.8, t = 3.0;
  const double rate = friction / (2.0 * mass), frequency = std::sqrt(1.0 / mass - rate * rate);
  const double sine = (-0.3 + rate) / frequency, decay = std::exp(-rate * t);
  const double u = decay * (std::cos(frequency * t) + sine * std::sin(frequency * t));
  const double du = decay * ((sine * frequency - rate) * std::cos(frequency * t) -
                             (frequency + rate * sine) * std::sin(frequency * t));
  const ParameterValues whole{{"alpha", 2.0}, {"beta", 1.0}};
  const Vec known = reference_at("damped_oscillator", whole, t);
  EXPECT_NEAR(known[0], u, 1e-15);
  EXPECT_NEAR(known[2], du, 1e-15);
  EXPECT_NEAR(known[3], -(friction * du + u) / mass, 1e-15);
  Scene scene = scene_of("damped_oscillator", whole);
  scene.problem.end = t;
  const auto path = solve("product_trapezoidal", scene.problem, 4096, {.output_times = {t}});
  EXPECT_LT((columns_of(scene.outputs, path) - known).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(DampingOfWholeOrders, IsTakenByTheExtensiblePendulum) {
  const ParameterValues whole{{"alpha", 2.0}, {"beta", 1.0}};
  const Vec now = reference_at("extensible_pendulum", whole, 2.0);
  const Vec known =
      Vec{{0.265394182507193307, -0.352038469027728258, -0.352038469027728258, 0.158753218655254624,
           0.983870206168365250, 0.786795833150110010, 0.786795833150110010, -0.172044530981444100}};
  EXPECT_LT((now - known).cwiseAbs().maxCoeff(), 1e-13);
}

// Figures 7.4 and 7.10: the motions of orders below 2 tend to that of order 2.
TEST(DampingOfWholeOrders, IsWhatOrdersBelowTendTo) {
  for (const auto* scene : {"pendulum", "extensible_pendulum", "damped_oscillator"}) {
    const Vec limit = reference_at(scene, {{"alpha", 2.0}}, 2.0);
    const auto off = [&](double alpha) {
      return (reference_at(scene, {{"alpha", alpha}}, 2.0) - limit).cwiseAbs().maxCoeff();
    };
    const double near = off(1.99), nearer = off(1.999);
    EXPECT_LT(nearer, 2e-3) << scene;
    EXPECT_NEAR(near / nearer, 10.0, 0.6) << scene;
  }
}

// Load t^(2-nu)/Gamma(3-nu): it adds t^2 E_{nu,3}(-w2 t^nu) to q.
TEST(FractionalOscillator, TakesTheLoadOfEquation49) {
  const ParameterValues loaded{{"nu", 1.3}, {"w2", 2.0},  {"q0", 1.0}, {"dq0", 0.5},
                               {"c0", 0.4}, {"c1", -0.2}, {"c2", 0.3}};
  EXPECT_NEAR(reference_at("fractional_oscillator", loaded, 1.5)[0], 0.411798252067028247, 1e-15);
  Scene scene = scene_of("fractional_oscillator", loaded);
  scene.problem.end = 1.5;
  const auto path = solve("product_trapezoidal", scene.problem, 4096, {.output_times = {1.5}});
  EXPECT_NEAR(path.y(0, 0), 0.411798252067028247, 1e-7);
}

// The motion of a free particle under a q' + b D^alpha q = a q1, 2 < alpha < 3, is that of (49): order alpha
// - 1, w2 = a/b, the load with q''(0).
TEST(FractionalOscillator, WithThatLoadIsTheConstrainedMotion) {
  const double a = 2.0, b = 1.0, q0 = 1.0, q1 = 0.5, q2 = 0.3, alpha = 2.5;
  const double constrained =
      reference_at("fractional_constraint_1d",
                   {{"alpha", alpha}, {"a", a}, {"b", b}, {"q0", q0}, {"q1", q1}, {"q2", q2}}, 1.3)[0];
  const double oscillator = reference_at("fractional_oscillator",
                                         {{"nu", alpha - 1.0},
                                          {"w2", a / b},
                                          {"q0", q0},
                                          {"dq0", q1},
                                          {"c0", a / b * q0},
                                          {"c1", a / b * q1},
                                          {"c2", q2}},
                                         1.3)[0];
  EXPECT_NEAR(constrained, oscillator, 1e-15);
}

// f by the integral of (53), g by its formula.
TEST(FractionalOscillator, ShowsItsTwoParts) {
  const Vec parts = reference_at("fractional_oscillator", {{"parts", "apart"}, {"dq0", 0.5}}, 2.0);
  EXPECT_NEAR(parts[0], 0.265605950988235481, 1e-15);
  EXPECT_NEAR(parts[1], 0.115031585842347865, 1e-15);
  EXPECT_NEAR(parts[2], 0.150574365145887614, 1e-15);
  const ParameterValues loaded{{"parts", "apart"}, {"nu", 1.3},  {"w2", 2.0}, {"dq0", 0.5},
                               {"c0", 0.4},        {"c1", -0.2}, {"c2", 0.3}};
  const Vec with_load = reference_at("fractional_oscillator", loaded, 1.5);
  EXPECT_NEAR(with_load[1], 0.397783645906303459, 1e-15);
  EXPECT_NEAR(with_load[2], 0.0140146061607247876, 1e-15);
  expect_message(
      [] {
        scene_of("fractional_oscillator", {{"parts", "apart"}, {"w2", 0.0}});
      },
      "w2 = 0: must be above 0 where parts = apart");
}

}  // namespace
}  // namespace fde::bench
