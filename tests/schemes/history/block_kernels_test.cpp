// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/block_kernels.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>

#include "fdebench/schemes/problem/problem.hpp"

namespace fde::bench {
namespace {

using Real = long double;

// Half a unit in the last place of a double, relative to it.
constexpr Real long_unit = std::numeric_limits<double>::epsilon() / 2;

// Entries of both signs, so that cancellation amplifies errors.
Matrix random_matrix(Eigen::Index rows, Eigen::Index columns, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  return Matrix::NullaryExpr(rows, columns, [&] { return uniform(generator); });
}

ConstBlock reading(const Matrix& matrix) { return {matrix.data(), matrix.rows()}; }
Block writing(Matrix& matrix) { return {matrix.data(), matrix.rows()}; }

bool multiplies_and_adds_at_once(std::string_view target) { return target.starts_with("AVX"); }

std::string test_name(const testing::TestParamInfo<std::string_view>& test) {
  return std::string(test.param);
}

// A sum of products and its error bound for any order of summation: one rounding of the sum of absolute
// values for each term.
struct Sum {
  Real value = 0, absolute = 0;
  int terms = 0;
  void add(Real a, Real b) {
    value += a * b;
    absolute += std::abs(a * b);
    ++terms;
  }
  [[nodiscard]] bool agrees(double result) const {
    return std::abs(static_cast<Real>(result) - value) <= terms * long_unit * absolute;
  }
};

class BlockKernels : public testing::TestWithParam<std::string_view> {
 protected:
  void SetUp() override { select_vector_target(GetParam()); }
  void TearDown() override { select_vector_target(vector_targets().front()); }

