// SPDX-License-Identifier: MIT
#include "fdebench/reports/analysis/choice.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fdebench/benchmarks/requests/failure.hpp"
#include "fdebench/benchmarks/text/refusal.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

TEST(Choice, AnswersWithinTheErrorOverTheColumnsThatCount) {
  const auto made =
      choose(scene_of("linear_system"), {"linear_system"},
             {.error = 1e-3, .columns = {scene_of("linear_system").outputs.names.front()}, .seconds = 5.0});
  ASSERT_FALSE(made.options.empty());
  EXPECT_LE(made.options.front().error, 1e-3);
  EXPECT_EQ(made.columns.size(), 1U);
  EXPECT_EQ(made.kind.norm, Norm::maximum);
}

TEST(Choice, NamesTheFieldThatItRefuses) {
  const Scene scene = scene_of("relaxation");
  const auto refused = [&](const ChoiceRequest& request) -> std::string {
    try {
      choose(scene, {"relaxation"}, request);
    } catch (const Refusal& refusal) {
      const std::string text = refusal.what();
      return text.substr(0, text.find(':'));
    }
    return "";
  };
  EXPECT_EQ(refused({}), "error = 0");
  EXPECT_EQ(refused({.error = 1.0}), "error = 1");
  EXPECT_EQ(refused({.error = 0.1, .columns = {"z"}}), "columns = z");
  EXPECT_EQ(refused({.error = 0.1, .seconds = 0.0}), "seconds = 0");
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
