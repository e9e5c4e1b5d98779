// SPDX-License-Identifier: MIT
// Yin, Liu & Anh 2007, sections 5 and 6: steps, chain and energy of the pendulums, as printed and corrected.

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/references/reference_of.hpp"
#include "fdebench/reference/special_functions/numbers/real.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

double power(double x, double p) { return x > 0.0 ? std::pow(x, p) : 0.0; }

// Eqs 3.4-3.7 as printed, without the factor h^g: the weights of the predictor and of the corrector.
double rectangle(int j, int k, double g) { return (power(k + 1 - j, g) - power(k - j, g)) / g; }
double trapezoid(int j, int k, double g) {
  const double of_j =
      j == 0 ? power(k, g + 1.0) - (k - g) * power(k + 1, g)
             : power(k - j + 2, g + 1.0) + power(k - j, g + 1.0) - 2.0 * power(k - j + 1, g + 1.0);
  return of_j / (g * (g + 1.0));
}

// Steps of the predictor-corrector 5.6-5.9 or 6.9-6.16. row_of_old: the row whose corrector takes phi'
// (component 2) from the prediction of the previous step, the last one that the index j reaches; -1: no row.
Vec predictor_corrector(const Problem& problem, int steps, Eigen::Index row_of_old) {
  const Eigen::Index size = problem.size();
  const Vec start = taylor_part(problem, 0.0);
  const auto rhs = [&](const Vec& y) {
    Vec f(size);
    problem.rhs(0.0, y, f);
    return f;
  };
  Vec order(size), factor(size);  // h^g / Gamma(g)
  for (Eigen::Index i = 0; i < size; ++i) {
    order[i] = problem.components[static_cast<std::size_t>(i)].order;
    factor[i] = std::pow(problem.end / steps, order[i]) / reference::gamma(order[i]);
  }
  Vec y = start, prediction = start;
  std::vector<Vec> f;
  for (int k = 0; k < steps; ++k) {
    f.push_back(rhs(y));
    const double old = prediction[2];
    prediction = y = start;
    for (int j = 0; j <= k; ++j) {
      for (Eigen::Index i = 0; i < size; ++i) {
        const double part = factor[i] * f[static_cast<std::size_t>(j)][i];
        prediction[i] += part * rectangle(j, k, order[i]);
        y[i] += part * trapezoid(j, k, order[i]);
      }
    }
    Vec last = rhs(prediction);
    if (row_of_old >= 0) {
      Vec mixed = prediction;
      mixed[2] = old;
      last[row_of_old] = rhs(mixed)[row_of_old];
    }
    y.array() += factor.array() * last.array() / (order.array() * (order.array() + 1.0));
  }
  return y;
}

// The prediction of phi' has the index j of the sum in 5.9, and in 6.16, where it is squared; k + 1 is
// correct.
TEST(ErrataYin, Equation59TakesAnOldPrediction) {
  Problem problem = scene_of("pendulum").problem;
  problem.end = 0.3;
  const Vec of_scheme = solve("decoupled_multi_order", problem, 3).y.col(3);
  EXPECT_LT((predictor_corrector(problem, 3, -1) - of_scheme).norm(), 1e-14);
  EXPECT_GT((predictor_corrector(problem, 3, 3) - of_scheme).norm(), 1e-4);
}

TEST(ErrataYin, Equation616TakesAnOldPrediction) {
  Problem problem = scene_of("extensible_pendulum").problem;
  problem.end = 0.3;
  const Vec of_scheme = solve("decoupled_multi_order", problem, 3).y.col(3);
  EXPECT_LT((predictor_corrector(problem, 3, -1) - of_scheme).norm(), 1e-14);
  EXPECT_GT((predictor_corrector(problem, 3, 7) - of_scheme).norm(), 1e-4);
}

constexpr double tau = 0.8;

// mu tau^alpha D^alpha u + lambda tau u' + nu tau^beta D^beta u with the factors of example 2.
double damping(In u) { return 0.1 * (std::pow(tau, 1.5) * u[3] + tau * u[2] + std::sqrt(tau) * u[1]); }

