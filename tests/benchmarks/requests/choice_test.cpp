// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/requests/choice.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "fdebench/benchmarks/requests/answers_json.hpp"
#include "fdebench/benchmarks/requests/failure.hpp"
#include "fdebench/benchmarks/requests/own_scheme.hpp"
#include "fdebench/benchmarks/text/refusal.hpp"
#include "support/refusal_of.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

TEST(Choice, AnswersWithinTheErrorOverTheColumnsThatCount) {
  const auto made =
      choose(scene_of("linear_system"),
             {.error = 1e-3, .columns = {scene_of("linear_system").outputs.names.front()}, .seconds = 5.0},
             {"linear_system"});
  ASSERT_FALSE(made.options.empty());
  EXPECT_LE(made.options.front().error, 1e-3);
  EXPECT_EQ(made.columns.size(), 1U);
  EXPECT_EQ(made.kind.norm, Norm::maximum);
}

// E_{1/2}(-t^{1/2}) = e^t erfc(t^{1/2}), which solves the relaxation.
Rows closed_form(const Problem& /*problem*/, const std::vector<double>& times) {
  Rows y(1, std::ssize(times));
  for (Eigen::Index c = 0; const double t : times) y(0, c++) = std::exp(t) * std::erfc(std::sqrt(t));
  return y;
}

ChoiceRequest with_schemes(double error, const std::vector<const Scheme*>& own) {
  return {.error = error, .seconds = 10.0, .schemes = own};
}

TEST(Choice, TriesASchemeOfTheCallerBesideOurs) {
  const OwnScheme mine("mine", closed_form);
  const auto made = choose(scene_of("relaxation"), with_schemes(1e-10, {&mine.scheme()}), {"relaxation"});
  ASSERT_FALSE(made.options.empty());
  EXPECT_EQ(made.options.front().schemes.front(), "mine");
  EXPECT_LE(made.options.front().error, 1e-13);
  EXPECT_TRUE(json_of(made)["command"].is_null());
  EXPECT_NE(runner_up(made), nullptr);
}

// y(1) = e erfc(1) within the error that is asked for.
TEST(Choice, TakesMeasuresOfTheCallerOfTheRunsWithinTheError) {
  ChoiceRequest request = with_schemes(1e-6, {});
  request.measures = {{"last", [](const auto&, const Rows& values, const Rows&) -> std::optional<double> {
                         return values(0, values.cols() - 1);
                       }}};
  const auto made = choose(scene_of("relaxation"), request, {"relaxation"});
  for (const auto& option : made.options) {
    ASSERT_TRUE(option.measured["last"]) << option.schemes.front();
    EXPECT_NEAR(*option.measured["last"], std::exp(1.0) * std::erfc(1.0), 2e-6) << option.schemes.front();
  }
  EXPECT_EQ(json_of(made)["measures"]["last"], *made.options.front().measured["last"]);
  EXPECT_THAT(to_text(made), testing::HasSubstr("; last 0.428"));
}

TEST(Choice, SaysWhyASchemeOfTheCallerHasNoRun) {
  const OwnScheme wrong("wrong", [](const Problem& problem, const std::vector<double>& times) -> Rows {
    return Rows::Constant(problem.size(), std::ssize(times), std::nan(""));
  });
  const auto made = choose(scene_of("relaxation"), with_schemes(1e-3, {&wrong.scheme()}), {"relaxation"});
  const auto rejected = std::ranges::find_if(
      made.rejected, [](const RejectedScheme& one) { return one.finest.schemes.front() == "wrong"; });
  ASSERT_NE(rejected, made.rejected.end());
  EXPECT_THAT(rejected->reason, testing::HasSubstr("not finite"));
}

TEST(Choice, RefusesSchemesWhoseIdsAreTaken) {
  const OwnScheme ours("l1", closed_form), mine("mine", closed_form);
  const Scene scene = scene_of("relaxation");
  EXPECT_THROW(choose(scene, with_schemes(1e-3, {&ours.scheme()})), Refusal);
  EXPECT_THROW(choose(scene, with_schemes(1e-3, {&mine.scheme(), &mine.scheme()})), Refusal);
}

TEST(Choice, NamesTheFieldThatItRefuses) {
  const Scene scene = scene_of("relaxation");
  const auto refused = [&](const ChoiceRequest& request) {
    const auto text = refusal_of([&] { choose(scene, request); });
    return text.substr(0, text.find(':'));
  };
  EXPECT_EQ(refused({}), "<error> = 0");
  EXPECT_EQ(refused({.error = 1.0}), "<error> = 1");
  EXPECT_EQ(refused({.error = 0.1, .columns = {"z"}}), "<columns> = z");
  EXPECT_EQ(refused({.error = 0.1, .seconds = 0.0}), "<seconds> = 0");
  EXPECT_THROW(parse_first_run("2"), Refusal);
}

TEST(Choice, IsAFailureThatSaysWhatIsMissing) {
  const Recommendation none{.scene = {"pendulum"},
                            .kind = {Norm::end, Scale::absolute},
                            .accuracy = 1e-6,
                            .columns = {"phi"},
                            .missing = {"the best is 1e-3"}};
  try {
    require_option(none);
    ADD_FAILURE() << "no failure";
  } catch (const NumericalFailure& failure) {
    EXPECT_STREQ(
        failure.what(),
        "no run of pendulum is within 1.0e-6 (at the end, absolute scale, in phi): the best is 1e-3");
  }
  Recommendation some = none;
  some.options.emplace_back();
  EXPECT_NO_THROW(require_option(some));
}

}  // namespace
}  // namespace fde::bench