  // Expects the same bits as with the widest target, where both have a fused multiply-add.
  template <typename Compute>
  static void expect_the_bits_of_the_widest(Compute compute) {
    if (!multiplies_and_adds_at_once(GetParam())) return;
    const auto here = compute();
    select_vector_target(vector_targets().front());
    EXPECT_EQ(here, compute());
    select_vector_target(GetParam());
  }
};

// c has additional rows and an additional column, which must not change.
TEST_P(BlockKernels, MultiplyAddAddsTheProduct) {
  constexpr Eigen::Index border = lanes;
  for (Eigen::Index rows = lanes; rows <= 40; rows += lanes) {
    for (Eigen::Index columns = 1; columns <= 9; ++columns) {
      for (Eigen::Index inner = 0; inner <= 40; ++inner) {
        const Matrix a = random_matrix(rows + border, inner, 1), b = random_matrix(inner + 3, columns, 2),
                     c = random_matrix(rows + border, columns + 1, 3);
        const auto product = [&] {
          Matrix result = c;
          multiply_add(rows, inner, columns, reading(a), reading(b), writing(result));
          return result;
        };
        const Matrix result = product();
        bool agrees =
            result.bottomRows(border) == c.bottomRows(border) && result.col(columns) == c.col(columns);
        for (Eigen::Index j = 0; j < columns; ++j) {
          for (Eigen::Index i = 0; i < rows; ++i) {
            Sum sum;
            sum.add(c(i, j), 1);
            for (Eigen::Index k = 0; k < inner; ++k) sum.add(a(i, k), b(k, j));
            agrees = agrees && sum.agrees(result(i, j));
          }
        }
        ASSERT_TRUE(agrees) << rows << " x " << inner << " x " << columns;
        expect_the_bits_of_the_widest(product);
      }
    }
  }
}

// Two tables with eight entries each; the second is added to c 24 rows below, and the rows between must not
// change.
TEST_P(BlockKernels, ScatterAddsEightEntriesAColumnForEachTable) {
  constexpr Eigen::Index tables = 2, below = 3 * lanes;
  for (Eigen::Index columns = 0; columns <= 9; ++columns) {
    const Matrix a = random_matrix(tables * lanes, 1, 1), b = random_matrix(columns + 1, 1, 2),
                 c = random_matrix(below + 2 * lanes, columns + 1, 3);
    const auto scattered = [&] {
      Matrix result = c;
      add_outer_product(tables, a.data(), b.data(), columns, below, writing(result));
      return result;
    };
    const Matrix result = scattered();
    EXPECT_EQ(result.middleRows(lanes, below - lanes), c.middleRows(lanes, below - lanes));
    EXPECT_EQ(result.bottomRows(lanes), c.bottomRows(lanes));
    EXPECT_EQ(result.col(columns), c.col(columns));
    for (Eigen::Index j = 0; j < columns; ++j) {
      for (Eigen::Index i = 0; i < tables * lanes; ++i) {
        const auto row = i / lanes * below + i % lanes;
        Sum sum;
        sum.add(c(row, j), 1);
        sum.add(a(i), b(j));
        EXPECT_TRUE(sum.agrees(result(row, j))) << i << ", " << j;
      }
    }
    expect_the_bits_of_the_widest(scattered);
  }
}

TEST_P(BlockKernels, DotProductTakesAnyLengthAndAlignment) {
  constexpr Eigen::Index longest = 200, farthest = 7;
  const Matrix a = random_matrix(longest + farthest, 1, 1), b = random_matrix(longest + farthest, 1, 2);
  for (Eigen::Index offset = 0; offset <= farthest; ++offset) {
    for (Eigen::Index length = 0; length <= longest; ++length) {
      const double *const first = a.data() + offset, *const second = b.data() + (farthest - offset);
      const auto product = [=] { return dot_product(first, second, length); };
      Sum sum;
      for (Eigen::Index k = 0; k < length; ++k) sum.add(first[k], second[k]);
      EXPECT_TRUE(sum.agrees(product())) << length << " from " << offset;
      expect_the_bits_of_the_widest(product);
    }
  }
}

// phi_k by its series where there is no cancellation, otherwise by recurrence from exp.
Real exact_phi(int k, Real x) {
  if (x > 4)
    return k == 0 ? std::exp(-x) : ((k == 1 ? 1 : k == 2 ? 1 : Real{1} / 2) - exact_phi(k - 1, x)) / x;
  Real term = k == 3 ? Real{1} / 6 : k == 2 ? Real{1} / 2 : 1, sum = 0;
  for (int i = 0; std::abs(term) > 1e-25L; term *= -x / (++i + k)) sum += term;
  return sum;
}

TEST_P(BlockKernels, PhiFunctionsAreGoodToAFewUnits) {
  constexpr Eigen::Index rows = 30 * lanes;
  Vec nodes(rows);
  for (Eigen::Index i = 0; i < rows; ++i) nodes[i] = 1e-12 * std::pow(1.145, static_cast<double>(i));
  nodes.tail(3).setConstant(nodes[rows - 4]);
  for (const double length : {1.0, 0.37, 1e4, 1e-8}) {
    const auto functions = [&] {
      Matrix all(rows, 4);
      phi_functions(rows, length, nodes.data(), writing(all), all.col(3).data());
      return all;
    };
    const Matrix all = functions();
    for (Eigen::Index i = 0; i < rows; ++i) {
      const Real x = static_cast<Real>(length * nodes[i]);
      if (x > 700) break;
      for (int k = 1; k <= 3; ++k) {
        const Real exact = exact_phi(k, x);
        EXPECT_LE(std::abs(all(i, k - 1) - exact), 16 * long_unit * exact)
            << "phi_" << k << '(' << double(x) << ')';
      }
      EXPECT_LE(std::abs(all(i, 3) - std::expm1(-x)), 8 * long_unit * -std::expm1(-x)) << double(x);
    }
    expect_the_bits_of_the_widest(functions);
  }
}

// The change has three roundings, each at most a unit of its terms; the rounding error of the sum is in the
// carry.
TEST_P(BlockKernels, AdvanceKeepsInTheCarryWhatRoundingTook) {
  for (Eigen::Index rows = lanes; rows <= 40; rows += lanes) {
    for (Eigen::Index columns = 1; columns <= 9; ++columns) {
      const Matrix decay = random_matrix(rows, 1, 1), input = random_matrix(rows, columns, 2),
                   state = random_matrix(rows, columns, 3), carry = 1e-17 * random_matrix(rows, columns, 4);
      const auto advanced = [&] {
        Matrix both(rows, 2 * columns);
        both << state, carry;
        advance_states(rows, columns, decay.data(), reading(input), {both.data(), rows},
                       {both.data() + columns * rows, rows});
        return both;
      };
      const Matrix result = advanced();
      for (Eigen::Index j = 0; j < columns; ++j) {
        for (Eigen::Index i = 0; i < rows; ++i) {
          const double total = result(i, j), rest = result(i, columns + j);
          const Real change = static_cast<Real>(decay(i)) * state(i, j) + input(i, j) + carry(i, j);
          const Real size = std::abs(decay(i) * state(i, j)) + std::abs(input(i, j)) + std::abs(carry(i, j));
          EXPECT_LE(std::abs((static_cast<Real>(total) - state(i, j)) + rest - change), 3 * long_unit * size);
          EXPECT_EQ(total + rest, total);
        }
      }
      expect_the_bits_of_the_widest(advanced);
    }
  }
}

// The input of each column is a sum of three products; the rest is `advance_states`.
TEST_P(BlockKernels, AdvanceIntegralsAddsThePolynomialsOfEachColumn) {
  constexpr Eigen::Index rows = 5 * lanes, columns = 3;
  const Matrix decay = random_matrix(rows, 1, 1), phi = random_matrix(rows, 3, 2),
               polynomials = random_matrix(3, columns, 3), state = random_matrix(rows, columns, 4),
               carry = 1e-17 * random_matrix(rows, columns, 5);
  const auto advanced = [&] {
    Matrix both(rows, 2 * columns);
    both << state, carry;
    advance_integrals(rows, columns, decay.data(), reading(phi), reading(polynomials), {both.data(), rows},
                      {both.data() + columns * rows, rows});
    return both;
  };
  Matrix input = Matrix::Zero(rows, columns), expected(rows, 2 * columns);
  multiply_add(rows, 3, columns, reading(phi), reading(polynomials), writing(input));
  expected << state, carry;
  advance_states(rows, columns, decay.data(), reading(input), {expected.data(), rows},
                 {expected.data() + columns * rows, rows});
  EXPECT_EQ(advanced(), expected);
  expect_the_bits_of_the_widest(advanced);
}

TEST_P(BlockKernels, ApplyDecayMultipliesAndWeighAddsTwoProducts) {
  constexpr Eigen::Index rows = 3 * lanes;
  const Matrix a = random_matrix(rows, 1, 1), b = random_matrix(rows, 1, 2), c = random_matrix(rows, 1, 3);
  const auto both = [&] {
    Matrix result(rows, 2);
    apply_decay(rows, a.data(), b.data(), result.data());
    weighted_sum(rows, a.data(), b.data(), 0.7, c.data(), result.data() + rows);
    return result;
  };
  const Matrix result = both();
  for (Eigen::Index i = 0; i < rows; ++i) {
    Sum decayed;
    decayed.add(a(i), 1);
    decayed.add(a(i), b(i));
    EXPECT_TRUE(decayed.agrees(result(i, 0))) << i;
    EXPECT_EQ(result(i, 1), a(i) * b(i) + 0.7 * c(i)) << i;
  }
  expect_the_bits_of_the_widest(both);
}

// Each change has an error of at most three units, and the changes add up to the state. Without a carry the
// rounding of a million sums would be a hundred units and more.
TEST_P(BlockKernels, AdvanceLosesNothingOverAMillionSlowDecays) {
  constexpr int calls = 1'000'000;
  const Matrix decay = Matrix::Constant(lanes, 1, -1e-9);
  const Matrix input = Vec::LinSpaced(lanes, 0.1, 1.7);
  Matrix state = Matrix::Zero(lanes, 1), carry = state;
  for (int n = 0; n < calls; ++n) {
    advance_states(lanes, 1, decay.data(), reading(input), writing(state), writing(carry));
  }
  const Real d = decay(0), exact = std::expm1(calls * std::log1p(d)) / d;
  for (Eigen::Index i = 0; i < lanes; ++i) {
    EXPECT_LE(std::abs((state(i) + static_cast<Real>(carry(i))) / (input(i) * exact) - 1), 3 * long_unit)
        << i;
  }
}

INSTANTIATE_TEST_SUITE_P(, BlockKernels, testing::ValuesIn(vector_targets()), test_name);

TEST(VectorTargets, ThatFuseMultiplyAndAddAreTheWidest) {
  const auto targets = vector_targets();
  ASSERT_FALSE(targets.empty());
  EXPECT_TRUE(std::ranges::is_partitioned(targets, multiplies_and_adds_at_once));
}

}  // namespace
}  // namespace fde::bench
