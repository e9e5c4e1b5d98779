// SPDX-License-Identifier: MIT
// Problems built from multi-term equations, and Problem::equations of such a problem.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "fdebench/schemes/problem/chain.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

const std::vector<Term> damping{{0.1, 0.5}, {0.2, 1.0}, {0.3, 1.5}};

Problem forced(const Chain& chain, double force) {
  return chain_problem({{.chain = chain, .force = [=](double, In) { return force; }}}, 1.0);
}

TEST(ChainProblem, LinksAreDerivativesOfEachOtherAndTheLastSolvesTheEquation) {
  const Problem problem = forced({{2.0, 2.0}, damping, {1.0, -0.3}}, 5.0);
  Vec f(4);
  problem.rhs(0.0, (Vec(4) << 1.0, 2.0, 3.0, 4.0).finished(), f);
  EXPECT_EQ(f.head(3), Eigen::Vector3d(2.0, 3.0, 4.0));
  EXPECT_NEAR(2.0 * f[3] + 0.1 * 2.0 + 0.2 * 3.0 + 0.3 * 4.0, 5.0, 1e-15);
}

TEST(ChainProblem, HasDerivativesWhereItsEquationsHaveThem) {
  const Chain chain({2.0, 2.0}, damping, {1.0, -0.3});
  EXPECT_FALSE(has_jacobian(forced(chain, 5.0)));
  const MultiTermEquation equation{
      .chain = chain, .force = [](double, In y) { return -3.0 * y[0]; }, .derivatives = LinearForce{-3.0}};
  const Matrix linear = std::get<DenseLinearPart>(chain_problem({equation}, 1.0).derivatives).matrix;
  EXPECT_EQ(linear.topRightCorner(3, 3), Matrix::Identity(3, 3));
  EXPECT_LT((linear.row(3) - Eigen::RowVector4d(-1.5, -0.05, -0.1, -0.15)).cwiseAbs().maxCoeff(), 1e-16);
}

TEST(ChainProblem, ChainsAreStoredConsecutively) {
  EXPECT_THROW(forced({{1.0, 2.0}, damping, {1.0, -0.3}, 1}, 0.0), std::invalid_argument);
}

TEST(ChainProblem, HasItsEquations) {
  const Chain chain({2.0, 2.0}, damping, {1.0, -0.3});
  const Problem problem = forced(chain, 5.0);
  const Chain read_back = chain_of(problem, problem.equations.front());
  EXPECT_EQ(read_back.nodes(), chain.nodes());
  EXPECT_EQ(read_back.coefficients(), chain.coefficients());
  EXPECT_THAT(read_back.initial(), ElementsAre(1.0, -0.3));
  EXPECT_EQ(read_back.leading().coefficient, 2.0);
}

// Problem::equations agree with the rows of the problem: right-hand side, orders and initial values.
void expect_equations_of_rows(const Problem& problem) {
  const double t = 0.3;
  const Vec y = Vec::LinSpaced(problem.size(), 0.2, 0.9);
  Vec f(problem.size());
  problem.rhs(t, y, f);
  Eigen::Index rows = 0;
  for (const auto& equation : problem.equations) {
    const Chain chain = chain_of(problem, equation);
    double sum = 0.0;
    for (const auto& [coefficient, order] : equation.terms) sum += coefficient * y[*chain.row(order)];
    const double highest = f[chain.first_row() + chain.size() - 1];
    EXPECT_NEAR(equation.leading.coefficient * highest + equation.factor(t, y) * sum, equation.force(t, y),
                1e-14);
    const auto components = chain.components();
    for (std::size_t i = 0; i < components.size(); ++i) {
      const auto& component = problem.components[static_cast<std::size_t>(rows) + i];
      EXPECT_EQ(components[i].order, component.order);
      EXPECT_EQ(components[i].initial, component.initial);
    }
    rows += chain.size();
  }
  EXPECT_EQ(rows, problem.size());
}

TEST(ChainProblem, EquationsOfEveryChainSceneAreThoseOfItsRows) {
  for (const auto* id : {"bagley_torvik", "damped_oscillator", "pendulum", "extensible_pendulum",
                         "fractional_constraint_1d", "nonlinear_fractional_oscillator"}) {
    SCOPED_TRACE(id);
    const Problem problem = scene_of(id).problem;
    EXPECT_FALSE(problem.equations.empty());
    expect_equations_of_rows(problem);
  }
}

}  // namespace
}  // namespace fde::bench
