// SPDX-License-Identifier: MIT
// Equations of orders above 2 in files: chains of any length.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "benchmarks/equation_files/equation_files_testing.hpp"
#include "fdebench/benchmarks/references/reference_of.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

double by_spectral_collocation(const Problem& problem) {
  const auto path =
      solve("spectral_collocation", problem, Tolerance{1e-11, 1e-11}, {.output_times = {problem.end}});
  EXPECT_EQ(path.status, SolveStatus::finished);
  return path.y(0, path.y.cols() - 1);
}

// D^q x = -x, x(0) = 1 and no slopes: x = E_q(-t^q).
TEST(HighOrders, OfOneTermAreMittagLefflerFunctions) {
  for (const double q : {2.2, 2.5, 3.0, 3.7, 5.0}) {
    std::string initial = "1";
    for (int k = 1; k < q; ++k) initial += ", 0";
    const Scene scene = scene_of_text(
        fmt::format("end = 2\n[unknown.x]\norder = {}\nrhs = \"-x\"\ninitial = [{}]\n", q, initial));
    const double exact = reference::mittag_leffler(q, 1.0, -std::pow(2.0, q));
    EXPECT_EQ(scene.outputs.names.size(), static_cast<std::size_t>(std::ceil(q)));
    EXPECT_NEAR(reference_of(scene).at(2.0).value[0], exact, 1e-14 * (1.0 + std::abs(exact))) << q;
    EXPECT_NEAR(by_spectral_collocation(scene.problem), exact, 1e-9) << q;
    EXPECT_NEAR(solve("bdf3", scene.problem, 1024).y(0, 1024), exact, 2e-5) << q;
  }
}

// x = t^4 solves an equation of six terms with a nonlinear part; its derivatives are columns.
TEST(HighOrders, MayHaveLowerTermsOfAnyOrder) {
  const Scene scene = scene_of_text(
      "end = 1\n[unknown.x]\nterms = [[1, 3.4], [0.5, 2.5], [1, 2], [4, 1], [2, 0.5], [1, 0]]\ninitial = [0, "
      "0, 0, 0]\n"
      "rhs = \"24/gamma(1.6)*t^0.6 + 12/gamma(2.5)*t^1.5 + 12*t^2 + 16*t^3 + 48/gamma(4.5)*t^3.5 + t^4 + t^8 "
      "- x^2\"\n");
  EXPECT_NEAR(by_spectral_collocation(scene.problem), 1.0, 1e-9);
  const auto [value, bound] = reference_of(scene).at(1.0);
  EXPECT_NEAR(value[0], 1.0, bound[0] + 1e-13);
  const auto names = scene.outputs.names;
  const auto third = std::ranges::find(names, "D(x,3)") - names.begin();
  ASSERT_LT(third, std::ssize(names));
  EXPECT_NEAR(value[third], 24.0, bound[third] + 1e-11);
}

// x'''' = x, x = cosh t + cos t + ... from its four initial values.
TEST(HighOrders, OfIntegersAreOrdinary) {
  const Scene scene = scene_of_text("end = 3\n[unknown.x]\norder = 4\nrhs = \"x\"\ninitial = [2, 0, 0, 0]\n");
  const double exact = std::cosh(3.0) + std::cos(3.0);
  EXPECT_NEAR(reference_of(scene).at(3.0).value[0], exact, 1e-13);
  EXPECT_NEAR(by_spectral_collocation(scene.problem), exact, 1e-8);
}

TEST(HighOrders, AreNotTakenByRulesForTheIntegratedEquation) {
  const Scene scene =
      scene_of_text("end = 3\n[unknown.x]\nterms = [[1, 2.5], [1, 1]]\nrhs = \"-x\"\ninitial = [2, 0, 0]\n");
  EXPECT_EQ(unsupported_reason(*find_scheme("multi_term_bdf2"), scene.problem, Grid{3.0, 100}),
            "takes leading orders up to 2, not 2.5");
}

}  // namespace
}  // namespace fde::bench