// phi'' of eq. 6.1 is the last link; 6.5 multiplies two damping terms and has the wrong sign of the third.
TEST(ErrataYin, Equation65LosesASignAndASum) {
  const Scene scene = scene_of("extensible_pendulum");
  const Vec y = (Vec(8) << 0.7, 0.3, -0.4, 0.5, 0.1, 0.2, 0.6, -0.3).finished();
  Vec f(8);
  scene.problem.rhs(0.0, y, f);
  const double r = 1.0 + y[4], turn = -(std::sin(y[0]) + 2.0 * y[2] * y[6]) / r;
  EXPECT_NEAR(f[3], turn - damping(y.head(4)) / (r * r), 1e-15);
  const double printed = 0.1 * std::pow(tau, 1.5) * y[3] * 0.1 * tau * y[2] - 0.1 * std::sqrt(tau) * y[1];
  EXPECT_GT(std::abs(f[3] - (turn - printed / (r * r))), 0.01);
}

// Undamped with L = 2, K/m = 1.3, to t = 5: conserved with (K/m) xi^2 / 2, which is K/(m L^2) for L = 1 only.
TEST(ErrataYin, Equation64HasAStiffnessThatConservesNothing) {
  Scene scene =
      scene_of("extensible_pendulum",
               {{"mu", 0.0}, {"lambda", 0.0}, {"nu", 0.0}, {"mu1", 0.0}, {"lambda1", 0.0}, {"nu1", 0.0}});
  scene.problem.end = 5.0;
  const double stiffness = 1.3, length = 2.0;
  const auto xi = std::ranges::find(scene.outputs.names, "xi") - scene.outputs.names.begin();
  const reference::Reference reference = reference_of(scene);
  const double start = scene.energy.value(reference.at(0.0).value);
  double conserved = 0.0, printed = 0.0;
  for (double t = 0.0; t <= 5.0; t += 0.05) {
    const Vec y = reference.at(t).value;
    const double energy = scene.energy.value(y);
    conserved = std::max(conserved, std::abs(energy - start));
    const double spring = 0.5 * stiffness * y[xi] * y[xi];
    printed = std::max(printed, std::abs(energy - spring + spring / (length * length) - start));
  }
  EXPECT_LT(conserved, 2e-14);
  EXPECT_NEAR(printed, 1.49, 0.01);
}

// Section 7, example 1: "local energy minima at the extrema". E' = -phi' (damping) is 0 there, and
// E'' = -phi'' (damping) has the sign of the remaining damping, which is a memory term. At the fourth and
// sixth extremum it is negative: these are maxima. The times and E'' are from a solution by the product
// trapezoidal rule in Python.
TEST(ErrataYin, EnergyHasMaximaAtTheFourthAndSixthExtremum) {
  Scene scene = scene_of("pendulum");
  scene.problem.end = 20.0;
  const reference::Reference reference = reference_of(scene);
  const auto speed = [&](double t) { return reference.at(t).value[2]; };
  std::vector<double> bends;
  for (const auto& [time, bend] : {std::pair{2.9183, 0.03400},
                                   {6.1002, 0.002206},
                                   {9.2559, 0.012437},
                                   {12.3817, -0.0001317},
                                   {15.5020, 0.005014},
                                   {18.6094, -0.000623}}) {
    const double t = time + 1e-3 * speed(time) / (speed(time - 5e-4) - speed(time + 5e-4));
    EXPECT_NEAR(t, time, 3e-4);
    const Vec at = reference.at(t).value;  // phi, D^0.5 phi, phi', D^1.5 phi
    const double damping = 0.06 * std::pow(0.8, 1.5) * at[3] + 0.1 * std::pow(0.8, 0.5) * at[1];
    bends.push_back((std::sin(at[0]) + damping) * damping);
    EXPECT_NEAR(bends.back(), bend, 2e-6) << time;
  }
  EXPECT_LT(bends[3], 0.0);
  EXPECT_LT(bends[5], 0.0);
}

}  // namespace
}  // namespace fde::bench
