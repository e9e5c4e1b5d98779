// SPDX-License-Identifier: MIT
#include "fdebench/reports/analysis/trial_result.hpp"

#include <gtest/gtest.h>

#include <set>

#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/benchmarks/sweep/trials.hpp"

namespace fde::bench {
namespace {

Record finished(double relative) {
  Record run;
  run.values.set("error_relative", relative);
  return run;
}

TEST(TrialResult, SurvivesWithinAHundredthOfTheValue) {
  EXPECT_EQ(trial_result(finished(0.01)), survives);
  EXPECT_EQ(trial_result(finished(0.011)), inaccurate);
}

TEST(TrialResult, IsThereForEveryEnd) {
  const auto of = [](const OutcomeKind& ending) { return trial_result({.ending = {ending}}); };
  EXPECT_EQ(of(SolveStatus::non_finite), fails);
  EXPECT_EQ(of(SolveStatus::refused), refuses);
  EXPECT_EQ(of(Verdict::no_reference), not_judged);
  EXPECT_EQ(of(Verdict::overflow), not_judged);
  EXPECT_EQ(of(Verdict::accuracy_lost), fails);
  EXPECT_EQ(of(SolveStatus::left_domain), stops);
  EXPECT_EQ(of(Verdict::false_singularity), fails);
  EXPECT_EQ(of(Verdict::passed_singularity), fails);
  EXPECT_EQ(of(SolveStatus::finished), not_judged) << "without an error";
}

TEST(RateScene, TakesItsEndAnywhere) {
  const auto variant = parse_variant("pendulum:until=5,beta=0.1");
  EXPECT_EQ(variant.until, 5.0);
  EXPECT_EQ(variant.label(), "pendulum:beta=0.1,until=5");
}

TEST(Trials, AreNamedOnce) {
  std::set<std::string> labels, kinds;
  std::string last;
  for (const Trial& trial : trials()) {
    EXPECT_TRUE(labels.insert(trial.scene.label()).second) << trial.scene.label();
    if (trial.kind != last) {
      EXPECT_TRUE(kinds.insert(trial.kind).second) << trial.kind;
    }
    last = trial.kind;
  }
}

}  // namespace
}  // namespace fde::bench
