// SPDX-License-Identifier: MIT
// The command line, run within this process: its output, its messages and its exit code.

#include "fdebench/reports/command/command.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "fdebench/benchmarks/records/results_file.hpp"
#include "support/command_line_result.hpp"
#include "support/temporary_folder.hpp"
#include "support/testing.hpp"

namespace fde::bench {
namespace {

TEST(Values, ThatAreEmptyAreNotTheDefault) {
  const std::vector<std::string> solve{"solve",   "relaxation", "--scheme", "l1",
                                       "--steps", "8",          "--until",  ""};
  EXPECT_THAT(fde::bench::fdebench(solve), fails_with(2, "fdebench: argument 8 is empty\n"));
}

TEST(SceneRegistry, AreNamedAlikeByEveryCommand) {
  const auto alike = [](const std::string& label, const std::string& settings) {
    EXPECT_EQ(printed(fdebench(label)), fdebench(settings).out);
  };
  alike("solve pendulum:alpha=1.25,beta=0.75,until=5 --scheme l1 --steps 8",
        "solve pendulum:alpha=1.25 --set beta=0.75 --until 5 --scheme l1 --steps 8");
  alike("exact relaxation:gamma=0.25 --at 1 --digits 30",
        "exact relaxation --set gamma=0.25 --at 1 --digits 30");
  alike("geometry loxodrome:theta0=0.75", "geometry loxodrome --set theta0=0.75");
}

struct Mistake {
  const char *words, *message;
};

class Mistakes : public testing::TestWithParam<Mistake> {};

TEST_P(Mistakes, AreOneLineAndExitCodeTwo) {
  EXPECT_THAT(fdebench(GetParam().words), is_refused(2, HasSubstr(GetParam().message)));
}

INSTANTIATE_TEST_SUITE_P(
    , Mistakes,
    testing::ValuesIn<Mistake>(
        {{"solve pendulm --scheme l1 --steps 8", "scene pendulm: no such scene, did you mean 'pendulum'?"},
         {"scenes pendulm", "the nearest of "},
         {"scenes pendulum --json", "id = pendulum: must be alone"},
         {"--quiet=1 scenes", "--quiet: takes no value; see fdebench scenes --help"},
         {"scenes --json=true", "--json: takes no value"},
         {"help --man accuracy", "a topic has no manual page; fdebench help accuracy prints it"},
         {"solve pendulum:beta=0.5 --set beta=0.25 --scheme l1 --steps 8",
          "setting = beta=0.25: must be one value for each name"},
         {"solve pendulum:until=5 --until 4 --scheme l1 --steps 8",
          "--until = 4: must be without until= in the scene"},
         {"run --set beta=0.5 --out /tmp/never", "--set = beta=0.5: must be with --scene"},
         {"solve pendulum --scheme l1 --steps 8 --every 0", "--every = 0: must be"},
         {"solve pendulum --scheme l1 --steps 8 --threads 0", "--threads = 0: must be"},
         {"solve fractional_diffusion_2d:n=1001 --scheme l1 --steps 8",
          "n = 1001: must be a number in [2, 1000]"},
         {"solve fractional_diffusion_2d:n=2.5 --scheme l1 --steps 8", "n = 2.5: must be a whole number"},
         {"solve fractional_diffusion_2d:n=2 --scheme l1 --steps 8", "modes = 3: must be at most n = 2"},
         {"solve pendulum --scheme l1 --steps 8 --points 1", "--points = 1: must be"},
         {"solve pendulum --scheme l1 --steps 8 --points 4 --every 2", "excludes"},
         {"solve pendulum --scheme spectral_collocation --accuracy 1e-6 --every 2",
          "--every = 2: must be with --steps; with --accuracy --points K prints K equal times"},
         {"solve relaxation --scheme l1 --steps 100000000 --every 10",
          "--every = 10: must be a whole number from 11"},
         {"solve pendulum --scheme adams --steps 8",
          "scheme adams: no such scheme, did you mean 'adams_pc'?"},
         {"solve pendulum --scheme l1 --steps 0", "--steps = 0: must be a whole number from 1 to 1000000000"},
         {"solve pendulum --scheme l1 --steps -5", "--steps = -5: must be"},
         {"solve pendulum --scheme l1 --steps 1e3", "--steps = 1e3: must be"},
         {"solve pendulum --scheme l1 --steps 99999999999", "--steps = 99999999999: must be"},
         {"solve pendulum --scheme l1", "--steps is required"},
         {"solve pendulum --scheme l1 --steps 8 --accuracy 1e-6", "--steps excludes --accuracy"},
         {"solve pendulum --scheme l1 --accuracy 0", "--accuracy = 0: must be"},
         {"solve pendulum --scheme l1 --accuracy 1e-6", "--scheme = l1: l1 takes a grid, not an accuracy"},
         {"solve pendulum --scheme l1 --steps 8 --until nan",
          "--until = nan: must be a number in [1e-290, 1e+290]"},
         {"solve pendulum --scheme l1 --steps 8 --until -1",
          "--until = -1: must be a number in [1e-290, 1e+290]"},
         {"solve pendulum --scheme l1 --steps 8 --at 21",
          "--at = 21: must be in [0, 20], the times of the run"},
         {"solve pendulum --scheme l1 --steps 8 --at 3", "its neighbours are 2.5 and 5"},
         {"solve pendulum --scheme l1 --steps 8 --at 1,,2", "--at = : must be a finite number of at least 0"},
         {"exact pendulum --at 0:0.1:1",
          "--at = 0:0.1:1: must be a finite number of at least 0, or several with commas between them"},
         {"solve pendulum alpha=1.5 --scheme l1 --steps 8",
          "alpha=1.5: solve takes no such argument; --set alpha=1.5 sets a parameter"},
         {"solve pendulum --scheme l1 --dt 0.01", "--dt: solve has no such option; here it is --steps"},
         {"choose pendulum --accuracy 1e-6", "--accuracy: choose has no such option; here it is --error"},
         {"solve pendulum --alpha 1.5", "a parameter of the scene is set by --set NAME=VALUE"},
         {"exact data.csv --at 1", "scene = data.csv: must be the id of a scene, or an equation file"},
         {"solve pendulum --scheme l1 --steps 8 --set alpha", "setting = alpha: must be NAME=VALUE"},
         {"solve pendulum --scheme l1 --steps 8 --set alpha=x", "alpha = x: must be a number"},
         {"solve pendulum --scheme l1 --steps 8 --set alpha=2.5", "alpha = 2.5: must be a number in [1, 2]"},
         {"solve relaxation --scheme l1 --steps 8 --set gamma=nan",
          "gamma = nan: must be a number in (0, 2]"},
         {"solve relaxation --scheme grunwald_letnikov --steps 8 --grid graded:2",
          "grunwald_letnikov needs a uniform grid, not one graded with 2"},
         {"solve relaxation --scheme l1 --steps 100000 --grid graded:80",
          "l1 needs a first step above 1e-290, not 0"},
         {"run --trials --steps 64 --out x", "--trials = yes: must be without --scene and --steps"},
         {"run --thorough --steps 64 --out x", "--thorough = yes: must be without --steps and --accuracy"},
         {"run --scene relaxation --examine --out x",
          "--examine = yes: must be with numbers of steps or tolerances"},
         {"run --scene relaxation --undisturbed --out x",
          "--undisturbed = yes: must be with numbers of steps"},
         {"run --steps 64 --examine --undisturbed --out x", "--undisturbed = yes: must be without --examine"},
         {"solve power --set gamma=2 --scheme product_trapezoidal --steps 8 --until 1e-170",
          "product_trapezoidal needs a first step above 1e-145, not 1.25e-171"},
         {"solve relaxation --scheme l1 --steps 3000000 --at 1 --history direct",
          "--history = direct: takes up to 2097152 steps"},
         {"solve relaxation --scheme l1 --steps 1000 --grid graded:5 --at 3e-14",
          "--at = 3e-14: must be a time of the grid: its neighbours are 1.0000000000000001e-15 and 3.2"},
         {"solve fractional_hamilton --scheme product_trapezoidal --steps 8 --until 5",
          "until = 5: must be 2: scene fractional_hamilton is posed at both ends"},
         {"exact fractional_extremum:until=0.5 --at 0.25",
          "until = 0.5: must be 1: scene fractional_extremum is posed at both ends"},
         {"plot fractional_extremum:until=0.5 --kind solution --out x.svg",
          "until = 0.5: must be 1: scene fractional_extremum is posed at both ends"},
         {"solve fractional_extremum --scheme l1 --steps 8",
          "l1 steps from the left: component 1 has a right derivative"},
         {"exact fractional_extremum --at 0.5,2", "--at = 2: must be in [0, 1], the time of the scene"},
         {"exact two_sided_constraint --at 1 --digits 40", "has no exact solution in digits"},
         {"solve relaxation --scheme l1 --steps 20000000",
          "--at, --every or --points is needed beyond 10000000 steps"},
         {"solve relaxation --scheme l1 --steps 8 --grid curved",
          "--grid = curved: must be uniform or graded:R"},
         {"solve relaxation --scheme l1 --steps 8 --history fft",
          "--history = fft: must be auto, direct or exponentials"},
         {"solve relaxation --scheme l1 --steps 8 --fast", "--fast"},
         {"solve relaxation --scheme commensurate_adams_pc --steps 8 --set gamma=0.123456789",
          "needs orders that are multiples of one 1/M"},
         {"exact relaxation --at 1,", "--at = : must be"},
         {"exact relaxation --at -1", "--at = -1: must be a finite number of at least 0"},
         {"exact relaxation --at 1 --digits 0", "--digits = 0: must be a whole number from 1"},
         {"exact relaxation --at 1 --budget 0", "--budget = 0: must be a finite number above 0"},
         {"exact relaxation --at 1 --budget soon", "--budget = soon: must be a finite number above 0"},
         {"exact pendulum --at 1 --digits 50", "scene pendulum has no exact solution"},
         {"mittag-leffler 0 1 1", "ALPHA = 0: must be a number in (0, 5]"},
         {"mittag-leffler 1 1 nan", "Z = nan: must be a finite number"},
         {"mittag-leffler 1e-400 1 1",
          "ALPHA = 1e-400: underflows double, whose least number is 4.9e-324, "
          "and must be a number in (0, 5]"},
         {"mittag-leffler 1e400 1 1", "ALPHA = 1e400: overflows double, whose largest number is 1.8e+308"},
         {"exact relaxation --at 0.001e-322", "--at = 0.001e-322: underflows double"},
         {"exact relaxation --at 1 --set gamma=1e-400", "gamma = 1e-400: underflows double"},
         {"exact relaxation --at 1 --set y0=-1e99999999999", "y0 = -1e99999999999: overflows double"},
         {"run --scene relaxation:gamma=0.1:0.9 --out /tmp/never",
          "gamma = 0.1:0.9: must be FIRST:LAST:STEP"},
         {"run --scene relaxation:gamma=0.1:0.9:0 --out /tmp/never",
          "gamma = 0.1:0.9:0: must be FIRST:LAST:STEP with a step from FIRST towards LAST"},
         {"run --scene relaxation:gamma=0.1:0.9:-0.1 --out /tmp/never",
          "with a step from FIRST towards LAST"},
         {"run --scene relaxation:gamma=0.1:x:0.1 --out /tmp/never",
          "gamma = 0.1:x:0.1: must be FIRST:LAST:STEP"},
         {"run --scene relaxation:gamma=0.1:0.9:0.0001 --out /tmp/never",
          "must be a range of at most 1000 values, not 8001"},
         {"run --scene relaxation:gamma=0.01:0.9:0.01,re=-9:-1:0.1 --out /tmp/never",
          "must be a range of at most 1000 scenes with the others"},
         {"run --scene relaxation:gamma=1:3:0.5 --out /tmp/never", "gamma = 2.5: must be a number in (0, 2]"},
         {"solve relaxation:gamma=0.1:0.9:0.1 --scheme l1 --steps 8",
          "gamma = 0.1:0.9:0.1: must be a number in (0, 2]"},
         {"mittag-leffler 1 1", "Z is missing: must be RE, RE,IM or RE+IMi, or --matrix"},
         {"mittag-leffler 1 1 1 --derivative 1.5", "--derivative = 1.5: must be a whole number from 0"},
         {"mittag-leffler 1 1 1 --gamma x", "--gamma = x: must be a number in [-10000, 10000]"},
         {"mittag-leffler 1 1 1 --gamma 2 --derivative 1", "--gamma = 2: must be without --derivative"},
         {"mittag-leffler 1 1 --matrix 1 --gamma 2", "--gamma = 2: must be without --matrix"},
         {"mittag-leffler 1 1 1 --matrix 1", "Z = 1: must be left out with --matrix"},
         {"mittag-leffler 1 1 --matrix 1,2;3", "--matrix = 1,2;3: must be square"},
         {"mittag-leffler 1 1 --matrix 1,2;3,4j", "--matrix = 4j: must be a finite number"},
         {"run --scene relaxation --out /nonexistent/r.jsonl", "/nonexistent/r.jsonl: cannot be written"},
         {"run --scene relaxation --grid curved --out /tmp/never",
          "--grid = curved: must be uniform or graded:R"},
         {"run --scene relaxation --steps 8,0 --out /tmp/never", "--steps = 0: must be"},
         {"report /nonexistent.jsonl --out /tmp/never", "/nonexistent.jsonl: cannot be read"},
         {"run --scene pendulum:alpha=3 --out /tmp/never", "alpha = 3: must be a number in [1, 2]"},
         {"choose relaxation --error 0", "--error = 0: must be a number in (1e-15, 1)"},
         {"choose relaxation --error 1", "--error = 1: must be a number in (1e-15, 1)"},
         {"choose relaxation --error 1e-3 --norm start", "--norm = start: must be end or maximum"},
         {"choose relaxation --error 1e-3 --scale log",
          "--scale = log: must be absolute, relative, mixed or peak"},
         {"choose pendulum --error 1e-3 --columns phi,psi", "--columns = psi: must be of phi, "},
         {"choose relaxation --error 1e-3 --max-time 0", "--max-time = 0: must be"},
         {"choose relaxation:until=2 --error 1e-3 --until 3", "until"},
         {"solv pendulum", "command solv: no such command, did you mean 'solve'?"},
         {"", "subcommand"}}),
    [](const auto& test) { return "mistake_" + std::to_string(test.index); });

TEST(Run, ThenReportThenChoose) {
  const TemporaryFolder folder;
  const auto file = folder.file("r.jsonl"), page = folder.file("page");
  const std::string sweep =
      "run --scene relaxation --scheme l1 --scheme adams_pc --steps 16,32,64,128 --out " + file;
  EXPECT_EQ(fdebench(sweep).out, file + "\n");
  const auto size = std::filesystem::file_size(file);
  EXPECT_EQ(fdebench(sweep).code, 0);
  EXPECT_EQ(std::filesystem::file_size(file), size) << "a second run has nothing left to do";

  expect_success(fdebench("report " + file + " --out " + page));
  EXPECT_GT(std::filesystem::file_size(page + "/index.html"), 300'000U);

  const auto choice = fdebench("choose relaxation --norm end --error 1e-4 --results " + file);
  EXPECT_THAT(choice.out, HasSubstr("--scheme adams_pc --steps "));
  EXPECT_THAT(fdebench("choose relaxation --norm end --error 1e-9 --results " + file),
              fails_with(3, StartsWith("fdebench: no run of relaxation is within 1.0e-9 (at the end, mixed "
                                       "scale): best: ")));
}

// The values are the decimals 0.1, 0.2, ..., not sums of doubles.
TEST(Run, TakesRangesOfParameters) {
  const TemporaryFolder folder;
  const std::string file = folder.file("r.jsonl"), how = " --scheme l1 --steps 8 --out " + file;
  const auto scenes_in = [&] {
    std::set<std::string> found;
    for (const auto& row : read_results(file).records) found.insert(label_of(row.key.scene));
    std::filesystem::remove(file);
    return found;
  };
  EXPECT_EQ(fdebench("run --scene relaxation:gamma=0.1:0.9:0.1" + how).code, 0);
  EXPECT_THAT(scenes_in(),
              ElementsAre("relaxation:gamma=0.1", "relaxation:gamma=0.2", "relaxation:gamma=0.3",
                          "relaxation:gamma=0.4", "relaxation:gamma=0.5", "relaxation:gamma=0.6",
                          "relaxation:gamma=0.7", "relaxation:gamma=0.8", "relaxation:gamma=0.9"));
  EXPECT_EQ(fdebench("run --scene relaxation --set gamma=0.5:0.1:-0.3 --set until=1:2:1" + how).code, 0);
  EXPECT_THAT(scenes_in(), ElementsAre("relaxation:gamma=0.2,until=1", "relaxation:gamma=0.2,until=2",
                                       "relaxation:gamma=0.5,until=1", "relaxation:gamma=0.5,until=2"));
}

TEST(Run, TakesVariantsOfScenes) {
  const TemporaryFolder folder;
  const auto file = folder.file("r.jsonl");
  expect_success(fdebench(
      "run --scene pendulum:beta=0.1,alpha=1.9 --scheme commensurate_adams_pc --steps 16 --out " + file));
  EXPECT_THAT(content_of(file),
              AllOf(HasSubstr(R"("scene":"pendulum")"), HasSubstr(R"("settings":{"alpha":1.9,"beta":0.1})")));
}

// Runs with another grid, history or tolerance are different runs: they are measured in addition to the
// first.
TEST(Run, WritesTheWholeSetupAndContinuesByIt) {
  const TemporaryFolder folder;
  const auto file = folder.file("r.jsonl");
  const std::string sweep = "run --scene relaxation --scheme l1 --steps 16 --out " + file;
  EXPECT_EQ(fdebench(sweep).code, 0);
  const auto size = std::filesystem::file_size(file);
  EXPECT_EQ(fdebench(sweep + " --grid graded:2 --history direct --tolerance 1e-8 --budget 60").code, 0);
  EXPECT_GT(std::filesystem::file_size(file), size);
  std::vector<RunSettings> settings;
  for (const auto& run : read_results(file).records) settings.push_back(run.key.settings);
  EXPECT_EQ(settings, (std::vector<RunSettings>{{.resolution = 16, .budget = 600.0},
                                                {16, 2.0, HistoryKind::direct, 1e-8, 60.0}}));
  EXPECT_THAT(fdebench("choose relaxation --error 0.9 --results " + file).out,
              HasSubstr("--scheme l1 --steps 16"));
}

TEST(Help, IsPrintedOnStandardOutput) {
  EXPECT_EQ(fdebench("--help").code, 0);
  EXPECT_THAT(fdebench("solve --help").out, HasSubstr("--steps"));
}

}  // namespace
}  // namespace fde::bench
