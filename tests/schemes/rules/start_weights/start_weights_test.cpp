// SPDX-License-Identifier: MIT
// Starting weights of the multistep rules, compared with solutions in 100 digits that share only the
// definition with the library.

#include "fdebench/schemes/rules/start_weights/start_weights.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <boost/multiprecision/mpfr.hpp>
#include <cmath>
#include <random>

#include "fdebench/schemes/rules/start_weights/start_correction.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

using Precise = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<100>>;

const std::vector<const WeightFamily*> rules{&families::bdf2,
                                             &families::bdf3,
                                             &families::bdf4,
                                             &families::bdf5,
                                             &families::bdf6,
                                             &families::newton_gregory_2,
                                             &families::newton_gregory_3,
                                             &families::fractional_trapezoidal};

std::string name_of(const testing::TestParamInfo<const WeightFamily*>& rule) {
  return std::string(rule.param->id);
}

// (a(zeta))^exponent from its logarithmic derivative: b' a = exponent a' b.
std::vector<Precise> series_power(const std::vector<Precise>& a, const Precise& exponent, std::size_t count) {
  std::vector<Precise> b{pow(a[0], exponent)};
  for (std::size_t n = 1; n < count; ++n) {
    Precise sum = 0;
    for (std::size_t k = 1; k < a.size() && k <= n; ++k)
      sum += (exponent * k - Precise(n - k)) * a[k] * b[n - k];
    b.emplace_back(sum / (a[0] * n));
  }
  return b;
}

std::vector<Precise> product(const std::vector<Precise>& a, const std::vector<Precise>& b,
                             std::size_t count) {
  std::vector<Precise> c(count, Precise(0));
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size() && i + j < count; ++j) c[i + j] += a[i] * b[j];
  }
  return c;
}

// omega by Lubich's definitions: delta^(-g) with delta = sum_{k<=p} (1-zeta)^k / k; ((1+zeta)/(1-zeta)/2)^g;
// the truncated series of (-ln zeta / (1-zeta))^(-g) in powers of 1-zeta, times (1-zeta)^(-g).
std::vector<Precise> omega(const WeightFamily& rule, const Precise& g, std::size_t count) {
  const std::vector<Precise> u{1, -1};
  const std::string id(rule.id);
  if (id.starts_with("bdf")) {
    std::vector<Precise> delta{0}, power{1};
    for (int k = 1; k <= id.back() - '0'; ++k) {
      power = product(power, u, power.size() + 1);
      delta.resize(power.size(), Precise(0));
      for (std::size_t i = 0; i < power.size(); ++i) delta[i] += power[i] / k;
    }
    return series_power(delta, -g, count);
  }
  if (id == "fractional_trapezoidal")
    return product(series_power({Precise(0.5), Precise(0.5)}, g, count), series_power(u, -g, count), count);
  const std::vector<Precise> logarithm{1, Precise(1) / 2, Precise(1) / 3};
  const auto in_u = series_power(logarithm, -g, id.back() == '2' ? 2 : 3);
  std::vector<Precise> q{0}, power{1};
  for (const Precise& factor : in_u) {
    q.resize(power.size(), Precise(0));
    for (std::size_t i = 0; i < power.size(); ++i) q[i] += factor * power[i];
    power = product(power, u, power.size() + 1);
  }
  return product(series_power(u, -g, count), q, count);
}

class Multistep : public testing::TestWithParam<const WeightFamily*> {
 protected:
  static std::vector<double> orders() { return {0.2, 0.5, 0.8, 1.0, 1.3, 1.7}; }
  static StartingPowers powers_of(double order) {
    return starting_powers(*GetParam(),
                           {.components = {{order, std::vector<double>(initial_count(order), 1.0)}}});
  }
};

TEST_P(Multistep, WeightsAreTheCoefficientsOfTheirGeneratingFunction) {
  for (const double order : orders()) {
    const auto w = omega(*GetParam(), order, 900);
    const Vec first = first_weights({GetParam(), order}, 899);
    EXPECT_NEAR(step_factor({GetParam(), order}, 1.0) / static_cast<double>(w[0]), 1.0, 4e-16);
    for (std::size_t k = 1; k < w.size(); ++k) {
      const auto exact = static_cast<double>(w[k] / w[0]);
      const double allowed = 1e-15 * std::max(std::abs(exact), std::pow(static_cast<double>(k), order - 1.0));
      ASSERT_NEAR(first[static_cast<Eigen::Index>(k) - 1], exact, allowed) << order << ", k = " << k;
      if (k < 40 || k % 17 == 0) {
        ASSERT_NEAR(weight({GetParam(), order}, static_cast<std::int64_t>(k)), exact, allowed)
            << order << ' ' << k;
      }
    }
  }
}

