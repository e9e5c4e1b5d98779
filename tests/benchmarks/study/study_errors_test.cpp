// SPDX-License-Identifier: MIT
// Invalid study files: one line with file, line and column, before anything runs.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "support/command_output.hpp"
#include "support/temporary_folder.hpp"

namespace fde::bench {
namespace {

struct InvalidStudy {
  std::string text;
  int line, column;
  std::string what;
};

class WrongStudy : public testing::TestWithParam<InvalidStudy> {};

TEST_P(WrongStudy, IsRefusedInOneLine) {
  const auto& [text, line, column, what] = GetParam();
  const TemporaryFolder folder;
  folder.write("s.toml", text);
  const std::string file = folder.file("s.toml"), out = folder.file("out");
  for (const auto& command : {std::vector<std::string>{"run", "--study", file, "--out", out},
                              std::vector<std::string>{"study", "plan", file, "--out", out}}) {
    EXPECT_THAT(
        fdebench(command),
        is_refused(2, AllOf(StartsWith(fmt::format("fdebench: {}: line {}, column {}: ", file, line, column)),
                            HasSubstr(what))));
    EXPECT_FALSE(std::filesystem::exists(out));
  }
}

std::string family(const std::string& lines) { return "[[family]]\nscene = \"relaxation\"\n" + lines + "\n"; }
std::string gamma_is(const std::string& value) { return family("parameters.gamma = " + value); }

INSTANTIATE_TEST_SUITE_P(
    Files, WrongStudy,
    testing::ValuesIn<InvalidStudy>(
        {{"", 1, 1, "a study: has no family, which it must have"},
         {"family = []\n", 1, 10, "is an empty list"},
         {"[family]\nscene = \"power\"\n", 1, 1, "must be tables [[family]]"},
         {"steps = 4\n[[family]\n", 2, 10, "no TOML"},
         {"stepps = 4\n" + family(""), 1, 1, "did you mean 'steps'?"},
         {"[[family]]\nsteps = 4\n", 1, 1, "a family: has no scene"},
         {"[[family]]\nscene = \"relaxatoin\"\n", 2, 9, "did you mean 'relaxation'?"},
         {"[[family]]\nscene = \"gone.toml\"\n", 2, 9, "there is no such file"},
         {family("parameters.gama = 1"), 3, 12, "did you mean 'gamma'?"},
         {gamma_is("3"), 3, 20, "gamma = 3: must be a number in (0, 2]"},
         {gamma_is("\"x\""), 3, 20, "gamma: is a text, must be a number in (0, 2]"},
         {gamma_is("[0.5, 2.5]"), 3, 26, "gamma = 2.5: must be"},
         {gamma_is("[]"), 3, 20, "is an empty list"},
         {gamma_is("nan"), 3, 20, "gamma = nan: must be a finite number"},
         {gamma_is("{from = 0.1}"), 3, 20, "gamma: has no to"},
         {gamma_is("{from = 0.1, to = 1}"), 3, 20, "must have either step or count"},
         {gamma_is("{from = 0.1, to = 1, step = -0.1}"), 3, 48,
          "gamma.step = -0.1: must lead from 0.1 towards 1"},
         {gamma_is("{from = 1, to = 0.1, step = 0}"), 3, 48, "gamma.step = 0: must lead from 1 towards 0.1"},
         {gamma_is("{from = 0.1, to = 1, count = 9223372036854775807}"), 3, 49,
          "gamma.count = 9223372036854775807: must be a whole number from 2 to"},
         {gamma_is("9223372036854775807"), 3, 20, "gamma = 9.223372036854776e+18: must be"},
         {"steps = 9223372036854775807\n" + family(""), 1, 9,
          "steps = 9223372036854775807: must be a whole number from 1 to"},
         {gamma_is("{from = 0.1, to = 1, count = 1}"), 3, 49, "a whole number from 2 to"},
         {gamma_is("{from = 0.1, to = 1, count = 2.5}"), 3, 49, "gamma.count = 2.5"},
         {gamma_is("{from = 0.5, to = 2.5, count = 3}"), 3, 20, "gamma = 2.5: must be"},
         {gamma_is("{from = 0, to = 1, count = 3, spacing = \"log\"}"), 3, 20, "one sign"},
         {gamma_is("{from = 0.1, to = 1, count = 3, spacing = \"x\"}"), 3, 62,
          "gamma.spacing = x: must be \"linear\" or \"log\""},
         {gamma_is("{from = 0.1, to = 1, cuont = 3}"), 3, 41, "did you mean 'count'?"},
         {gamma_is("{distribution = \"uniform\", from = 0.1, to = 1}"), 3, 20, "the family must have draws"},
         {family("draws = 3"), 3, 9, "a parameter that has a distribution"},
         {family("draws = 0\nparameters.gamma = {distribution = \"uniform\", from = 0.1, to = 1}"), 3, 9,
          "draws = 0: must be a whole number from 1"},
         {family("draws = 9\nparameters.gamma = {distribution = \"uniform\", from = 1.9, to = 5}"), 4, 20,
          "must be a number in (0, 2]"},
         {family("draws = 9\nparameters.gamma = {distribution = \"gauss\", from = 1, to = 5}"), 4, 36,
          "\"log-uniform\" or \"normal\""},
         {family("draws = 9\nparameters.gamma = {distribution = \"normal\", mean = 1, deviation = 0}"), 4, 68,
          "gamma.deviation = 0: must be a finite number above 0"},
         {family("draws = 9\nparameters.gamma = {distribution = \"normal\", mean = 1, deviation = 1, "
                 "from = 1e9}"),
          4, 20, "no draw"},
         {family("until = -1"), 3, 9, "until = -1: must be"},
         {family("points = [{gamma = 0.5}, {gamma = 5}]"), 3, 35, "gamma = 5: must be"},
         {family("points = [{gamma = 0.5}]\nparameters.gamma = 0.5"), 1, 1,
          "gamma: must have one value in a point"},
         {family("parameters.gamma = {from = 0.1, to = 1, count = 1000}\n"
                 "parameters.lambda = {from = 1, to = 2, count = 1000}"),
          1, 1, "more than 100000 scenes"},
         {"steps = [4, 0]\n" + family(""), 1, 13, "steps = 0: must be a whole number"},
         {"steps = []\n" + family(""), 1, 9, "is an empty list"},
         {"steps = \"4\"\n" + family(""), 1, 9, "steps: is a text, must be a whole number from 1 to"},
         {"schemes = [\"l11\"]\n" + family(""), 1, 11, "did you mean 'l1'?"},
         {family("schemes = 3"), 3, 11, "schemes: is a number, must be a text"},
         {"accuracies = -1\n" + family(""), 1, 14, "accuracies = -1: must be"},
         {"grid = \"graded:0\"\n" + family(""), 1, 8, "grid = graded:0"},
         {"history = \"exact\"\n" + family(""), 1, 11, "history = exact: must be"},
         {"budget = 0\n" + family(""), 1, 10, "budget = 0: must be"},
         {"repeat = 1.5\n" + family(""), 1, 10, "repeat = 1.5: must be"},
         {"external = {a = 3}\n" + family(""), 1, 17, "a: is a number, must be a text"},
         {"accuracies = 1e-3\nexternal = {a = \"b\"}\n" + family(""), 1, 14,
          "accuracies = 0.001: must be without external, whose programs take steps"}}));

TEST(Studies, ExcludeTheOptionsThatTheyReplace) {
  for (const std::string option : {"--scene", "--set", "--scheme", "--external", "--steps", "--accuracy",
                                   "--repeat", "--grid", "--history", "--tolerance", "--budget"}) {
    EXPECT_THAT(fdebench({"run", "--study", "s.toml", option, "3", "--out", "o.jsonl"}),
                is_refused(2, AllOf(HasSubstr("--study"), HasSubstr(option))));
  }
}

}  // namespace
}  // namespace fde::bench
