// SPDX-License-Identifier: MIT
// The geometry of Niminet & Blanuta 2009, without the factor 1/2 of their (2.6) and (2.8).

#include "fdebench/benchmarks/mechanics/semispray.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "fdebench/benchmarks/scenes/constraints/classical_systems.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

using namespace mechanics;

template <int n>
Vector<double, n> first(const Vec& columns) {
  return columns.head<n>();
}

const ConstantCourseOnSphere sphere{2.0};

// Gamma^theta_phi,phi = -sin cos, Gamma^phi_theta,phi = cot; the others are 0.
TEST(ChristoffelSymbols, OfTheSphere) {
  const double theta = 0.7;
  const auto symbols = christoffel_symbols<double>(sphere, Vector<double, 2>(theta, 1.1));
  const Table<double, 2, 2> of_theta{{0.0, 0.0}, {0.0, -std::sin(theta) * std::cos(theta)}};
  const Table<double, 2, 2> of_phi{{0.0, 1.0 / std::tan(theta)}, {1.0 / std::tan(theta), 0.0}};
  EXPECT_LT((symbols[0] - of_theta).norm(), 1e-15);
  EXPECT_LT((symbols[1] - of_phi).norm(), 1e-15);
}

TEST(ChristoffelSymbols, AreZeroWithoutAMetricAndForAConstantOne) {
  for (const auto& symbols : christoffel_symbols<double>(Particle{}, Vector<double, 3>(1.0, 2.0, 3.0)))
    EXPECT_EQ(symbols.norm(), 0.0);
  const Disc disc{0.5, 2.0, 0.3, 0.2, 0.0};
  for (const auto& symbols : christoffel_symbols<double>(disc, Vector<double, 4>(1.0, 2.0, 3.0, 4.0)))
    EXPECT_EQ(symbols.norm(), 0.0);
}

// The canonical metrical connection (2.9): symmetric, and dg_ij/dx^k = Gamma^m_ki g_mj + Gamma^m_kj g_im.
TEST(ChristoffelSymbols, MakeTheMetricParallel) {
  const Vector<double, 2> x(0.9, 0.4);
  const auto symbols = christoffel_symbols<double>(sphere, x);
  const Table<double, 2, 2> g = sphere.metric<double>(x);
  constexpr double h = 1e-5;
  for (int k = 0; k < 2; ++k) {
    const Vector<double, 2> step = h * Vector<double, 2>::Unit(k);
    const Table<double, 2, 2> above = sphere.metric<double>(x + step),
                              below = sphere.metric<double>(x - step);
    const Table<double, 2, 2> slope = (above - below) / (2 * h);
    Table<double, 2, 2> connected = Table<double, 2, 2>::Zero();
    for (std::size_t m = 0; m < 2; ++m) {
      const Vector<double, 2> row = symbols.at(m).row(k);
      const Vector<double, 2> lower = g.col(static_cast<Eigen::Index>(m));
      connected += row * lower.transpose() + lower * row.transpose();
    }
    EXPECT_LT((slope - connected).norm(), 1e-9) << "k = " << k;
  }
}

TEST(Semispray, IsHomogeneousWithoutForces) {
  const Vector<double, 2> x(0.7, 0.3), y(0.4, -0.9);
  for (const double factor : {-1.0, 2.0, 5.0}) {
    const Vector<double, 2> scaled =
        semispray<double>(sphere, EnforcingMultipliers{}, x, Vector<double, 2>(factor * y));
    EXPECT_LT((scaled - factor * factor * semispray<double>(sphere, EnforcingMultipliers{}, x, y)).norm(),
              1e-14);
  }
}

// Without constraint forces it is the geodesic spray: great circles, q'' = -2 G with y^i = x'^i. Tested for
// the meridian and the equator.
TEST(Semispray, WithoutMultipliersIsThatOfGeodesics) {
  const GivenMultipliers none{[]<class S>(const Vector<S, 2>&) { return Vector<S, 1>(S(0.0)); }};
  EXPECT_EQ(semispray<double>(sphere, none, Vector<double, 2>(0.7, 0.0), Vector<double, 2>(1.3, 0.0)).norm(),
            0.0);
  const Vector<double, 2> equator(std::numbers::pi / 2, 0.0);
  EXPECT_LT(semispray<double>(sphere, none, equator, Vector<double, 2>(0.0, 1.3)).norm(), 2e-16);
}

