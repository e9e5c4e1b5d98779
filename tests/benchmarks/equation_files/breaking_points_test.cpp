// SPDX-License-Identifier: MIT
// Theoretical rates where the right-hand side has breaking points that no starting procedure knows, against
// errors.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "benchmarks/equation_files/equation_files_testing.hpp"
#include "fdebench/benchmarks/references/memoized_reference.hpp"
#include "fdebench/schemes/stepping/rates.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

struct Rates {
  std::string scheme;
  double end, maximum;
};

class BreakingPoints : public testing::Test {
 protected:
  // The theory of all schemes, and errors over grids that contain the breaking points.
  static void expect_rates(const std::string& text, int steps, const std::vector<Rates>& all) {
    const Scene scene = scene_of_text(text);
    MemoizedReference reference(scene);
    for (const auto& [id, end, maximum] : all) {
      const auto& scheme = *find_scheme(id);
      const auto errors = [&](int n) {
        const auto path = scheme.solve(scene.problem, Grid{scene.problem.end, n}, {});
        return Rows((columns_of(scene.outputs, path) - reference.at(path.times)).cwiseAbs());
      };
      const Rows coarse = errors(steps), fine = errors(2 * steps);
      const auto theory = [&](Norm norm) {
        return theoretical_rate(scheme, scene.problem, scene.smoothness, Grid{scene.problem.end, steps},
                                norm);
      };
      EXPECT_EQ(theory(Norm::end), end) << id;
      EXPECT_EQ(theory(Norm::maximum), maximum) << id;
      EXPECT_NEAR(std::log2(coarse(0, coarse.cols() - 1) / fine(0, fine.cols() - 1)), end, 0.1) << id;
      EXPECT_NEAR(std::log2(coarse.maxCoeff() / fine.maxCoeff()), maximum, 0.1) << id;
    }
  }
};

// D^g y = -y + (t - 1)_+^p: y ~ (t - 1)^(g+p) behind t = 1, where rules of convolution are correct to 1 + p,
// and to 2 where p = 0 is taken as the mean of both one-sided values. Rules that interpolate f see no error
// in p = 1.
TEST_F(BreakingPoints, OfLoadsLimitTheRate) {
  const std::string equation = "end = 2.0\n[unknown.y]\norder = 0.5\ninitial = [0.0]\nrhs = ";
  expect_rates(
      equation + "\"-y + step(t - 1)\"", 1024,
      {{"bdf3", 2.0, 0.5}, {"bdf4", 2.0, 0.5}, {"product_trapezoidal", 2.0, 0.5}, {"l2_1_sigma", 1.0, 0.5}});
  expect_rates(
      equation + "\"-y + max(t - 1, 0)\"", 1024,
      {{"bdf2", 2.0, 1.5}, {"bdf4", 2.0, 1.5}, {"product_trapezoidal", 2.0, 2.0}, {"l1_2", 2.0, 1.5}});
}

// y leaves 1 like t^g, so that f has a kink of this power one lag after 0.
TEST_F(BreakingPoints, OfDelaysLimitTheRate) {
  expect_rates(
      "end = 3.0\n[unknown.y]\norder = 0.8\ninitial = [1.0]\nbefore = \"1\"\nrhs = \"-1.5*y(t - 1)\"", 1536,
      {{"bdf3", 1.8, 1.6}, {"bdf4", 1.8, 1.6}});
}

}  // namespace
}  // namespace fde::bench
