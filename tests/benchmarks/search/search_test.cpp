// SPDX-License-Identifier: MIT
// The results of search() are compared with independent runs.

#include "fdebench/benchmarks/search/search.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "benchmarks/search/search_case.hpp"
#include "fdebench/benchmarks/observers/comparison_steps.hpp"
#include "fdebench/benchmarks/references/memoized_reference.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/benchmarks/search/configurations.hpp"
#include "fdebench/benchmarks/search/error_model.hpp"
#include "fdebench/benchmarks/search/run_evaluator.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

std::vector<SearchCandidate> found_for(const Scene& scene, const SearchCase& asked) {
  return search(scene, target_of(scene, asked), 100.0, [](const std::string&, double) {});
}

class SearchFor : public testing::TestWithParam<SearchCase> {};

// The best run is within the accuracy at all its steps, and no run with clearly fewer steps on the same grids
// is. At a fixed time an error may be small by chance, and may grow with the steps before it decreases.
void expect_the_fewest_steps(const SearchCase& asked) {
  const Scene scene = make_scene(parse_variant(asked.scene));
  const auto found = found_for(scene, asked);
  const SearchCandidate& first = found.front();
  ASSERT_EQ(first.outcome, SearchOutcome::accuracy_reached);
  RunEvaluator evaluator(scene, target_of(scene, asked));
  const int compared = first.configuration.is_adaptive() ? evenly_spaced_comparisons : first.best.steps;
  const auto again = evaluator.evaluate(first.configuration, first.best.resolution, compared, 60.0);
  EXPECT_TRUE(evaluator.is_accurate(again));
  EXPECT_EQ(again.error(), first.best.error());
  if (first.configuration.is_adaptive()) return;
  constexpr double closest = 1.15;  // of runs that take long 10 % more steps than the fewest are enough
  for (double steps = first.best.steps / closest; steps >= 4.0; steps /= 1.1) {
    const auto fewer = evaluator.evaluate(first.configuration, static_cast<int>(steps), 8192, 60.0);
    EXPECT_FALSE(evaluator.is_accurate(fewer)) << fewer.steps << " of " << first.best.steps;
  }
}

TEST_P(SearchFor, FindsARunWithinTheAccuracy) { expect_the_fewest_steps(GetParam()); }

// Multistep rules are the quickest here.
TEST(SearchOverGrids, FindsTheFewestSteps) {
  expect_the_fewest_steps({"pendulum", {Norm::maximum, Scale::mixed}, 1e-3});
  expect_the_fewest_steps({"damped_oscillator", {Norm::end, Scale::mixed}, 1e-4});
}

// The first grids of a search have steps longer than the delay, which no scheme takes.
TEST(SearchOverGrids, RefinesUntilSchemesTakeTheDelay) {
  const SearchCase asked{"delayed_logistic", {Norm::maximum, Scale::mixed}, 1e-2};
  const Scene scene = make_scene(parse_variant(asked.scene));
  for (const SearchCandidate& of : found_for(scene, asked)) {
    const bool takes_delays = !of.configuration.scheme->capabilities.discretises_equations;
    EXPECT_EQ(of.outcome == SearchOutcome::refused, !takes_delays) << of.names.front();
  }
  expect_the_fewest_steps(asked);
}

double median(std::vector<double> of) {
  std::ranges::nth_element(of, of.begin() + std::ssize(of) / 2);
  return of[of.size() / 2];
}

// The error model of five runs predicts the error of a run between the last two. A single error may be small
// by chance, so the median over all schemes is compared.
TEST_P(SearchFor, KnowsErrorsBetweenTheRunsItHasMade) {
  const Scene scene = make_scene(parse_variant(GetParam().scene));
  RunEvaluator evaluator(scene, target_of(scene, GetParam()));
  std::vector<double> ratios;
  for (const Scheme& scheme : schemes()) {
    if (unsupported_reason(scheme, scene.problem, Grid{scene.problem.end, 16})) continue;
    const auto error = [&](int steps) {
      return evaluator.evaluate({&scheme}, steps, 8192, 60.0).error().value;
    };
    std::vector<TrialError> known;
    for (const int steps : {16, 32, 64, 128, 256}) known.push_back({steps, error(steps)});
    if (std::ranges::any_of(known, [](const TrialError& of) { return !std::isfinite(of.error); })) continue;
    if (const ErrorModel model(known); !model.empty()) ratios.push_back(model.error(181).value / error(181));
  }
  ASSERT_GE(ratios.size(), 8U);
  EXPECT_NEAR(median(ratios), 1.0, 0.1) << testing::PrintToString(ratios);
}

