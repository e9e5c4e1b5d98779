// SPDX-License-Identifier: MIT
#include "fdebench/reports/analysis/families.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <tuple>
#include <vector>

#include "reports/synthetic_family.hpp"
#include "support/matchers.hpp"

namespace fde::bench {
namespace {

using testing::SizeIs;

TEST(Families, HaveTwentyScenesOrMoreThatDifferInNumbers) {
  for (const auto& [gammas, lambdas, is_family] : {std::tuple{5, 4, true}, {19, 1, false}, {20, 1, true}}) {
    Runs runs = runs_of(over_plane(gammas, lambdas));
    const Runs taken = take_families(runs);
    EXPECT_EQ(runs.finished.empty(), is_family) << gammas;
    EXPECT_THAT(families(taken, runs), SizeIs(is_family ? 1 : 0));
  }
}

TEST(Families, KeepWhatTheirScenesHaveInCommon) {
  Results results = over_plane(5, 4);
  for (Record& row : results.records) {
    row.key.scene.values["y0"] = 3.0;
    row.key.scene.values["form"] = std::string("new");
  }
  add_run(results, {"pendulum", "l1", 64}, 1e-3, 1.0);
  Runs runs = runs_of(results);
  const Runs taken = take_families(runs);
  EXPECT_THAT(runs.finished, SizeIs(1)) << "the pendulum";
  const auto found = families(taken, runs);
  ASSERT_THAT(found, SizeIs(1));
  EXPECT_THAT(found[0].parameters, ElementsAre("gamma", "lambda"));
  EXPECT_EQ(label_of(found[0].scene), "relaxation:form=new,y0=3");
  EXPECT_THAT(found[0].members, SizeIs(20));
}

// A scene of the family without a value of its own has the default, as the results describe it.
TEST(Families, TakeDefaultsFromTheDescription) {
  Results results = over_plane(20, 1);
  for (Record& row : results.records) {
    row.key.scene.values.erase("lambda");
    if (row.key.scene.values["gamma"] == ParameterValue(0.1)) row.key.scene.values.clear();
  }
  results.scenes = {
      {.scene = {"relaxation"}, .title = "Relaxation", .parameters = {{"gamma", "0.1", "order"}}}};
  Runs runs = runs_of(results);
  const Runs taken = take_families(runs);
  const auto found = families(taken, runs);
  ASSERT_THAT(found, SizeIs(1));
  ASSERT_THAT(found[0].members, SizeIs(20));
  EXPECT_THAT(found[0].members.front().values, ElementsAre(0.1));
}

// A lattice of four by five: what holds for the upper three values of the second parameter.
TEST(WhereMostly, FindsTheBoundOfAParameter) {
  Family family{.parameters = {"a", "b"}};
  std::vector<bool> holds;
  for (int a = 0; a < 4; ++a) {
    for (int b = 0; b < 5; ++b) {
      family.members.push_back({.values = {double(a), double(b)}});
      holds.push_back(b >= 2 && !(a == 0 && b == 4));
    }
  }
  const auto part = where_mostly(family, holds);
  ASSERT_TRUE(part);
  EXPECT_EQ(part->parameter, 1U);
  EXPECT_TRUE(part->from);
  EXPECT_EQ(part->bound, 2.0);
  EXPECT_DOUBLE_EQ(part->inside, 11.0 / 12.0);
  EXPECT_DOUBLE_EQ(part->outside, 0.0);
  holds.flip();
  const auto other = where_mostly(family, holds);
  ASSERT_TRUE(other);
  EXPECT_FALSE(other->from);
  EXPECT_EQ(other->bound, 1.0);
  // The greatest share is that of the last value alone, but most is in the upper half.
  Family line{.parameters = {"a"}};
  std::vector<bool> mostly;
  for (int a = 0; a < 20; ++a) {
    line.members.push_back({.values = {double(a)}});
    mostly.push_back(a > 10 && a % 2 == 1);
  }
  EXPECT_EQ(where_mostly(line, mostly)->bound, 11.0);
  EXPECT_FALSE(where_mostly(family, std::vector(20, true)));
  EXPECT_FALSE(where_mostly(family, std::vector(20, false)));
}

}  // namespace
}  // namespace fde::bench
