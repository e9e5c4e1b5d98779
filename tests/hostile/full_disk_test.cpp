// SPDX-License-Identifier: MIT
// Full disks: one line naming the path, no partial files, and existing files are kept.

#include "support/full_disk.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include "fdebench/benchmarks/reference_data/reference_folder.hpp"
#include "fdebench/benchmarks/references/cache.hpp"
#include "fdebench/benchmarks/sweep/measured_run.hpp"
#include "hostile/unwritable_testing.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

using FullDisks = Unwritable;

TEST_F(FullDisks, HoldNoResults) {
  const FullDisk full(100);
  EXPECT_THAT(run_into(file_),
              fails_with(2, "fdebench: " + file_.string() + ": cannot be written: File too large\n"));
  EXPECT_EQ(fs::file_size(file_), 0U);
}

TEST_F(FullDisks, LeaveTheOldReport) {
  ASSERT_EQ(run_into(file_).code, 0);
  folder_.write("report/index.html", "old");
  const FullDisk full(1000);
  EXPECT_THAT(fdebench({"report", file_.string(), "--out", folder_.file("report")}),
              fails_with(2, testing::MatchesRegex(
                                "fdebench: .*/report/index.html.*: cannot be written: File too large\n")));
  EXPECT_THAT(names(), ElementsAre("report", "report/index.html", "results.jsonl"));
  EXPECT_EQ(fs::file_size(folder_.path() / "report" / "index.html"), 3U);
}

TEST_F(FullDisks, LeaveTheOldReferenceTables) {
  folder_.write("data/a.csv", "old");
  const FullDisk full(1000);
  const fs::path data = folder_.path() / "data";
  EXPECT_THAT(
      [&] {
        replace_folder(data, {{"a.csv", std::string(5000, '1')}});
      },
      testing::ThrowsMessage<std::invalid_argument>(data.string() + ": cannot be written: File too large"));
  EXPECT_THAT(names(), ElementsAre("data", "data/a.csv"));
}

// A reference does not depend on whether it can be cached.
TEST_F(FullDisks, AreNoHarmToWhatACacheFinds) {
  const Scene scene = scene_of("brusselator");
  Problem problem = scene.problem;
  problem.end = 1.0;
  const auto known = cached_reference("r", problem, ReferenceCache(std::nullopt)).at(1.0);
  const FullDisk full(100);
  const auto found = cached_reference("r", problem, ReferenceCache(folder_.path() / "cache")).at(1.0);
  EXPECT_EQ(found.value, known.value);
  EXPECT_THAT(names(), ElementsAre("cache"));
}

TEST_F(FullDisks, MayBeTheStandardOutput) {
  std::ofstream full("/dev/full");
  if (!full) GTEST_SKIP() << "there is no /dev/full";
  for (const auto& words :
       std::vector<std::vector<std::string>>{{"--help"},
                                             {"scenes"},
                                             {"schemes", "--json"},
                                             {"exact", "power", "--at", "1"},
                                             {"mittag-leffler", "1", "1", "1"},
                                             {"solve", "power", "--scheme", "l1", "--steps", "8"}}) {
    full.clear();
    std::ostringstream err;
    EXPECT_EQ(run_fdebench(words, {.out = full, .err = err}), 2) << words[0];
    EXPECT_EQ(err.str(), "fdebench: standard output: cannot be written\n") << words[0];
  }
}

}  // namespace
}  // namespace fde::bench
