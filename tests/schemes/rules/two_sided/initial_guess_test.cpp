// SPDX-License-Identifier: MIT
// Two-sided problems for which Newton's method does not converge from the Taylor part, or whose solutions of
// one side grow so much until the end that elimination of the other side loses all digits.

#include "fdebench/schemes/problem/initial_guess.hpp"

#include <gtest/gtest.h>

#include <string>

#include "fdebench/benchmarks/references/reference_of.hpp"
#include "support/two_sided_scenes.hpp"

namespace fde::bench {
namespace {

struct LongEnds {
  std::string scene;
  ParameterValues values;
  Vec middle;        // q1, q2 at T/2
  double tolerance;  // of the scheme, relative
};
// NOLINTNEXTLINE(readability-identifier-naming): GoogleTest looks for this name.
void PrintTo(const LongEnds& problem, std::ostream* out) { *out << problem.scene; }

class LongEnd : public testing::TestWithParam<LongEnds> {};

TEST_P(LongEnd, IsSolvedByReferenceAndScheme) {
  const auto& [id, values, middle, tolerance] = GetParam();
  const Scene scene = scene_of(id, values);
  const Vec known = reference_of(scene).at(scene.problem.end / 2).value.head(2);
  EXPECT_LT((known - middle).norm(), 2e-6 * middle.norm());
  const auto path = solve("product_trapezoidal", scene.problem, 512);
  ASSERT_EQ(path.status, SolveStatus::finished);
  const Vec found = columns_of(scene.outputs, path).col(256).head(2);
  EXPECT_LT((found - known).norm(), tolerance * known.norm());
}

// Values of an independent product integration (NumPy, meshes clustered at both ends).
INSTANTIATE_TEST_SUITE_P(
    Linear, LongEnd,
    testing::ValuesIn<LongEnds>(
        {{"fractional_vakonomic", {{"c1", 3.0}, {"T", 5.0}}, Vec({{-1.890325, 1.442469}}), 0.01},
         {"two_sided_constraint",
          {{"motion", "given"}, {"k3", 0.0}, {"c1", 3.0}, {"T", 5.0}},
          Vec({{22.39794, 0.64391}}),
          0.01}}));
INSTANTIATE_TEST_SUITE_P(
    Nonlinear, LongEnd,
    testing::Values(LongEnds{
        "two_sided_constraint", {{"motion", "given"}, {"T", 5.0}}, Vec({{-4.393703, -6.106537}}), 1e-3}));

// y(0) + t y'(0) from the left, y(end) from the right, and cos(2 pi t / end).
TEST(OtherStarts, AreTheTaylorPartAndFourCosinesTheSameAtEachCall) {
  const Problem problem{.components = {{1.5, {2.0, -1.0}}, {0.5, {0.25}, Side::right}},
                        .rhs = [](double, In y, Out f) { f = y; },
                        .end = 4.0};
  const InitialGuess taylor(problem, Matrix::Zero(2, 4));
  EXPECT_EQ(taylor.at(3.0), Vec({{-1.0, 0.25}}));
  Matrix amplitudes = Matrix::Zero(2, 4);
  amplitudes(1, 2) = 8.0;
  EXPECT_NEAR(InitialGuess(problem, amplitudes).at(2.0)[1], 0.25 - 8.0, 1e-15);
  const auto one = initial_guesses(problem, 12), same = initial_guesses(problem, 12);
  ASSERT_EQ(one.size(), 12U);
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_EQ(one[k].at(1.0), same[k].at(1.0));
    EXPECT_NE(one[k].at(1.0), one[(k + 1) % one.size()].at(1.0));
    EXPECT_LE((one[k].at(1.0) - taylor.at(1.0)).cwiseAbs().maxCoeff(), 4 * 8.0);
  }
}

}  // namespace
}  // namespace fde::bench
