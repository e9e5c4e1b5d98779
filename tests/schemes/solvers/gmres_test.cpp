// SPDX-License-Identifier: MIT
#include "fdebench/schemes/solvers/gmres.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fde::bench {
namespace {

// A fixed matrix, identity and a part that is not symmetric.
Matrix some_matrix(Eigen::Index size) {
  return Matrix::Identity(size, size) + Matrix::NullaryExpr(size, size, [](Eigen::Index i, Eigen::Index j) {
           return std::sin(1.0 + static_cast<double>(i * 3 + j * j)) / (1.0 + static_cast<double>(i + j));
         });
}

TEST(Gmres, SolvesInAsManyApplicationsAsThereAreUnknowns) {
  for (const Eigen::Index size : {1, 2, 3, 40}) {
    const Matrix a = some_matrix(size);
    const Vec x = Vec::LinSpaced(size, 1.0, 2.0), b = a * x;
    int applications = 0;
    const auto apply = [&](const Vec& v) -> Vec {
      ++applications;
      return a * v;
    };
    EXPECT_LT((gmres(apply, b, 1e-14, 100) - x).cwiseAbs().maxCoeff(), 1e-11) << size;
    EXPECT_LE(applications, size + 1);
  }
}

TEST(Gmres, TheIdentityTakesOneApplicationAndZeroNone) {
  int applications = 0;
  const auto apply = [&](const Vec& v) -> Vec {
    ++applications;
    return v;
  };
  const Vec b = Vec::LinSpaced(50, -1.0, 1.0);
  EXPECT_LT((gmres(apply, b, 1e-12, 20) - b).norm(), 1e-14);
  EXPECT_LE(applications, 2);  // the first is for the initial guess 0
  EXPECT_EQ(gmres(apply, Vec::Zero(50), 1e-12, 20), Vec::Zero(50));
}

// Squares of such numbers are 0 or infinite.
TEST(Gmres, SolvesForRightHandSidesOfAnySize) {
  const Matrix a = some_matrix(40);
  const auto apply = [&](const Vec& v) -> Vec { return a * v; };
  const Vec b = a * Vec::Ones(40), x = gmres(apply, b, 1e-12, 40);
  for (const double size : {0x1p-600, 0x1p600}) EXPECT_EQ(gmres(apply, size * b, 1e-12, 40), size * x);
}

TEST(Gmres, StopsAtTheApplicationsAllowed) {
  const Matrix a = some_matrix(40);
  const Vec x = gmres([&](const Vec& v) -> Vec { return a * v; }, a* Vec::Ones(40), 1e-14, 5);
  EXPECT_TRUE(x.allFinite());
  const double left = (a * (Vec::Ones(40) - x)).norm() / (a * Vec::Ones(40)).norm();
  EXPECT_LT(left, 0.5);
  EXPECT_GT(left, 1e-10);
}

}  // namespace
}  // namespace fde::bench