// W(n, j) for the steps n, one column a step, by elimination in the 100 digits of Exact.
Matrix exact_weights(const WeightTable& table, const std::vector<double>& powers,
                     const std::vector<int>& steps) {
  const Precise g = table.order;
  const auto last = static_cast<std::size_t>(std::ranges::max(steps));
  const auto w = omega(*table.family, g, last + 1);
  std::vector<std::vector<Precise>> rows;  // the equation of each p: j^p for j < s, then e_p(n) for each n
  for (const double p : powers) {
    std::vector<Precise> values;
    for (std::size_t j = 0; j <= last; ++j)
      values.push_back(j == 0 ? Precise(p == 0.0 ? 1 : 0) : Precise(pow(Precise(j), Precise(p))));
    rows.emplace_back(values.begin(), values.begin() + std::ssize(powers));
    const Precise factor = tgamma(Precise(p) + 1) / tgamma(Precise(p) + g + 1);
    for (const int n : steps) {
      Precise rest = factor * values[static_cast<std::size_t>(n)] * pow(Precise(n), g);
      for (int j = 0; j <= n; ++j)
        rest -= w[static_cast<std::size_t>(n - j)] * values[static_cast<std::size_t>(j)];
      rows.back().emplace_back(rest / w[0]);
    }
  }
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const Precise scale = 1 / rows[k][k];
    for (auto& entry : rows[k]) entry *= scale;
    for (std::size_t r = 0; r < rows.size(); ++r) {
      if (r == k) continue;
      const Precise factor = rows[r][k];
      for (std::size_t c = k; c < rows[r].size(); ++c) rows[r][c] -= factor * rows[k][c];
    }
  }
  Matrix weights(std::ssize(powers), std::ssize(steps));
  for (Eigen::Index j = 0; j < weights.rows(); ++j) {
    const auto& row = rows[static_cast<std::size_t>(j)];
    for (Eigen::Index i = 0; i < weights.cols(); ++i)
      weights(j, i) = static_cast<double>(row[powers.size() + static_cast<std::size_t>(i)]);
  }
  return weights;
}

// To a few units in the last place of the largest W(n, j) of a step: below and above the first step of the
// expansions, where the parts from other singularities have decayed or not; for orders of one and of several
// rows, near each other, near whole numbers and tiny, for which the equations need up to 60 digits.
TEST_P(Multistep, StartWeightsAreAccurateToRounding) {
  const std::vector<int> steps{1, 2, 7, 31, 64, 65, 97, 128, 161, 200, 385, 1000, 2000};
  std::vector<std::vector<double>> orders{
      {0.2},  {0.5},         {0.8},          {1.0},      {1.3},
      {1.9},  {1.999},       {0.5, 0.50001}, {1.5, 0.5}, {0.37, 0.81, 1.62},
      {3e-4}, {1e-4, 2.7e-4}};
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(0.05, 1.95);
  orders.push_back({uniform(random)});
  orders.push_back({uniform(random), uniform(random)});
  for (const auto& all : orders) {
    const WeightTable table{GetParam(), all.front()};
    const auto powers = starting_powers(*GetParam(), all, all).powers;
    // Row i has f_i = 1 and the other samples 0, so its sum is W(n, i).
    const auto count = std::ssize(powers);
    StartingCorrection correction({powers.size(), table}, powers, steps.back());
    for (Eigen::Index j = 0; j < count; ++j) correction.push(Vec::Unit(count, j));
    const Matrix exact = exact_weights(table, powers, steps);
    for (std::size_t i = 0; i < steps.size(); ++i) {
      Vec at_n = Vec::Zero(count);
      correction.add(steps[i], at_n);
      const auto column = exact.col(static_cast<Eigen::Index>(i));
      EXPECT_LE((at_n - column).cwiseAbs().maxCoeff(), 1.5e-15 * column.cwiseAbs().maxCoeff())
          << fmt::format("orders {}, n = {}", fmt::join(all, " "), steps[i]);
    }
  }
}

// The values of the table in docs/schemes.md.
TEST_P(Multistep, StartWeightsGrowNoMoreThanAllowed) {
  for (const double order : {0.1, 0.2, 0.3, 0.5, 0.8, 1.0, 1.3, 1.7}) {
    const auto start = powers_of(order);
    fmt::print("{} {}: {} start weights, up to t^{:.2f}, growth {:.2g}\n", GetParam()->id, order,
               start.powers.size(), start.powers.back(), start.growth);
    EXPECT_LE(start.growth, max_growth);
    EXPECT_GT(start.next, start.powers.back());
  }
}

double condition(const ComplexMatrix& matrix) {
  const Eigen::JacobiSVD<ComplexMatrix> values(matrix);
  return values.singularValues().maxCoeff() / values.singularValues().minCoeff();
}

