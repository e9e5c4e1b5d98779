// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>

#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/schemes/problem/progress/progress.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {
namespace {

// Cancels the work of this thread at its first report.
const ProgressCallback end_it = [](std::size_t, std::size_t) { throw Cancelled(); };

TEST(Work, OfEverySchemeIsReportedAndCancelledWhereAListenerThrows) {
  const Scene at_one_end = make_scene(read_variant("relaxation", {})),
              at_both = make_scene(read_variant("fractional_extremum", {}));
  for (const Scheme& scheme : schemes()) {
    for (const Scene* scene : {&at_one_end, &at_both}) {
      const Grid grid{.end = scene->problem.end, .steps = 64};
      if (unsupported_reason(scheme, scene->problem, grid)) continue;
      const ProgressScope scope(end_it);
      EXPECT_THROW(scheme.solve(scene->problem, grid, {}), Cancelled) << scheme.id << ' ' << scene->name;
    }
  }
}

TEST(Work, IsReportedToAllListeners) {
  std::size_t outer = 0, inner = 0;
  const ProgressScope first([&](std::size_t done, std::size_t) { outer += done; });
  {
    const ProgressScope second([&](std::size_t done, std::size_t) { inner += done; });
    report_progress(1);
  }
  report_progress(2);
  EXPECT_EQ(outer, 3U);
  EXPECT_EQ(inner, 1U);
}

}  // namespace
}  // namespace fde::bench
