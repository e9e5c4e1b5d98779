// SPDX-License-Identifier: MIT
// The stability regions on the page: the stored table against the curves computed now.

#include "fdebench/reports/regions/stability_curves.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "fdebench/reports/page/assets.hpp"

namespace fde::bench {
namespace {

using nlohmann::json;

TEST(PageRegions, AreThoseOfTheSchemes) {
  const auto kept = json::parse(assets::regions());
  const auto now = page_stability_curves({find_scheme("l1"), find_scheme("bdf4"), find_scheme("bdf5")});
  EXPECT_EQ(kept["orders"], now["orders"]);
  for (const auto& [id, curves] : now["curves"].items()) {
    EXPECT_TRUE(kept["curves"][id] == curves)
        << id << " differs: cmake --build --preset release --target page_regions";
  }
}

// A new scheme has no curves until the table is regenerated.
TEST(PageRegions, HaveEverySchemeWithASymbolOnce) {
  const auto kept = json::parse(assets::regions());
  for (const auto& [id, curves] : kept["curves"].items()) EXPECT_NE(find_scheme(id), nullptr) << id;
  for (const auto& [id, earlier] : kept["same"].items()) {
    EXPECT_FALSE(kept["curves"].contains(id));
    EXPECT_TRUE(kept["curves"].contains(earlier.get<std::string>())) << id;
  }
}

TEST(StabilityCurves, LeaveOutSchemesWithoutASymbolAndOrdersThatOneRefuses) {
  const auto found =
      stability_curves({find_scheme("spectral_collocation"), find_scheme("l2_1_sigma")}, {0.5}, 4);
  EXPECT_FALSE(found["curves"].contains("spectral_collocation"));
  EXPECT_EQ(found["curves"]["l2_1_sigma"][0][0].size(), 2U * 9U);
}

}  // namespace
}  // namespace fde::bench
