// SPDX-License-Identifier: MIT
// Error estimates without a reference. The scenes here have one, which is withheld and used as a check.

#include "fdebench/benchmarks/search/estimated_reference.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>

#include "benchmarks/search/search_case.hpp"
#include "fdebench/benchmarks/references/memoized_reference.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/benchmarks/search/interpolated_run.hpp"
#include "fdebench/benchmarks/search/run_evaluator.hpp"
#include "fdebench/benchmarks/search/search.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

constexpr auto silence = [](const std::string&, double) {};

Scene without_reference(const Scene& scene) {
  Scene unknown = scene;
  unknown.reference = {};
  unknown.reference_problem.reset();
  return unknown;
}

class EstimatedErrors : public testing::TestWithParam<SearchCase> {
 private:
  // A search takes seconds: once for the tests of a case.
  const SearchReference& found() {
    static std::map<std::string, SearchReference> known;
    const std::string scene = GetParam().scene;
    if (!known.contains(scene))
      known[scene] = estimated_reference(unknown_, target_, "it is taken away", 30.0, silence);
    return known[scene];
  }

 protected:
  const Scene scene_ = make_scene(parse_variant(GetParam().scene));
  const AccuracyTarget target_ = target_of(scene_, GetParam());
  const Scene unknown_ = without_reference(scene_);
  const SearchReference& found_ = found();
};

// The error of the run that replaces the reference is at most the estimate.
TEST_P(EstimatedErrors, AreAgainstARunThatIsAsAccurateAsItSays) {
  ASSERT_TRUE(found_.estimate);
  const ErrorEstimate& estimate = *found_.estimate;
  EXPECT_EQ(estimate.no_reference_reason, "it is taken away");
  EXPECT_EQ(found_.reference.evidence, reference::Evidence::estimate);
  EXPECT_NE(estimate.first.scheme, estimate.second.scheme);
  EXPECT_EQ(estimate.first_steps, 2 * estimate.second_steps);
  EXPECT_LE(estimate.error(), largest_estimate_fraction * GetParam().accuracy);
  RunEvaluator evaluator(scene_, target_);
  const auto run = evaluator.evaluate(estimate.first, estimate.first_steps, 8192, 60.0);
  EXPECT_LE(run.error().value, estimate.error());
}

// A run selected by estimated errors is within the accuracy.
TEST_P(EstimatedErrors, ChooseRunsWithinTheAccuracy) {
  Scene estimated = unknown_;
  estimated.reference = found_.reference;
  const auto ways = search(estimated, target_, 10.0, silence);
  ASSERT_EQ(ways.front().outcome, SearchOutcome::accuracy_reached);
  RunEvaluator evaluator(scene_, target_);
  for (const SearchCandidate& of : ways) {
    if (of.outcome != SearchOutcome::accuracy_reached || !of.time) continue;
    const auto run = evaluator.evaluate(of.configuration, of.best.resolution, 2048, 60.0);
    EXPECT_LE(run.error().value, GetParam().accuracy) << of.configuration.scheme->id << " " << of.best.steps;
    EXPECT_NEAR(run.error().value, of.best.error().value, largest_estimate_fraction * GetParam().accuracy)
        << of.configuration.scheme->id;
  }
}

INSTANTIATE_TEST_SUITE_P(
    SceneRegistry, EstimatedErrors,
    testing::Values(SearchCase{"relaxation", {Norm::maximum, Scale::mixed}, 1e-5},
                    SearchCase{"relaxation:gamma=0.2", {Norm::maximum, Scale::mixed}, 1e-3},
                    SearchCase{"relaxation:gamma=1.5", {Norm::end, Scale::relative}, 1e-5},
                    SearchCase{"power", {Norm::maximum, Scale::absolute}, 1e-4},
                    SearchCase{"diethelm", {Norm::end, Scale::mixed}, 1e-6},
                    SearchCase{"linear_system", {Norm::maximum, Scale::mixed}, 1e-4},
                    SearchCase{"stiff_relaxation", {Norm::end, Scale::absolute}, 1e-10},
                    SearchCase{"damped_oscillator", {Norm::maximum, Scale::mixed}, 1e-3},
                    SearchCase{"relaxation:gamma=0.05", {Norm::maximum, Scale::mixed}, 1e-2},
                    SearchCase{"fractional_constraint_2d", {Norm::maximum, Scale::mixed}, 1e-4},
                    SearchCase{"fractional_extremum", {Norm::maximum, Scale::mixed}, 1e-3}));

