// SPDX-License-Identifier: MIT
// Linear systems compared with each other and with linear equations.

#include <fmt/format.h>

#include "support/linear_system_testing.hpp"

namespace fde::reference {
namespace {

TEST(LinearSystem, DiagonalSystemIsItsScalars) {
  const auto precision = bench::test_precision();
  const LinearSystem both{.orders = {0.4, 1.0, 1.8},
                          .initial = {{1.0}, {2.0}, {3.0, -1.0}},
                          .matrix = Vec((Vec(3) << -2.0, 0.5, -7.0).finished()).asDiagonal(),
                          .loads = {{{1.0, 0.5}}, {}, {{2.0, 0.0, 0.5}}}};
  const Reference solution = linear_reference(both);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto d = static_cast<Eigen::Index>(i);
    const Reference alone = linear_reference({.orders = {both.orders[i]},
                                              .initial = {both.initial[i]},
                                              .matrix = both.matrix.block(d, d, 1, 1),
                                              .loads = {both.loads[i]}});
    for (const double t : {0.1, 0.5, 3.0}) {
      bench::expect_equal(bench::digits_at(solution, t)[i], bench::digits_at(alone, t)[0],
                          fmt::format("{} at {}", i, t));
    }
  }
}

// A component that does not depend on a growing one keeps its value and its digits.
TEST(LinearSystem, ComponentsAreSolvedWithoutWhatTheyDoNotDependOn) {
  const auto precision = bench::test_precision();
  const Reference both = linear_reference({.orders = {0.5, 0.5},
                                           .initial = {{1.0}, {1.0}},
                                           .matrix = (Matrix(2, 2) << 100.0, 3.0, 0.0, -1.0).finished()});
  EXPECT_EQ(both.at(10.0).value[0], std::numeric_limits<double>::infinity());
  EXPECT_NEAR(both.at(4.0).value[1], mittag_leffler(0.5, 1.0, -2.0), 1e-16);
  bench::expect_equal(bench::digits_at(both, 4.0)[1],
                      real_part<BigReal>(bench::mittag_leffler_digits("0.5", "1", "-2")), "y");
}

// y'' + B D^1.5 y + C y = 8 until 1 through y, y', D^1.5 y.
TEST(LinearSystem, BagleyTorvikAsAChain) {
  const auto precision = bench::test_precision();
  const Reference chain =
      linear_reference({.orders = {1.0, 0.5, 0.5},
                        .initial = {{1.0}, {-0.3}, {0.0}},
                        .matrix = (Matrix(3, 3) << 0, 1, 0, 0, 0, 1, -0.7, 0, -0.2).finished(),
                        .loads = {{}, {}, {{8.0}, {.coefficient = -8.0, .start_time = 1.0}}}});
  const Reference equation = linear_reference({.terms = {{1.0, 2.0}, {0.2, 1.5}, {0.7, 0.0}},
                                               .initial = {1.0, -0.3},
                                               .loads = {{8.0}, {.coefficient = -8.0, .start_time = 1.0}}},
                                              {0.0, 1.0, 1.5});
  for (const double t : {0.3, 1.0, 1.1, 20.0}) {
    const auto values = bench::digits_at(chain, t), exact = bench::digits_at(equation, t);
    for (std::size_t j = 0; j < 3; ++j)
      bench::expect_equal(values[j], exact[j], fmt::format("{} at {}", j, t));
  }
}

// u'' + mu D^1.7 u + l u' + nu D^0.2 u + u = 0 through u, D^0.2 u, u', D^1.7 u.
TEST(LinearSystem, DampedOscillatorAsAChain) {
  const auto precision = bench::test_precision();
  const Reference chain = linear_reference(
      {.orders = {0.2, 0.8, 0.7, 0.3},
       .initial = {{1.0}, {0.0}, {-0.3}, {0.0}},
       .matrix = (Matrix(4, 4) << 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -1, -0.4, -0.1, -0.06).finished()});
  const Reference equation = linear_reference(
      {.terms = {{1.0, 2.0}, {0.06, 1.7}, {0.1, 1.0}, {0.4, 0.2}, {1.0, 0.0}}, .initial = {1.0, -0.3}},
      {0.0, 0.2, 1.0, 1.7});
  for (const double t : {0.3, 5.0, 50.0}) {
    const auto values = bench::digits_at(chain, t), exact = bench::digits_at(equation, t);
    for (std::size_t j = 0; j < 4; ++j)
      bench::expect_equal(values[j], exact[j], fmt::format("{} at {}", j, t));
  }
}

// The response to a load that acts until T is the response to a permanent load minus the same response
// shifted by T.
TEST(LinearSystem, PiecewiseConstantLoadsSuperpose) {
  const auto precision = bench::test_precision();
  constexpr double until = 0.75;
  const auto with = [](std::vector<Load> loads) {
    return linear_reference({.orders = {0.6, 1.4},
                             .initial = {{0.0}, {0.0, 0.0}},
                             .matrix = (Matrix(2, 2) << -1.0, 2.0, -3.0, -0.5).finished(),
                             .loads = {{}, std::move(loads)}});
  };
  const Reference pulse = with({{3.0}, {.coefficient = -3.0, .start_time = until}}), step = with({{3.0}});
  for (const double t : {0.5, 0.75, 1.0, 4.75}) {
    for (std::size_t i = 0; i < 2; ++i) {
      BigReal exact = bench::digits_at(step, t)[i];
      if (t > until) exact -= bench::digits_at(step, t - until)[i];  // a difference of binary fractions
      bench::expect_equal(bench::digits_at(pulse, t)[i], exact, fmt::format("{} at {}", i, t), BigReal(1));
    }
  }
}

TEST(LinearSystem, PermutingComponentsPermutesTheSolution) {
  const auto precision = bench::test_precision();
  const Reference one = linear_reference({.orders = {0.6, 1.4},
                                          .initial = {{1.0}, {2.0, 3.0}},
                                          .matrix = (Matrix(2, 2) << -1.0, 2.0, -3.0, -0.5).finished(),
                                          .loads = {{{1.0, 0.5}}, {}}});
  const Reference other = linear_reference({.orders = {1.4, 0.6},
                                            .initial = {{2.0, 3.0}, {1.0}},
                                            .matrix = (Matrix(2, 2) << -0.5, -3.0, 2.0, -1.0).finished(),
                                            .loads = {{}, {{1.0, 0.5}}}});
  const auto a = bench::digits_at(one, 2.0), b = bench::digits_at(other, 2.0);
  bench::expect_equal(a[0], b[1], "first");
  bench::expect_equal(a[1], b[0], "second");
}

}  // namespace
}  // namespace fde::reference