// The errors of the best runs are predicted by the runs with fewer steps. Which schemes come within the
// accuracy before another is much quicker depends on their times, so the median is compared here, too.
TEST(SearchOverGrids, PredictsTheErrorsThatItFinds) {
  const SearchCase asked{"distributed_relaxation", {Norm::maximum, Scale::mixed}, 1e-4};
  std::vector<double> ratios;
  for (const auto& configuration : found_for(make_scene(parse_variant(asked.scene)), asked)) {
    if (configuration.outcome == SearchOutcome::accuracy_reached && configuration.predicted)
      ratios.push_back(configuration.predicted->value / configuration.best.error().value);
  }
  ASSERT_FALSE(ratios.empty());
  EXPECT_NEAR(median(ratios), 1.0, 0.2) << testing::PrintToString(ratios);
}

// Each scheme that is called slower has a run outside the accuracy that takes longer than the best one.
TEST(SearchOverGrids, CallsNoSchemeSlowerWithoutARunThatShowsIt) {
  const auto found = found_for(scene_of("relaxation"), {"", {Norm::maximum, Scale::mixed}, 1e-6});
  int slower = 0;
  for (const SearchCandidate& of : found) {
    if (of.outcome != SearchOutcome::slower) continue;
    ++slower;
    const RefinementRun& finest = *of.refinement.finest();
    EXPECT_GT(*finest.seconds, *found.front().best.seconds) << of.names.front();
    EXPECT_FALSE(is_within(finest, {.error = 1e-6})) << of.names.front();
  }
  EXPECT_GT(slower, 10);
}

// bdf6 takes about 20 microseconds, and its start weights 100 more in the first run of a process.
TEST(Search, RanksByTheFirstRunWhereThatIsAsked) {
  const Scene scene = scene_of("relaxation");
  auto target = target_of(scene, {"", {Norm::end, Scale::mixed}, 1e-12});
  const auto found = [&] {
    auto all = search(scene, target, 100.0, [](const std::string&, double) {});
    std::erase_if(all, [](const auto& of) { return of.outcome != SearchOutcome::accuracy_reached; });
    return all;
  };
  const auto bdf6 = [](const std::vector<SearchCandidate>& all) {
    return std::ranges::find(all, std::vector<std::string>{"bdf6"}, &SearchCandidate::names);
  };
  const auto median = [](const SearchCandidate& of) { return of.time ? of.time->median : *of.best.seconds; };
  const auto later = found();
  ASSERT_NE(bdf6(later), later.end());
  EXPECT_GT(bdf6(later)->best.setup_seconds, 2.0 * *bdf6(later)->best.seconds);
  target.first_run = true;
  const auto first = found();
  ASSERT_FALSE(first.empty());
  for (const auto& of : first) EXPECT_GT(median(of), of.best.setup_seconds) << of.names.front();
  const auto again = bdf6(first);  // may have been left, for others are quicker
  EXPECT_LE(median(first.front()), again != first.end() ? median(*again) : 1.0);
}

INSTANTIATE_TEST_SUITE_P(SceneRegistry, SearchFor,
                         testing::Values(SearchCase{"relaxation", {Norm::maximum, Scale::mixed}, 1e-6},
                                         SearchCase{
                                             "relaxation:gamma=1.5", {Norm::end, Scale::relative}, 1e-9},
                                         SearchCase{"power:p=0.83", {Norm::maximum, Scale::absolute}, 1e-3},
                                         SearchCase{"diethelm", {Norm::end, Scale::mixed}, 1e-4},
                                         SearchCase{"linear_system", {Norm::maximum, Scale::mixed}, 1e-3}));

