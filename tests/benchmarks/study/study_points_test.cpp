// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "benchmarks/study/study_testing.hpp"
#include "fdebench/benchmarks/study/exact_numbers.hpp"
#include "support/matchers.hpp"

namespace fde::bench {
namespace {

// From mpmath with 160 bits and another implementation of mt19937_64, checked by its 10000th output.
TEST(ExactNumbers, AreThoseOfAnotherProgram) {
  NumberSource source(7);
  EXPECT_EQ(source.uniform(0.1, 0.9), 0.7035082433222865);
  EXPECT_EQ(source.uniform(-1.0, -1e6, Spacing::logarithmic), -496371.9338107349);
  EXPECT_EQ(source.normal(0.5, 0.1), 0.6610556314140249);
  EXPECT_EQ(source.uniform(0.0, 2.0), 0.2825431264075736);
  EXPECT_EQ(spaced_number(-0.3, -7.0, 1, 4, Spacing::logarithmic), -0.8572618882313395);
  EXPECT_EQ(spaced_number(-0.3, -7.0, 2, 4, Spacing::logarithmic), -2.449659816713206);
}

TEST(ExactNumbers, HaveTheMomentsOfTheirDistributions) {
  constexpr int count = 20'000;
  const double six_deviations = 6.0 / std::sqrt(static_cast<double>(count));
  NumberSource source(1);
  double sum = 0.0, squares = 0.0, uniform = 0.0, logarithm = 0.0;
  for (int i = 0; i < count; ++i) {
    const double x = source.normal(0.0, 1.0);
    sum += x;
    squares += x * x;
    uniform += source.uniform(0.0, 1.0);
    logarithm += std::log10(source.uniform(1.0, 10.0, Spacing::logarithmic));
  }
  EXPECT_NEAR(sum / count, 0.0, six_deviations);
  EXPECT_NEAR(squares / count, 1.0, std::sqrt(2.0) * six_deviations);
  EXPECT_NEAR(uniform / count, 0.5, six_deviations / std::sqrt(12.0));
  EXPECT_NEAR(logarithm / count, 0.5, six_deviations / std::sqrt(12.0));
}

TEST(StudyPointsOf, RangesAreExactDecimalsAndDecades) {
  EXPECT_THAT(
      points_of(
          "[[family]]\nscene = \"relaxation\"\nparameters.gamma = {from = 0.1, to = 0.5, step = 0.2}\n"),
      ElementsAre("gamma=0.1", "gamma=0.3", "gamma=0.5"));
  EXPECT_THAT(
      points_of("[[family]]\nscene = \"relaxation\"\nparameters.gamma = {from = 0.1, to = 0.9, count = 5}\n"),
      ElementsAre("gamma=0.1", "gamma=0.3", "gamma=0.5", "gamma=0.7", "gamma=0.9"));
  EXPECT_THAT(points_of("[[family]]\nscene = \"relaxation\"\n"
                        "parameters.lambda = {from = -1, to = -1000, count = 4, spacing = \"log\"}\n"),
              ElementsAre("lambda=-1", "lambda=-10", "lambda=-100", "lambda=-1000"));
}

TEST(StudyPointsOf, RangesAndListsAreTheirProductTheLastVaryingFastest) {
  EXPECT_THAT(points_of("[[family]]\nscene = \"relaxation\"\nuntil = [1, 2]\n"
                        "parameters = {lambda = [-2, -1], gamma = 0.5}\n"),
              ElementsAre("gamma=0.5,lambda=-2,until=1", "gamma=0.5,lambda=-2,until=2",
                          "gamma=0.5,lambda=-1,until=1", "gamma=0.5,lambda=-1,until=2"));
}

TEST(StudyPointsOf, AListIsOneValueOfAParameterThatIsAList) {
  EXPECT_THAT(points_of("[[family]]\nscene = \"multi_term\"\nparameters.alpha = [1.2, 1.6]\n"),
              ElementsAre("alpha=1.2,1.6"));
  EXPECT_THAT(points_of("[[family]]\nscene = \"multi_term\"\nparameters.alpha = [[1.2, 1.6], [1.1, 1.6]]\n"),
              ElementsAre("alpha=1.2,1.6", "alpha=1.1,1.6"));
}

std::string drawn(int draws, const std::string& more = "") {
  return "[[family]]\nscene = \"relaxation\"\nseed = 3\ndraws = " + std::to_string(draws) + "\n" +
         "[family.parameters]\ngamma = {distribution = \"uniform\", from = 0.2, to = 0.8}\n"
         "lambda = {distribution = \"log-uniform\", from = -1, to = -100}\n" +
         more;
}

TEST(StudyPointsOf, DrawsVaryTogetherAndAreTheSameWithMoreDraws) {
  const auto few = points_of(drawn(3));
  auto many = points_of(drawn(10));
  EXPECT_EQ(many.size(), 10U);
  many.resize(3);
  EXPECT_EQ(few, many);
  const auto product = points_of(drawn(3, "y0 = [1, 2]\n"));
  ASSERT_EQ(product.size(), 6U);
  EXPECT_EQ(product[0], few[0] + ",y0=1");
  EXPECT_EQ(product[3], few[0] + ",y0=2");
}

TEST(StudyPointsOf, ANormalDistributionIsDrawnAgainOutsideItsRange) {
  const auto study = study_of(
      "[[family]]\nscene = \"relaxation\"\ndraws = 500\n"
      "parameters.gamma = {distribution = \"normal\", mean = 0.9, deviation = 0.3, from = 0.1, to = 1}\n");
  ASSERT_EQ(study.families.at(0).scenes.size(), 500U);
  for (const auto& scene : study.families[0].scenes) {
    EXPECT_GE(std::get<double>(scene.values.at("gamma")), 0.1);
    EXPECT_LE(std::get<double>(scene.values.at("gamma")), 1.0);
  }
}

TEST(StudyTexts, AreReadBackToTheSameScenesAndSettings) {
  const std::string settings =
      "schemes = [\"l1\", \"bdf2\"]\nsteps = [8, 16]\naccuracies = 1e-3\ngrid = \"graded:2\"\n"
      "history = \"direct\"\ntolerance = 1e-10\nbudget = 2.5\nrepeat = 1\nexternal = {\"my one\" = \"./a "
      "\\\"b\\\"\"}\n";
  const auto study = study_of(settings + drawn(4) +
                              "[[family]]\nscene = \"multi_term\"\nschemes = \"l1\"\n"
                              "points = [{alpha = [1.2, 1.6], until = 2}, {}]\n");
  const auto copy = study_of(text_of(study, "."));
  EXPECT_EQ(points_of(copy), points_of(study));
  ASSERT_EQ(copy.families.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const StudySettings& of = study.families[i].settings;
    EXPECT_EQ(of.places.size(), 9U);
    EXPECT_EQ(text_of(copy.families[i].settings), text_of(of));
    EXPECT_EQ(of.request.settings.grading, 2.0);
    EXPECT_EQ(of.request.programs.front().command, "./a \"b\"");
  }
  EXPECT_THAT(study.families[1].settings.request.schemes, ElementsAre(find_scheme("l1")));
  EXPECT_EQ(study.families[0].settings.request.schemes.size(), 2U);
}

}  // namespace
}  // namespace fde::bench
