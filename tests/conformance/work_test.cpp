#include "progress/work.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>

#include "scenes/variant.hpp"
#include "stepping/scheme.hpp"

namespace fde {
namespace {

// Cancels the work of this thread at its first report.
const WorkListener end_it = [](std::size_t, std::size_t) { throw WorkEnded(); };

TEST(Work, OfEverySchemeIsHeardOfAndEndsWhereAListenerThrows) {
  const Scene at_one_end = make_scene(read_variant("relaxation", {})),
              at_both = make_scene(read_variant("fractional_extremum", {}));
  for (const Scheme& scheme : schemes()) {
    for (const Scene* scene : {&at_one_end, &at_both}) {
      const Grid grid{.end = scene->problem.end, .steps = 64};
      if (refusal(scheme, scene->problem, grid)) continue;
      const ListeningToWork listening(end_it);
      EXPECT_THROW(scheme.solve(scene->problem, grid, {}), WorkEnded) << scheme.id << ' ' << scene->name;
    }
  }
}

TEST(Work, IsHeardOfByAllWhoListen) {
  std::size_t outer = 0, inner = 0;
  const ListeningToWork first([&](std::size_t done, std::size_t) { outer += done; });
  {
    const ListeningToWork second([&](std::size_t done, std::size_t) { inner += done; });
    report_work(1);
  }
  report_work(2);
  EXPECT_EQ(outer, 3U);
  EXPECT_EQ(inner, 1U);
}

}  // namespace
}  // namespace fde