// Schemes with adaptive step size are tried too, where they are the cheapest, here by four times.
TEST(Search, TriesSchemesThatChooseTheirSteps) {
  const auto found = found_for(scene_of("bagley_torvik"), {"", {Norm::maximum, Scale::mixed}, 1e-8});
  const auto configuration = std::ranges::find(
      found, "spectral_collocation", [](const SearchCandidate& of) { return of.configuration.scheme->id; });
  ASSERT_EQ(configuration->outcome, SearchOutcome::accuracy_reached);
  EXPECT_LE(configuration->best.error().value, 1e-8);
  EXPECT_TRUE(std::holds_alternative<Tolerance>(configuration->best.resolution));
}

// E_{1/2}(-t^{1/2}) falls within the first steps of an interval of length 1e40, far below the times at which
// tolerances are compared: the error at the run's own steps counts.
TEST(Search, ComparesAdaptiveRunsAtTheirOwnSteps) {
  Scene scene = scene_of("relaxation");
  set_end(scene, 1e40);
  const SearchCase asked{"", {Norm::maximum, Scale::mixed}, 1e-6};
  const SearchCandidate first = found_for(scene, asked).front();
  ASSERT_EQ(first.outcome, SearchOutcome::accuracy_reached);
  ASSERT_TRUE(first.configuration.is_adaptive());
  const auto path = first.configuration.scheme->solve(
      scene.problem, resolution_of(RunSettings{.resolution = first.best.resolution}, 1e40), {});
  for (std::size_t n = 0; n < path.times.size(); ++n) {
    const double exact = scene.reference.at(path.times[n]).value[0];
    EXPECT_LE(std::abs(path.y(0, static_cast<Eigen::Index>(n)) - exact) / (1.0 + exact), asked.accuracy);
  }
}

// Start weights for a new order take some 100 microseconds to compute, four steps a tenth of that: the cost
// of the first solve must not exclude the scheme.
TEST(Search, ComparesRunsByWhatTheyCostOnceStartWeightsAreMade) {
  const Scene scene = scene_of("relaxation", {{"gamma", 0.4321}});
  const auto found = found_for(scene, {"", {Norm::end, Scale::mixed}, 1e-10});
  const auto rule =
      std::ranges::find(found, "bdf5", [](const SearchCandidate& of) { return of.configuration.scheme->id; });
  EXPECT_GT(rule->refinement.runs.front().setup_seconds, 2.0 * *rule->refinement.runs.front().seconds);
  EXPECT_GT(rule->refinement.runs.size(), 1U);
}

// For a constant solution every scheme is exact, and the baseline y = y(0) does not apply.
TEST(Search, TakesAConstantSolutionForOne) {
  const auto found =
      found_for(scene_of("relaxation", {{"y0", 0.0}}), {"", {Norm::maximum, Scale::mixed}, 1e-4});
  EXPECT_EQ(found.front().outcome, SearchOutcome::accuracy_reached);
  EXPECT_EQ(found.front().best.error().value, 0.0);
  EXPECT_TRUE(std::isinf(found.front().best.error().baseline));
  const auto moving = found_for(scene_of("relaxation"), {"", {Norm::maximum, Scale::mixed}, 1e-4});
  EXPECT_TRUE(std::isfinite(moving.front().best.error().baseline));
}

// E_{1/2}(-1e6 t^{1/2}) decreases from 1 to 1e-6 within a millionth of the interval: a comparison at t = 0
// and 1 misses this.
TEST(Search, SeesMotionBetweenTheTimesOfAGrid) {
  const Scene scene = scene_of("relaxation", {{"lambda", -1e6}});
  for (const auto& [norm, within] : {std::pair{Norm::end, true}, {Norm::maximum, false}}) {
    RunEvaluator evaluator(scene, target_of(scene, {"", {norm, Scale::mixed}, 1e-3}));
    for (const int steps : {1, 64}) {
      const auto run = evaluator.evaluate({find_scheme("l1")}, steps, 8192, 60.0);
      EXPECT_EQ(evaluator.is_accurate(run), within) << steps;
    }
  }
}

