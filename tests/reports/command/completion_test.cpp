// SPDX-License-Identifier: MIT
// What shells offer is what the commands accept.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "support/command_line_result.hpp"
#include "support/temporary_folder.hpp"

namespace fde::bench {
namespace {

// The words that a shell offers for the last word.
std::vector<std::string> offered(std::vector<std::string> words) {
  words.insert(words.begin(), "__complete");
  std::vector<std::string> found;
  std::istringstream lines(fdebench(words).out);
  for (std::string line; std::getline(lines, line);) found.push_back(line.substr(0, line.find('\t')));
  return found;
}

TEST(Completions, AreThoseOfTheTables) {
  using testing::Contains;
  EXPECT_THAT(offered({""}), AllOf(Contains("solve"), Contains("--quiet")));
  EXPECT_THAT(offered({"sc"}), ElementsAre("scenes", "schemes"));
  EXPECT_THAT(offered({"-q", "ch"}), ElementsAre("choose"));
  EXPECT_THAT(offered({"solve", "pend"}), ElementsAre("pendulum", ""));
  EXPECT_THAT(offered({"solve", "pendulum", "--sch"}), ElementsAre("--scheme"));
  EXPECT_THAT(offered({"solve", "pendulum", "--scheme", "bdf"}), Contains("bdf5"));
  EXPECT_THAT(offered({"choose", "pendulum", "--norm", ""}), ElementsAre("end", "maximum"));
  EXPECT_THAT(offered({"choose", "pendulum", "--norm=m"}), ElementsAre("--norm=maximum"));
  EXPECT_THAT(offered({"solve", "pendulum", "--set", "al"}), ElementsAre("alpha="));
  EXPECT_THAT(offered({"solve", "pendulum:alpha=1.9,be"}), ElementsAre("pendulum:alpha=1.9,beta="));
  EXPECT_THAT(offered({"solve", "pendulum", "--grid", "graded"}), ElementsAre("graded:", "graded:auto"));
  EXPECT_THAT(offered({"plot", "pendulum", "--kind", "s"}), ElementsAre("solution", "stability"));
  EXPECT_THAT(offered({"help", "acc"}), ElementsAre("accuracy"));
  EXPECT_THAT(offered({"completion", ""}), ElementsAre("bash", "zsh", "fish"));
  EXPECT_EQ(fdebench(std::vector<std::string>{"__complete", "report", ""}).out, "\t.jsonl\n");
  EXPECT_THAT(offered({"nothing", ""}), ElementsAre());
}

TEST(Completions, HaveTheScenesOfTheUsersFolder) {
  const TemporaryFolder folder;
  folder.write("mine.toml",
               "end = 1.0\n[parameters]\nstiffness = 2.0\n[unknown.x]\norder = 0.5\n"
               "rhs = \"-stiffness*x\"\ninitial = [1.0]\n");
  setenv("FDEBENCH_SCENES", folder.path().c_str(), 1);
  EXPECT_THAT(offered({"solve", "mi"}), ElementsAre("mine", ""));
  EXPECT_THAT(offered({"solve", "mine", "--set", "st"}), ElementsAre("stiffness="));
  unsetenv("FDEBENCH_SCENES");
}

TEST(CompletionScripts, NameTheProgram) {
  for (const std::string shell : {"bash", "zsh", "fish"}) {
    const auto script = fdebench("completion " + shell).out;
    EXPECT_THAT(script, AllOf(HasSubstr("fdebench"), Not(HasSubstr("NAME")), HasSubstr("__complete")));
  }
}

}  // namespace
}  // namespace fde::bench