std::string refusal(const Scene& scene, double accuracy, double seconds) {
  return message_of<std::runtime_error>([&] {
    estimated_reference(scene, {{}, accuracy, all_columns(scene)}, "it is taken away", seconds, silence);
  });
}

// An error e N^-p changes by e (2^p - 1) N^-p from N/2 to N.
TEST(Estimates, TakeMoreForTheErrorTheSlowerItFalls) {
  EXPECT_EQ(estimate_factor(4.0), 4.0);
  EXPECT_EQ(estimate_factor(2.0), 4.0);
  for (const double rate : {0.05, 0.3, 0.9}) {
    const double ratio = std::pow(2.0, rate);
    EXPECT_NEAR(estimate_factor(ratio) * (ratio - 1.0), 4.0, 1e-14) << rate;
  }
  EXPECT_EQ(estimate_factor(1.0), std::numeric_limits<double>::infinity());
  EXPECT_EQ(estimate_factor(0.0), std::numeric_limits<double>::infinity());
}

TEST(Estimates, AreRefusedWhereTwoSchemesDoNotAgree) {
  const std::string begin = "there is no reference (it is taken away), and no estimate: ";
  EXPECT_THAT(refusal(without_reference(scene_of("relaxation")), 1e-14, 4.0),
              AllOf(HasSubstr(begin), HasSubstr(" differ by "), HasSubstr("of 1.0e-14")));
}

// y' = y^2 has no solution at t = 1: no run reaches the end time.
TEST(Estimates, AreRefusedWhereNothingComesToItsEnd) {
  const Scene scene{.problem = {.components = {{1.0, {1.0}}},
                                .rhs = [](double, In y, Out f) { f = y.cwiseProduct(y); },
                                .end = 2.0},
                    .outputs = {.names = {"y"}}};
  EXPECT_THAT(refusal(scene, 1e-3, 5.0), HasSubstr("and no estimate: "));
}

// A load between two of the first steps: with a few hundred steps both runs would miss it and agree.
TEST(Estimates, SeeALoadThatFewStepsMiss) {
  Scene scene{.problem = {.components = {{1.0, {0.0}}},
                          .rhs = [](double t, In, Out f) { f[0] = t > 1e-4 && t < 3e-4 ? 1e4 : 0.0; },
                          .end = 1.0,
                          .jump_times = {1e-4, 3e-4}},
              .outputs = {.names = {"y"}}};
  const AccuracyTarget target{{Norm::end, Scale::absolute}, 0.1, all_columns(scene)};
  const auto found = estimated_reference(scene, target, "there is none", 30.0, silence);
  EXPECT_NEAR(found.reference.at(1.0).value[0], 2.0, target.accuracy);
}

// At the times t = T (n/N)^(3/2) the solution t^2 is a cubic in n.
TEST(SampledRuns, AreCubicsBetweenTheirSteps) {
  const Scene scene{.problem = {.components = {{1.0, {0.0}}},
                                .rhs = [](double t, In, Out f) { f[0] = 2.0 * t; },
                                .end = 2.0},
                    .outputs = {.names = {"y"}}};
  const InterpolatedRun run(scene, {find_scheme("product_trapezoidal"), 1.5}, 16, 60.0);
  ASSERT_TRUE(run.finished());
  for (const double t : {0.0, 1e-3, 0.1, 0.7, 1.3, 1.99, 2.0}) EXPECT_NEAR(run.at(t)[0], t * t, 1e-14) << t;
}

}  // namespace
}  // namespace fde::bench
