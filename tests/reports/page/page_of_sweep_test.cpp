// SPDX-License-Identifier: MIT
// The accuracies of the page's cells are the targets of the default sweep.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "fdebench/benchmarks/records/default_accuracies.hpp"
#include "fdebench/benchmarks/search/accuracy_target.hpp"
#include "fdebench/reports/analysis/runs.hpp"
#include "fdebench/reports/page/page_data.hpp"
#include "reports/page/page_section.hpp"
#include "support/command_line_result.hpp"

namespace fde::bench {
namespace {

// A cell has a run, or the best run and why that is no better.
bool is_answered(const nlohmann::json& cell) {
  const auto has = [&](const char* fact) { return cell.contains(fact); };
  constexpr std::array reasons{"is_no_better", "is_rounding", "known_up_to", "needed"};
  return has("line") || (has("best") && std::ranges::any_of(reasons, has));
}

TEST(PageOfADefaultSweep, AnswersEveryCell) {
  const auto file = std::filesystem::path(testing::TempDir()) / "default_sweep.jsonl";
  std::filesystem::remove(file);
  const auto run = fdebench(
      "run --scene power --scene diethelm --scheme l1 --scheme spectral_collocation --out " + file.string());
  ASSERT_EQ(run.code, 0) << run.err;
  const auto page = page_data(read_runs(file));
  for (const auto* scene : {"scene-power", "scene-diethelm"}) {
    for (const auto* kind : {"error_end_mixed", "error_maximum_mixed"}) {
      const auto cells = section(page, scene)["answers"][kind];
      EXPECT_EQ(cells.size(), default_accuracies.size());
      for (const auto& cell : cells) EXPECT_TRUE(is_answered(cell)) << scene << ' ' << kind << ' ' << cell;
    }
  }
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace fde::bench
