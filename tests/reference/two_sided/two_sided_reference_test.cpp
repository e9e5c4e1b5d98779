// SPDX-License-Identifier: MIT
// The two methods of the references of two-sided problems, each by itself.

#include <gtest/gtest.h>

#include <cmath>

#include "fdebench/benchmarks/references/cache.hpp"
#include "fdebench/benchmarks/scenes/two_sided/manufactured_problem.hpp"
#include "fdebench/reference/two_sided/nodal_basis.hpp"
#include "fdebench/reference/two_sided/nodal_equations.hpp"
#include "fdebench/reference/two_sided/solution.hpp"
#include "support/testing.hpp"

namespace fde::reference {
namespace {

NodalBasis panels() {
  static const PanelBasis fourteen(14, PanelPoints::legendre);
  return clustered_panels(fourteen, 9, ClusteringMap(8.0));
}

Vec at_nodes(const NodalBasis& basis, double (*f)(RelativeTime t)) {
  return Vec::NullaryExpr(std::ssize(basis.nodes),
                          [&](Eigen::Index m) { return f(basis.nodes[static_cast<std::size_t>(m)]); });
}

// J^g t^p = Gamma(p+1)/Gamma(p+1+g) t^(p+g), J^g (1-t) = t^g/Gamma(g+1) - t^(1+g)/Gamma(g+2).
TEST(NodalBasis, IntegratesPowersOfBothEnds) {
  for (const auto& [basis, off] : {std::pair{panels(), 5e-12}, {sinc_nodes(0.08), 1e-14}}) {
    const Vec f = at_nodes(basis, [](RelativeTime t) { return std::pow(t.from_start, 0.4) + t.from_end; });
    for (const double order : {0.3, 0.5, 1.0, 1.7}) {
      const auto row = basis.rows(order);
      for (const double t : {1e-6, 0.1, 0.5, 0.77, 0.999, 1.0}) {
        const double exact = std::tgamma(1.4) / std::tgamma(1.4 + order) * std::pow(t, 0.4 + order) +
                             std::pow(t, order) / std::tgamma(order + 1.0) -
                             std::pow(t, 1.0 + order) / std::tgamma(order + 2.0);
        EXPECT_NEAR(row({t, 1.0 - t}).dot(f), exact, off) << order << " " << t;
      }
    }
  }
}

// J^g 1 = t^g / Gamma(g+1), and J^g (1-t) as above. At g = 0.01, 2 % of the integral of the kernel
// (1-u)^(g-1) are beyond the last point of the map.
TEST(NodalBasis, SincFunctionsIntegrateTheWholeKernelOfSmallOrders) {
  const NodalBasis basis = sinc_nodes(0.08);
  const Vec one = Vec::Ones(std::ssize(basis.nodes));
  const Vec falling = at_nodes(basis, [](RelativeTime t) { return t.from_end; });
  for (const double order : {0.01, 0.02, 0.03, 0.05, 0.07, 0.1}) {
    const auto row = basis.rows(order);
    for (const double t : {1e-6, 0.1, 0.5, 0.999, 1.0}) {
      const double whole = std::pow(t, order) / std::tgamma(order + 1.0);
      EXPECT_NEAR(row({t, 1.0 - t}).dot(one), whole, 4e-15) << order << ' ' << t;
      EXPECT_NEAR(row({t, 1.0 - t}).dot(falling), whole * (1.0 - t / (1.0 + order)), 4e-15)
          << order << ' ' << t;
    }
  }
}

TEST(ClusteringMap, IsUndoneWithTheDigitsOfBothEnds) {
  for (const double power : {8.0, 32.0}) {
    const ClusteringMap time(power);
    for (const double x : {1e-3, 0.2, 0.5, 0.9, 0.999}) {
      const RelativeTime back = time.inverse(time.at({x, 1.0 - x}));
      EXPECT_NEAR(back.from_start, x, 1e-14 * x) << power;
      EXPECT_NEAR(back.from_end, 1.0 - x, 1e-12 * (1.0 - x)) << power;
    }
  }
}

// A nonlinear problem with one row a side, of orders below and above 1.
TEST(TwoSidedReference, IsTheManufacturedSolutionByEitherMethod) {
  const bench::ManufacturedProblem made =
      bench::manufactured_problem({{0.6, 3.0, Side::left}, {1.7, 3.5, Side::right}}, 1.0);
  for (const auto& basis : {panels(), sinc_nodes(0.08)}) {
    const NodalSolution solution(made.problem, basis);
    for (const double t : {0.01, 0.3, 0.5, 0.9, 0.99})
      EXPECT_LT((solution.at({t, 1.0 - t}) - made.exact(t)).cwiseAbs().maxCoeff(), 1e-11) << t;
  }
  const Reference reference = two_sided_reference(two_sided_table(made.problem), made.problem);
  for (const double t : {0.0, 0.01, 0.3, 0.5, 0.9, 1.0}) {
    const auto [value, bound] = reference.at(t);
    EXPECT_LT(bound.maxCoeff(), 1e-9);
    EXPECT_TRUE(((value - made.exact(t)).cwiseAbs().array() <= bound.array()).all()) << t;
  }
  EXPECT_THROW((void)reference.at(1.5), std::invalid_argument);
}

// Orders of 0.3 need 12 panels, and 1.4 * 12 / 12 is below 1.4 in double.
TEST(TwoSidedReference, ReachesTheEnd) {
  const double end = 1.4;
  const bench::ManufacturedProblem made =
      bench::manufactured_problem({{0.3, 3.0, Side::left}, {0.3, 3.5, Side::right}}, end);
  const PanelTable table = two_sided_table(made.problem);
  EXPECT_EQ(table.panels.size(), 12U);
  const auto [value, bound] = two_sided_reference(table, made.problem).at(end);
  EXPECT_TRUE(((value - made.exact(end)).cwiseAbs().array() <= bound.array()).all());
}

// q' starts like t^0.1 and ends like (T-t)^0.1 at alpha = 0.9. The values at T are those of product
// trapezoids with 1024 to 16384 equal steps, extrapolated in the powers 1.1, 1.2 and 1.3 of the step size:
// two such sets agree to 2e-10.
TEST(TwoSidedReference, KeepsItsDigitsNextToTheEndsForOrdersNextToOne) {
  const bench::Scene scene = bench::scene_of("fractional_vakonomic", {{"alpha", 0.9}});
  const Reference reference = bench::computed_reference(scene.problem);
  const double end = scene.problem.end;
  for (const double t : {0.0, 1e-6, 0.01, 0.3, 0.5, 0.9, 0.99, 0.999999, 1.0})
    EXPECT_LT(reference.at(t * end).bound.maxCoeff(), 5e-8) << t;
  const Vec last = bench::columns_at(scene.outputs, end, reference.at(end).value);
  EXPECT_NEAR(last[0], 1.5981298667, 1e-9);
  EXPECT_NEAR(last[1], 0.5754581356, 1e-9);
}

TEST(TwoSidedReference, RefusesAlgebraicRows) {
  const Problem problem{.components = {{0.0, {1.0}}, {1.0, {0.0}, Side::right}},
                        .rhs = [](double, In y, Out f) { f << y[0] - 1.0, y[0]; }};
  bench::expect_message([&] { two_sided_table(problem); }, "takes no algebraic rows");
}

}  // namespace
}  // namespace fde::reference
