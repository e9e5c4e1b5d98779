// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "fdebench/reports/page/page_data.hpp"
#include "reports/page/page_section.hpp"
#include "reports/synthetic_family.hpp"

namespace fde::bench {
namespace {

using testing::SizeIs;

TEST(FamilySection, HasTheCheapestRunOfEachSceneAndHowRobustItIs) {
  const auto data = page_data(read_runs(over_plane(10, 10)));
  const auto family = section(data, "family-relaxation");
  ASSERT_FALSE(family.is_null());
  for (const auto& one : data["sections"]) EXPECT_FALSE(one["id"].get<std::string>().starts_with("scene-"));
  const auto& plane = family["plane"];
  EXPECT_EQ(plane["parameters"], (std::vector<std::string>{"gamma", "lambda"}));
  EXPECT_THAT(plane["names"], SizeIs(100));
  const auto& cells = plane["cells"]["error_maximum_mixed"];
  const auto robustness = plane["robustness"]["error_maximum_mixed"];
  for (std::size_t member = 0; member < 100; ++member) {
    const bool is_slow = plane["values"][1][member] < -10.0;
    const auto line = [&](std::size_t accuracy) {
      return plane["lines"][cells[accuracy]["line"][member].get<int>()];
    };
    EXPECT_EQ(line(0), is_slow ? "l1" : "adams_pc") << "to 1e-2";
    EXPECT_EQ(cells[0]["ratio"][member], is_slow ? 4.0 : 2.0);
    EXPECT_EQ(line(1), "adams_pc") << "to 1e-4";
  }
  EXPECT_TRUE(cells[2].empty()) << "no scheme is within 1e-6";
  EXPECT_EQ(plane["typical"]["error_maximum_mixed"], 1e-4);
  const auto& best = robustness[0]["best"];
  EXPECT_EQ(best["line"], "l1");
  EXPECT_EQ(best["regret"]["value"], 2);
  const auto& rows = robustness[0]["rows"];
  EXPECT_EQ(rows[0]["won"], 80);
  EXPECT_EQ(rows[0]["near"]["value"], 0.8);
  EXPECT_EQ(rows[0]["where"],
            (nlohmann::json{{"parameter", "lambda"}, {"bound", -100}, {"inside", 1}, {"outside", 0}}));
  EXPECT_EQ(rows[1]["tail"]["value"], 4);
  EXPECT_EQ(robustness[2]["unsolved"], 100);
}

TEST(FamilySection, CountsItsTimesAmongTheDisturbedOnesOfASession) {
  auto results = over_plane(10, 10);
  auto& times = results.records.back().timing.values;
  times.set("time_median", 1.0);
  times.set("disturbed", 1.0);
  EXPECT_EQ(page_data(read_runs(results))["sessions"][0]["disturbed times"], "1 of 1");
}

}  // namespace
}  // namespace fde::bench