TEST(Search, GivesOneAlgorithmAllItsNames) {
  const Scene scene = scene_of("relaxation");
  const auto found = found_for(scene, {"", {Norm::end, Scale::mixed}, 1e-2});
  const auto adams = std::ranges::find_if(found, [](const SearchCandidate& of) {
    return of.configuration.scheme->id == "adams_pc" && of.configuration.grading == 1.0;
  });
  EXPECT_THAT(adams->names, ElementsAre("adams_pc", "decoupled_multi_order", "commensurate_adams_pc"));
}

// y decays to 5.6e-7 immediately: the baseline y = 0 has this absolute error, and a run must have a smaller
// one.
TEST(Search, CreditsNoRunThatIsNoBetterThanZero) {
  const Scene scene = scene_of("stiff_relaxation");
  const auto found = found_for(scene, {"", {Norm::end, Scale::absolute}, 1e-3});
  ASSERT_EQ(found.front().outcome, SearchOutcome::accuracy_reached);
  EXPECT_LT(found.front().best.error().value, found.front().best.error().baseline);
  EXPECT_LT(found.front().best.error().baseline, 1e-6);
}

// No error can be verified below the bound of the reference, and none within an accuracy that leaves less
// than a tenth of it to the run.
TEST(Search, RefusesAnAccuracyThatTheReferenceDoesNotHave) {
  Scene scene = scene_of("relaxation");
  scene.reference = {[](double) { return reference::ReferenceValue{Vec::Ones(1), Vec::Constant(1, 1e-5)}; }};
  for (const double accuracy : {1e-6, 1.1e-5}) {
    expect_message(
        [&] {
          found_for(scene, {"", {Norm::end, Scale::absolute}, accuracy});
        },
        fmt::format("the reference is known up to 1.0e-05 only, which is no less than 0.9 times {:.1e}",
                    accuracy));
  }
}

// At the end time, and for the maximum at every time: there the reference is exact at the end.
TEST(Search, CountsWhatIsNotKnownOfTheReferenceAsError) {
  for (const Norm norm : {Norm::end, Norm::maximum}) {
    const double accuracy = norm == Norm::end ? 1e-4 : 0.1;
    const auto within = [&](double bound) {
      Scene scene = scene_of("relaxation");
      const reference::Reference exact = scene.reference;
      const double end = scene.problem.end;
      scene.reference = {[=](double t) {
        const bool is_known = norm == Norm::maximum && std::abs(t - 0.5 * end) > 0.1 * end;
        return reference::ReferenceValue{exact.at(t).value, Vec::Constant(1, is_known ? 0.0 : bound)};
      }};
      RunEvaluator evaluator(scene, {{norm, Scale::absolute}, accuracy, all_columns(scene)});
      EXPECT_EQ(evaluator.reference_bound(), bound);
      const auto run = evaluator.evaluate({find_scheme("adams_pc"), 1.0}, 64, 64, 10.0);
      return std::pair(evaluator.is_accurate(run), run.error().value);
    };
    const auto [is_accurate, error] = within(0.0);
    EXPECT_TRUE(is_accurate) << error;
    EXPECT_FALSE(within(1.01 * (accuracy - error)).first);
    EXPECT_TRUE(within(0.99 * (accuracy - error)).first);
  }
}

// D^g y ~ t^g near 0, and the error of the trapezoidal rule on a uniform grid is h^(2g) at the first step and
// h^(1+g) at the end: with the gradings 1/g and 2/(1+g) the rate is 2.
TEST(Gradings, AreUsualOnesAndTheLeastWithTheBestRate) {
  const Scene scene = scene_of("relaxation", {{"gamma", 0.2}});
  const Scheme &rule = *find_scheme("product_trapezoidal"), &uniform = *find_scheme("grunwald_letnikov");
  EXPECT_THAT(gradings_of(rule, scene, Norm::maximum), ElementsAre(1.0, 1.5, 2.0, 3.0, 5.0));
  EXPECT_THAT(gradings_of(rule, scene, Norm::end), ElementsAre(1.0, 1.5, 2.0, 3.0, 1.75));
  EXPECT_THAT(gradings_of(uniform, scene, Norm::maximum), ElementsAre(1.0));
}

}  // namespace
}  // namespace fde::bench