// SylvesterFactors uses the eigenvectors of the 2 x 2 blocks of a Schur form only: those of the weights of
// all first steps would lose up to six digits.
TEST_P(Multistep, ConditionOfPairsIsSmall) {
  double of_pairs = 1.0, of_all = 1.0;
  for (const double order : {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.1, 1.3, 1.5, 1.7, 1.9}) {
    const auto powers = powers_of(order).powers;
    const auto steps = std::ssize(powers) - 1;
    const StartingCorrection correction({{GetParam(), order}}, powers, 64);
    const Matrix weights = correction.first_weights(0).rightCols(steps);
    of_all = std::max(of_all, condition(Eigen::EigenSolver<Matrix>(weights).eigenvectors()));
    const Matrix schur = Eigen::RealSchur<Matrix>(weights.transpose()).matrixT();
    for (Eigen::Index i = 0; i + 1 < steps; ++i) {
      if (schur(i + 1, i) == 0.0) continue;
      const Eigen::EigenSolver<Matrix> block(schur.block(i, i, 2, 2));
      of_pairs = std::max(of_pairs, condition(block.eigenvectors()));
    }
  }
  fmt::print("{}: of pairs {:.2g}, of all {:.2g}\n", GetParam()->id, of_pairs, of_all);
  EXPECT_LT(of_pairs, 1e3);
}

INSTANTIATE_TEST_SUITE_P(, Multistep, testing::ValuesIn(rules), name_of);

// Sums of the orders 0.5 and 0.8 up to rate - 1.
TEST(StartingPowers, AreTheSumsOfTheOrders) {
  const Problem problem{.components = {{0.5, {1.0}}, {0.8, {1.0}}}};
  const auto start = starting_powers(families::bdf2, problem);
  EXPECT_EQ(start.powers, (std::vector{0.0, 0.5, 0.8, 1.0}));
  EXPECT_DOUBLE_EQ(start.next, 1.3);
}

// An order within the separation of powers adds none: 0 and its multiples count as one power.
TEST(StartingPowers, AreThoseOfTheOtherOrdersWhereOneIsTiny) {
  for (const double tiny : {1e-100, 1e-12, 0.9e-5, 1e-5}) {
    EXPECT_EQ(starting_powers(families::bdf2, {tiny}, {tiny}).powers, (std::vector<double>{0.0, 1.0}))
        << tiny;
    EXPECT_EQ(starting_powers(families::bdf2, {0.5, tiny}, {0.5, tiny}).powers,
              starting_powers(families::bdf2, {0.5}, {0.5}).powers)
        << tiny;
  }
}

// D^g y = Gamma(p+1)/Gamma(p+1-g) t^(p-g) has the solution t^p, which schemes with a starting weight for p -
// g reproduce exactly.
TEST(StartingWeights, MakeSchemesExactForTheirPowers) {
  for (const auto& scheme : schemes()) {
    if (!scheme.starting_powers || scheme.capabilities.discretises_equations) continue;
    for (const double g : {0.5, 1.3}) {
      Problem problem{.components = {{g, std::vector<double>(initial_count(g), 0.0)}}};
      for (const double r : scheme.starting_powers(problem)) {
        const double factor = std::tgamma(r + g + 1.0) / std::tgamma(r + 1.0);
        problem.rhs = [=](double t, In, Out f) { f[0] = factor * std::pow(t, r); };
        for (const int steps : {20, 300}) {
          const auto path = scheme.solve(problem, Grid{1.0, steps}, {});
          for (int n = 1; n <= steps; ++n) {
            EXPECT_NEAR(path.y(0, n), std::pow(n / static_cast<double>(steps), r + g), 2e-12)
                << scheme.id << ' ' << g << ' ' << r;
          }
        }
      }
    }
  }
}

// A sparse Jacobian, a dense one and none lead to the same first steps.
TEST(StartingProcedure, AreTheSameWithEveryKindOfDerivatives) {
  const Matrix a = (Matrix(2, 2) << -2.0, 1.0, 0.0, -3.0).finished();
  Problem problem{.components = {{0.5, {1.0}}, {0.5, {0.5}}}, .rhs = [=](double, In y, Out f) { f = a * y; }};
  const Rows differenced = solve("bdf3", problem, 40).y;
  problem.derivatives = DenseJacobian{[=](double, In, OutMatrix jacobian) { jacobian = a; }};
  const Rows dense = solve("bdf3", problem, 40).y;
  problem.derivatives =
      SparseJacobian{[=](double, In, SparseMatrix& jacobian) { jacobian = a.sparseView(); }};
  const Rows sparse = solve("bdf3", problem, 40).y;
  problem.derivatives = SparseLinearPart{SparseMatrix(a.sparseView())};
  const Rows linear = solve("bdf3", problem, 40).y;
  EXPECT_LT((differenced - dense).cwiseAbs().maxCoeff(), 1e-13);
  EXPECT_LT((sparse - dense).cwiseAbs().maxCoeff(), 1e-13);
  EXPECT_LT((linear - dense).cwiseAbs().maxCoeff(), 1e-13);
}