// lambda = x' y' / (1 + y^2).
TEST(Semispray, MultipliersOfTheParticleAreQuadraticInTheVelocity) {
  const Vector<double, 3> place(0.0, 0.5, 0.0);
  const auto lambda = [&](double dx, double dy) {
    return EnforcingMultipliers{}.of<double>(Particle{}, place, Vector<double, 3>(dx, dy, 0.5 * dx))[0];
  };
  EXPECT_NEAR(lambda(1.0, 1.0), 0.8, 1e-15);
  EXPECT_NEAR(lambda(2.0, 1.0), 1.6, 1e-15);
}

// Theorem 2.3: x' = y, y' = -2 G* from the initial state of a scene reproduces its closed form.
template <class System>
void expect_evolution(const System& system, const Scene& scene) {
  constexpr int n = System::coordinates;
  Problem problem{.rhs =
                      [system](double, In state, Out f) {
                        const Vector<double, n> x = state.head<n>(), y = state.tail<n>();
                        f.head<n>() = y;
                        f.tail<n>() = -semispray<double>(system, EnforcingMultipliers{}, x, y);
                      },
                  .end = 2.0};
  for (const double value : scene.reference.at(0.0).value) problem.components.push_back({1.0, {value}});
  Vec before;
  std::vector<double> errors;
  for (const int steps : {500, 1000, 2000}) {
    const Vec end = solve("product_trapezoidal", problem, steps).y.rightCols(1);
    errors.push_back((end - scene.reference.at(2.0).value).cwiseAbs().maxCoeff());
  }
  EXPECT_LT(errors[2], 1e-5);
  EXPECT_NEAR(std::log2(errors[0] / errors[1]), 2.0, 0.05);
  EXPECT_NEAR(std::log2(errors[1] / errors[2]), 2.0, 0.05);
}

TEST(Semispray, HasTheEvolutionCurvesAsItsIntegralCurves) {
  expect_evolution(Particle{}, scene_of("nonholonomic_particle"));
  expect_evolution(ConstantCourseOnSphere{2.0}, scene_of("loxodrome", {{"speed", 0.5}}));
  expect_evolution(Blade{9.81 * std::sin(0.5)}, scene_of("knife_edge"));
  expect_evolution(Disc{0.5, 1.0, 0.125, 0.0625, 0.6}, scene_of("rolling_disc", {{"pull", 0.6}}));
}

// Theorem 2.4: N* = N for any multipliers that are functions of position only.
TEST(NonlinearConnection, IsRiemannsForMultipliersOfThePlace) {
  const GivenMultipliers given{[]<class S>(const Vector<S, 2>& x) {
    using std::cos, std::sin;
    return Vector<S, 1>(S(sin(x[0]) * cos(x[1])));
  }};
  const Vector<double, 2> x(0.7, 0.3), y(0.4, -0.9);
  EXPECT_LT((semispray_connection(sphere, given, x, y) - riemannian_connection(sphere, x, y)).norm(), 1e-15);
}

// It does not hold for the multipliers that enforce the constraint: G* contains -lambda a / 2, lambda = x'
// y'/(1 + y^2), a = (-y, 0, 1), and N = 0.
TEST(NonlinearConnection, IsAnotherForMultipliersThatKeepTheConstraint) {
  const Vector<double, 3> x(0.0, 0.5, 0.0), y(2.0, 1.0, 1.0);
  const Vector<double, 3> slope = Vector<double, 3>(1.0, 2.0, 0.0) / 1.25;  // d lambda / d(x', y', z')
  const Table<double, 3, 3> expected = -0.5 * Vector<double, 3>(-0.5, 0.0, 1.0) * slope.transpose();
  EXPECT_EQ(riemannian_connection(Particle{}, x, y).norm(), 0.0);
  EXPECT_LT((semispray_connection(Particle{}, EnforcingMultipliers{}, x, y) - expected).norm(), 1e-15);
  EXPECT_GT((semispray_connection(sphere, EnforcingMultipliers{}, Vector<double, 2>(0.7, 0.3),
                                  Vector<double, 2>(0.4, -0.9)) -
             riemannian_connection(sphere, Vector<double, 2>(0.7, 0.3), Vector<double, 2>(0.4, -0.9)))
                .norm(),
            0.1);
}

// G* is homogeneous of degree 2 without forces, so N* y = 2 G*.
TEST(NonlinearConnection, TimesTheVelocityIsTheSemispray) {
  const Vector<double, 2> x(0.7, 0.3), y(0.4, -0.9);
  EXPECT_LT((semispray_connection(sphere, EnforcingMultipliers{}, x, y) * y -
             semispray<double>(sphere, EnforcingMultipliers{}, x, y))
                .norm(),
            1e-14);
}

}  // namespace
}  // namespace fde::bench
