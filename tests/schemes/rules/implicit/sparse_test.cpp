// SPDX-License-Identifier: MIT
// Sparse derivatives give the same results as dense ones, without a dense matrix.

#include <gtest/gtest.h>

#include "support/implicit_schemes.hpp"
#include "support/scheme_test.hpp"

namespace fde::bench {
namespace {

class Sparse : public SchemeTest {};
INSTANTIATE_TEST_SUITE_P(, Sparse, testing::ValuesIn(implicit_schemes()), id_of_param);

constexpr int size = 12;

// A ring in which each component enters the right-hand side of the next one.
Matrix ring() {
  Matrix a = -3.0 * Matrix::Identity(size, size);
  for (int i = 0; i < size; ++i) a((i + 1) % size, i) = 1.0 + 0.1 * i;
  return a;
}

// Orders from 0.3 to 1.5, those above 1 through y' = v in some schemes.
Problem chain_of_orders() {
  Problem problem{.components = {}, .rhs = {}, .end = 2.0};
  for (int i = 0; i < size; ++i) {
    const double order = 0.3 + 0.1 * i + (i > 6 ? 0.1 : 0.0);
    problem.components.push_back(order > 1.0 ? Component{order, {1.0, 0.1 * i}} : Component{order, {1.0}});
  }
  return problem;
}

TEST_P(Sparse, ALinearPartIsTheDenseOne) {
  Problem problem = chain_of_orders();
  problem.rhs = [a = ring()](double t, In y, Out f) { f = a * y + Vec::Constant(size, std::cos(t)); };
  for (const Grid& grid : grids_of(*GetParam(), 2.0, 100)) {
    Problem dense = problem, few = problem;
    dense.derivatives = DenseLinearPart{ring()};
    few.derivatives = SparseLinearPart{ring().sparseView()};
    EXPECT_LT((values(dense, grid) - values(few, grid)).cwiseAbs().maxCoeff(), 1e-14);
  }
}

TEST_P(Sparse, AJacobianIsTheDenseOne) {
  Problem problem = chain_of_orders();
  problem.rhs = [a = ring()](double, In y, Out f) { f = a * y - y.array().cube().matrix(); };
  const auto jacobian = [a = ring()](In y) -> Matrix {
    return a - Matrix((3.0 * y.array().square()).matrix().asDiagonal());
  };
  Problem dense = problem, few = problem;
  dense.derivatives = DenseJacobian{[=](double, In y, OutMatrix j) { j = jacobian(y); }};
  few.derivatives = SparseJacobian{[=](double, In y, SparseMatrix& j) { j = jacobian(y).sparseView(); }};
  for (const Grid& grid : grids_of(*GetParam(), 2.0, 100)) {
    EXPECT_LT((values(dense, grid) - values(few, grid)).cwiseAbs().maxCoeff(), 1e-14);
  }
}

// 4000 unknowns: a dense matrix has 128 MB, and its factorisation takes half a minute.
TEST_P(Sparse, ManyUnknownsAreAsManyTimesTheWork) {
  constexpr int many = 4000;
  SparseMatrix a(many, many);
  for (int i = 0; i < many; ++i) {
    a.insert(i, i) = -1e6;
    if (i > 0) a.insert(i, i - 1) = 5e5;
  }
  Problem problem{.components = {static_cast<std::size_t>(many), Component{0.5, {1.0}}},
                  .rhs = [=](double, In y, Out f) { f = a * y; },
                  .derivatives = SparseLinearPart{a}};
  const Rows linear = values(problem, {1.0, 4});
  problem.derivatives = SparseJacobian{[=](double, In, SparseMatrix& j) { j = a; }};
  EXPECT_LT((linear - values(problem, {1.0, 4})).cwiseAbs().maxCoeff(), 1e-13);
}

TEST_P(Sparse, AlgebraicRowsAreRefused) {
  Problem problem{.components = {{0.5, {1.0}}, {0.0, {1.0}}},
                  .rhs = [](double, In y, Out f) { f = -y; },
                  .derivatives = SparseLinearPart{Matrix(-Matrix::Identity(2, 2)).sparseView()}};
  EXPECT_EQ(unsupported_reason(*GetParam(), problem, Grid{1.0, 8}),
            "takes algebraic rows with a dense Jacobian only");
}

}  // namespace
}  // namespace fde::bench