Problem sparse_problem(const SparseMatrix& a, const std::vector<double>& orders, double cubic) {
  Problem problem;
  for (Eigen::Index i = 0; i < a.rows(); ++i) {
    const double order = orders[static_cast<std::size_t>(i) % orders.size()];
    problem.components.push_back({order, std::vector<double>(initial_count(order), 0.0)});
    problem.components.back().initial.front() = std::sin(static_cast<double>(i));
  }
  problem.rhs = [=](double, In y, Out f) { f = a * y - cubic * y.array().cube().matrix(); };
  if (cubic == 0.0) {
    problem.derivatives = SparseLinearPart{a};
  } else {
    problem.derivatives = SparseJacobian{[=](double, In y, SparseMatrix& jacobian) {
      jacobian = a;
      for (Eigen::Index i = 0; i < y.size(); ++i) jacobian.coeffRef(i, i) -= 3.0 * cubic * y[i] * y[i];
    }};
  }
  return problem;
}

// One df/dy for all first steps, which decouples them, and the matrix of all steps together (rows of two
// orders, or no derivatives) solve the same equations.
TEST(StartingProcedure, DecouplesStepsOfSparseProblems) {
  const SparseMatrix line =
      0.01 *
      std::get<SparseLinearPart>(scene_of("fractional_diffusion", {{"components", 12.0}}).problem.derivatives)
          .matrix;
  for (const auto* family :
       {&families::bdf2, &families::bdf4, &families::newton_gregory_3, &families::fractional_trapezoidal}) {
    for (const auto& orders : {std::vector{0.5}, {0.8}, {1.4}, {0.5, 0.8}}) {
      for (const double cubic : {0.0, 0.5}) {
        Problem problem = sparse_problem(line, orders, cubic);
        const auto sparse = solve(family->id, problem, 40);
        ASSERT_EQ(sparse.status, SolveStatus::finished) << family->id;
        problem.derivatives = NoDerivatives{};
        const Rows others = solve(family->id, problem, 40).y;
        const double amplified = 1e-14 * starting_powers(*family, problem).growth;
        EXPECT_LT((sparse.y - others).cwiseAbs().maxCoeff(), std::max(2e-12, amplified))
            << family->id << ' ' << orders.front();
      }
    }
  }
}

// The system of the first steps has a second solution where the steps do not resolve the motion: x = -0.1,
// y = 109. Newton's method does not converge, or converges to it and the step is rejected as too large for a
// growing mode; rounding decides which.
TEST(StartingProcedure, AreNotAnotherSolution) {
  const Problem brusselator = scene_of("brusselator").problem;
  for (const auto* scheme : {"bdf4", "bdf5", "bdf6"}) {
    const auto coarse = solve(scheme, brusselator, 64);
    EXPECT_TRUE(coarse.status == SolveStatus::not_converged || coarse.status == SolveStatus::step_too_large)
        << scheme;
    EXPECT_EQ(coarse.failure_time, brusselator.end / 64) << scheme;
    EXPECT_EQ(solve(scheme, brusselator, 256).status, SolveStatus::finished) << scheme;
  }
}

// The starting weights of a longer run with the same orders are kept by the process.
TEST(MultistepSchemes, ReportTheMemoryOfTheRunWhateverRanBefore) {
  const Problem problem{.components = {{0.53, {1.0}}}, .rhs = [](double, In y, Out f) { f = -y; }};
  const auto bytes = [&](int steps) { return solve("bdf6", problem, steps).cost.history_bytes; };
  const auto before = bytes(100);
  EXPECT_GT(bytes(100'000), before);
  EXPECT_EQ(bytes(100), before);
}

// E_{1/2}(-1) = e erfc(1); DLMF 7.
TEST(MultistepSchemes, RelaxationToTwelveDigits) {
  const Problem problem{.components = {{0.5, {1.0}}}, .rhs = [](double, In y, Out f) { f = -y; }};
  EXPECT_NEAR(solve("bdf4", problem, 512).y(0, 512), 0.42758357615580700, 1e-12);
  EXPECT_NEAR(solve("fractional_trapezoidal", problem, 8192).y(0, 8192), 0.42758357615580700, 1e-10);
}

TEST(MultistepSchemes, NewtonGregoryOfRateTwoIsExplicitAtOrderTwo) {
  const Problem problem{.components = {{2.0, {1.0, 0.0}}}};
  EXPECT_EQ(unsupported_reason(*find_scheme("newton_gregory_2"), problem, Grid{1.0, 8}),
            "is explicit at order 2, that of component 0");
}

}  // namespace
}  // namespace fde::bench
