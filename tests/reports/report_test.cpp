#include "page/report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "analysis/line_rates.hpp"
#include "analysis/recommendation.hpp"
#include "analysis/text.hpp"

namespace fde {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

constexpr double end_time = 8.0;
const std::vector<int> all_steps{64, 128, 256, 512};

Results empty_results() {
  return {.sessions = {{.date = "2025-01-02T03:04:05Z",
                        .machine = "the machine",
                        .system = "",
                        .compiler = "the compiler",
                        .flags = "-O3",
                        .commit = "0123abc",
                        .version = ""}},
          .records = {}};
}

struct Run {
  std::string scene, scheme;
  int steps;
};

void add_row(Results& results, const Run& run, const std::string& quantity, double value) {
  results.records.push_back(
      {.key = {.scene = {run.scene}, .scheme = run.scheme, .setup = {.resolution = run.steps}},
       .steps = run.steps,
       .h = end_time / run.steps,
       .quantity = quantity,
       .value = value,
       .session = results.sessions.size() - 1});
}

void add_ending(Results& results, const Run& run, double until, const RunEnding& ending = {}) {
  add_row(results, run, "ending", until);
  results.records.back().ending = ending;
}

void add_run(Results& results, const Run& run, double error, double seconds) {
  add_row(results, run, "error_end", error);
  add_row(results, run, "time_minimum", seconds);
  add_ending(results, run, end_time);
}

// Errors 0.01 h^rate at the end and h in the maximum norm, a time proportional to the steps.
void add_line(Results& results, const std::string& scheme, double rate, double seconds_a_step) {
  for (const int steps : all_steps) {
    const struct Run run { "pendulum", scheme, steps };
    const double h = end_time / steps;
    add_row(results, run, "error_maximum", h);
    add_row(results, run, "reference_bound", 1e-15);
    add_row(results, run, "expected_rate_end", rate);
    add_row(results, run, "expected_rate_maximum", 2.0);
    add_run(results, run, 0.01 * std::pow(h, rate), seconds_a_step * steps);
  }
}

// At the end l1 has 4.4e-4, 1.6e-4, 5.5e-5, 2.0e-5 and adams_pc 1.6e-4, 3.9e-5, 9.8e-6, 2.4e-6.
Results two_lines() {
  Results results = empty_results();
  add_line(results, "l1", 1.5, 1e-6);
  add_line(results, "adams_pc", 2.0, 3e-6);
  return results;
}

constexpr ErrorKind at_end{Norm::end, Scale::absolute};

std::vector<Option> within(const Results& results, double accuracy) {
  return options_within(runs_of(results), {"pendulum"}, at_end, accuracy);
}

TEST(Options, AreTheQuickestRunsWithinTheAccuracy) {
  const auto ranked = within(two_lines(), 3e-5);
  ASSERT_EQ(ranked.size(), 2);
  EXPECT_EQ(ranked[0].schemes.front(), "l1");
  EXPECT_EQ(ranked[0].steps, 512);
  EXPECT_DOUBLE_EQ(ranked[0].time.median, 512e-6);
  const auto predicted = with_prediction(ranked[0], runs_of(two_lines()), {"pendulum"}, at_end);
  EXPECT_NEAR(predicted.predicted_error.value() / ranked[0].error, 1.0, 1e-3) << "by the coarser runs alone";
  EXPECT_EQ(ranked[1].schemes.front(), "adams_pc");
  EXPECT_EQ(ranked[1].steps, 256);
}

TEST(Options, LeaveOutSchemesThatDoNotReachTheError) {
  const auto ranked = within(two_lines(), 1e-5);
  ASSERT_EQ(ranked.size(), 1);
  EXPECT_EQ(ranked[0].schemes.front(), "adams_pc");
}

TEST(Options, PreferTheSmallerErrorAtEqualTimes) {
  Results results = empty_results();
  add_run(results, {"pendulum", "adams_pc", 64}, 2e-3, 1.0);
  add_run(results, {"pendulum", "l1", 64}, 1e-3, 1.0);
  const auto ranked = within(results, 1e-2);
  ASSERT_EQ(ranked.size(), 2);
  EXPECT_EQ(ranked[0].schemes.front(), "l1");
}

TEST(Options, CountARunMeasuredAgainWithItsLastSession) {
  Results results = empty_results();
  add_run(results, {"pendulum", "l1", 64}, 1e-3, 1.0);
  results.sessions.push_back(results.sessions.front());
  add_run(results, {"pendulum", "l1", 64}, 1e-3, 2.0);
  const auto ranked = within(results, 1e-2);
  ASSERT_EQ(ranked.size(), 1);
  EXPECT_EQ(ranked[0].time.median, 2.0);
  EXPECT_EQ(ranked[0].session, 1);
}

TEST(Options, AreNoRunsThatZeroWouldMatch) {
  Results results = empty_results();
  const struct Run run { "pendulum", "l1", 64 };
  add_row(results, run, "trivial_end", 5e-4);
  add_run(results, run, 1e-3, 1.0);
  EXPECT_TRUE(within(results, 1e-2).empty());
}

TEST(Options, DifferInTheKindOfError) {
  const auto ranked =
      options_within(runs_of(two_lines()), {"pendulum"}, {Norm::maximum, Scale::absolute}, 0.1);
  ASSERT_EQ(ranked.size(), 2);
  EXPECT_EQ(ranked[0].error, end_time / ranked[0].steps);
}

TEST(Shortfall, NamesTheBestErrorAndTheStepsThatAreNeeded) {
  const Runs runs = runs_of(two_lines());
  const auto missed = shortfall(runs, {"pendulum"}, at_end, 1e-9);
  ASSERT_TRUE(missed && missed->steps_needed);
  EXPECT_EQ(missed->best.schemes.front(), "adams_pc");
  EXPECT_EQ(missed->best.steps, 512);
  EXPECT_EQ(missed->line.schemes.front(), "adams_pc");
  const double exact = 512 * std::sqrt(0.01 / 4096 / 1e-9);
  EXPECT_NEAR(missed->steps_needed->value / exact, 1.0, 0.01);
  EXPECT_LE(missed->steps_needed->low, exact);
  EXPECT_GE(missed->steps_needed->high, exact);
  EXPECT_FALSE(shortfall(runs, {"brusselator"}, at_end, 1e-9));
}

// A run that is examined but not timed is no answer, and not missing either.
TEST(Shortfall, CountsRunsThatAreNotTimedYet) {
  Results results = empty_results();
  const struct Run run { "pendulum", "l1", 64 };
  add_row(results, run, "error_end", 1e-5);
  add_ending(results, run, end_time);
  EXPECT_TRUE(within(results, 1e-3).empty());
  EXPECT_EQ(shortfall(runs_of(results), {"pendulum"}, at_end, 1e-3)->untimed, 1U);
  EXPECT_THAT(recommend(runs_of(results), {"pendulum"}, at_end, 1e-3).others,
              testing::Contains(HasSubstr("not timed yet")));
}

// The errors of adams_pc under another name, on fewer rungs: one line, which its longest runs stand for.
TEST(Options, OfOneAlgorithmAreOneWithSeveralNames) {
  Results results = empty_results();
  for (const auto* scheme : {"adams_pc", "decoupled_multi_order"}) {
    for (const int steps : {8, 16, 32, 64, 128, 256}) {
      if (steps == 256 && std::string_view(scheme) == "decoupled_multi_order") continue;
      const struct Run run { "pendulum", scheme, steps };
      add_row(results, run, "error_maximum", 1.0 / steps);
      add_run(results, run, 1.0 / steps, 1e-6 * steps);
    }
  }
  const auto ranked = within(results, 5e-3);
  ASSERT_EQ(ranked.size(), 1);
  EXPECT_EQ(ranked[0].steps, 256);
  EXPECT_THAT(ranked[0].schemes, testing::ElementsAre("adams_pc", "decoupled_multi_order"));
  EXPECT_EQ(shortfall(runs_of(results), {"pendulum"}, at_end, 1e-3)->line.schemes.front(), "adams_pc");
  EXPECT_GE(shortfall(runs_of(results), {"pendulum"}, at_end, 1e-3)->steps_needed->low, 257.0);
}

Option option(const std::string& scheme, int steps, const TimeSpread& time) {
  return {.schemes = {scheme}, .setup = {.resolution = steps}, .steps = steps, .error = 1e-7, .time = time};
}

// Intervals [9, 11], [10.5, 13] and [20, 21].
TEST(Recommendation, TellsWhatIsWithinNoise) {
  const Recommendation made{
      .scene = {"pendulum"},
      .kind = at_end,
      .accuracy = 1e-6,
      .options = {option("l1", 512, {10.0, 9.0, 11.0}), option("adams_pc", 256, {12.0, 10.5, 13.0}),
                  option("product_trapezoidal", 64, {20.5, 20.0, 21.0})}};
  EXPECT_THAT(within_noise(made), testing::ElementsAre("adams_pc"));
  EXPECT_EQ(runner_up(made)->schemes.front(), "adams_pc");
  const auto json = nlohmann::json::parse(json_of(made));
  for (const auto* field :
       {"scene", "scheme", "grid", "steps", "norm", "scale", "error", "predicted_error", "seconds",
        "seconds_low", "seconds_high", "within_noise", "runner_up", "factor", "command"}) {
    EXPECT_TRUE(json.contains(field)) << field;
  }
  EXPECT_EQ(json["steps"], 512);
  EXPECT_DOUBLE_EQ(json["factor"], 1.2);
  EXPECT_EQ(json["command"], "fdebench solve pendulum --scheme l1 --steps 512");
  EXPECT_THAT(text_of(made), HasSubstr("within noise of adams_pc\n"));
  EXPECT_THAT(text_of(made), HasSubstr("2 times more steps"));
}

TEST(Rates, AreThoseOfExactPowers) {
  const auto rows = rates(runs_of(two_lines()));
  ASSERT_EQ(rows.size(), 2);
  EXPECT_EQ(rows[0].scheme, "adams_pc");  // in the order of the list of schemes
  EXPECT_NEAR(rows[0].end.fit.slope, 2.0, 1e-12);
  EXPECT_NEAR(rows[1].end.fit.slope, 1.5, 1e-12);
  EXPECT_NEAR(rows[1].end.deviation().value(), 0.0, 1e-12);
  EXPECT_NEAR(rows[1].maximum.deviation().value(), -1.0, 1e-12);
  EXPECT_NEAR(rows[1].maximum.fit.correlation, 1.0, 1e-12);
}

TEST(Text, RoundsForReaders) {
  EXPECT_EQ(error_text(1.23e-7), "1.2e-7");
  EXPECT_EQ(error_text(9.96e-8), "1.0e-7");
  EXPECT_EQ(error_text(0.0), "0");
  EXPECT_EQ(time_text(3.456e-3), "3.46 ms");
  EXPECT_EQ(time_text(1.2345e-5), "12.3 µs");
  EXPECT_EQ(bytes_text(65536), "65.5 kB");
  EXPECT_EQ(count_text(1234567), "1\u202f234\u202f567");
  EXPECT_EQ(rough_count_text(34567), "35\u202f000");
}

// A folder of this test alone that does not exist yet.
fs::path fresh_folder() {
  auto folder = fs::path(testing::TempDir()) / "fdebench_report_test" /
                testing::UnitTest::GetInstance()->current_test_info()->name();
  fs::remove_all(folder);
  return folder;
}

std::string written(const Results& results) {
  std::ostringstream text;
  text << std::ifstream(write_report(results, fresh_folder())).rdbuf();
  return text.str();
}

// The data of a page, as its script reads it.
nlohmann::json data_of(const std::string& page) {
  const std::string open = R"(<script type="application/json" id="data">)";
  const auto start = page.find(open) + open.size();
  return nlohmann::json::parse(page.substr(start, page.find("</script>", start) - start));
}

std::vector<std::string> section_ids(const nlohmann::json& data) {
  std::vector<std::string> ids;
  for (const auto& section : data["sections"]) ids.push_back(section["id"]);
  return ids;
}

// Runs of relaxation with errors gamma / N, and of no other scheme beyond 128 steps.
Results over_gamma(const std::vector<double>& values) {
  Results results = empty_results();
  for (const double gamma : values) {
    for (const auto& [scheme, most] : {std::pair{"l1", 256}, std::pair{"adams_pc", 128}}) {
      for (int steps = 64; steps <= most; steps *= 2) {
        add_run(results, {"relaxation", scheme, steps}, gamma / steps, 1e-6 * steps);
        constexpr std::ptrdiff_t rows = 3;  // of each run
        for (auto row = results.records.end() - rows; row != results.records.end(); ++row)
          if (gamma != 0.5) row->key.scene.values = {{"gamma", gamma}};
      }
    }
  }
  return results;
}

// Half is the default of gamma. N = 256 is not common to both lines.
TEST(Report, DrawsErrorAndTimeOverAParameterOfThreeValues) {
  const auto data = data_of(written(over_gamma({0.9, 0.1, 0.5})));
  ASSERT_THAT(section_ids(data), testing::Contains("curve-relaxation-gamma"));
  for (const auto& section : data["sections"]) {
    if (section["id"] != "curve-relaxation-gamma") continue;
    EXPECT_EQ(section["parameter"], "gamma");
    ASSERT_EQ(section["points"].size(), 6U);
    std::vector<double> values;
    for (const auto& point : section["points"]) {
      EXPECT_EQ(point["steps"], 128);
      EXPECT_DOUBLE_EQ(point["errors"]["error_end"].get<double>(), point["value"].get<double>() / 128);
      EXPECT_DOUBLE_EQ(point["seconds"].get<double>(), 1.28e-4);
      if (point["line"] == "l1") values.push_back(point["value"]);
    }
    EXPECT_THAT(values, testing::ElementsAre(0.1, 0.5, 0.9));
  }
  EXPECT_THAT(section_ids(data_of(written(over_gamma({0.9, 0.5})))),
              Not(testing::Contains("curve-relaxation-gamma")));
}

TEST(Report, HoldsEverySceneSchemeSessionAndFailure) {
  Results results = two_lines();
  add_run(results, {"brusselator", "grunwald_letnikov", 64}, 1e-3, 1.0);
  add_ending(results, {"diethelm", "product_trapezoidal", 64}, 0.0,
             {Ending::refused, "takes </script> for an order"});
  add_ending(results, {"diethelm", "l1", 64}, 1.5, {Ending::not_finite, "at step 13, t = 1.5"});
  const auto data = data_of(written(results));
  const std::string shown = data.dump();
  for (const auto* text :
       {"adams_pc", "l1", "grunwald_letnikov", "product_trapezoidal", "Fractional Brusselator",
        "refused: takes </script> for an order", "not finite at step 13, t = 1.5", "the machine",
        "the compiler", "-O3", "0123abc", "2025-01-02T03:04:05Z"}) {
    EXPECT_THAT(shown, HasSubstr(text));
  }
  EXPECT_THAT(section_ids(data), testing::ElementsAre("answer", "scene-pendulum", "scene-brusselator",
                                                      "rates", "cost", "reference", "failures", "schemes"));
}

// The same runs with another grid, history or tolerance are other lines, and say so.
TEST(Report, NamesALineByWhatTellsItsSetupFromOthers) {
  Results results = two_lines();
  for (const auto& row : two_lines().records) {
    if (row.key.scheme != "l1") continue;
    results.records.push_back(row);
    results.records.back().key.setup.grading = 2.0;
  }
  const auto lines = [](const Results& of) {
    return data_of(written(of))["lines"].get<std::vector<std::string>>();
  };
  EXPECT_THAT(lines(results),
              testing::UnorderedElementsAre("adams_pc, uniform", "l1, uniform", "l1, graded:2"));
  EXPECT_THAT(text_of(recommend(runs_of(results), {"pendulum"}, {Norm::end, Scale::absolute}, 3e-5)),
              HasSubstr("l1, graded:2: N = 512"));
  EXPECT_THAT(lines(two_lines()), testing::UnorderedElementsAre("adams_pc", "l1"));
}

TEST(Report, MarksRatesThatDeviate) {
  EXPECT_THAT(data_of(written(two_lines())).dump(), HasSubstr("1.00 below theory"));
}

TEST(Report, LeavesOutWhatHasNoData) {
  const auto data = data_of(written(two_lines()));
  EXPECT_THAT(section_ids(data), Not(testing::Contains("failures")));
  EXPECT_THAT(data["sessions"].dump(), Not(HasSubstr("version")));
  EXPECT_THAT(data.dump(), Not(HasSubstr("history")));
  EXPECT_THAT(data.dump(), Not(HasSubstr("n/a")));
}

TEST(Report, LoadsNothingFromANetwork) {
  const std::string page = written(two_lines());
  EXPECT_FALSE(std::regex_search(page, std::regex(R"((src|href)\s*=\s*["']?(https?:)?//)")));
  EXPECT_FALSE(std::regex_search(page, std::regex(R"(@import|url\(\s*["']?http)")));
  EXPECT_THAT(page, HasSubstr("vegaEmbed"));
  EXPECT_THAT(page, HasSubstr("University of Washington Interactive Data Lab"));
}

TEST(Report, LeavesOneFileAndReplacesAnOlderOne) {
  const fs::path folder = fresh_folder() / "new" / "folder";
  const fs::path path = write_report(empty_results(), folder);
  EXPECT_EQ(path, folder / "index.html");
  const auto before = fs::file_size(path);
  write_report(two_lines(), folder);
  EXPECT_GT(fs::file_size(path), before);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
}

TEST(Report, NamesThePathThatCannotBeWritten) {
  const fs::path folder = fresh_folder(), file = folder / "a_file";
  fs::create_directories(folder);
  std::ofstream(file) << "x";
  try {
    write_report(two_lines(), file / "below");
    FAIL() << "a folder below a file";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr((file / "below").string()));
  }
}

}  // namespace
}  // namespace fde
