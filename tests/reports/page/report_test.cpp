// SPDX-License-Identifier: MIT
#include "fdebench/reports/page/report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/text/output_text.hpp"
#include "fdebench/reports/analysis/line_rates.hpp"
#include "fdebench/reports/analysis/recorded_recommendation.hpp"
#include "fdebench/reports/page/page_data.hpp"
#include "reports/page/page_section.hpp"
#include "reports/synthetic_results.hpp"
#include "support/matchers.hpp"
#include "support/message_of.hpp"
#include "support/temporary_folder.hpp"
#include "support/unpacked_page.hpp"

namespace fde::bench {
namespace {

namespace fs = std::filesystem;

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
  EXPECT_EQ(count_text(1234567), "1\u202f234\u202f567");
  EXPECT_EQ(rough_count_text(34567), "35\u202f000");
}

// A folder for this test only, which does not exist yet.
fs::path fresh_folder() {
  auto folder = fs::path(testing::TempDir()) / "fdebench_report_test" /
                testing::UnitTest::GetInstance()->current_test_info()->name();
  fs::remove_all(folder);
  return folder;
}

std::string written(const Results& results) {
  return content_of(write_report(read_runs(results), fresh_folder()));
}

// The JSON data embedded in a page.
nlohmann::json data_of(const std::string& page) { return nlohmann::json::parse(unpacked(page, "data")); }

std::vector<std::string> section_ids(const nlohmann::json& data) {
  std::vector<std::string> ids;
  for (const auto& section : data["sections"]) ids.push_back(section["id"]);
  return ids;
}

// Runs of l1 and adams_pc on relaxation with errors gamma / N; only l1 has more than 128 steps.
Results over_gamma(const std::vector<double>& values) {
  Results results = empty_results();
  results.scenes = {
      {.scene = {"relaxation"}, .title = "Relaxation", .parameters = {{"gamma", "0.5", "order"}}}};
  for (const double gamma : values) {
    for (const auto& [scheme, most] : {std::pair{"l1", 256}, std::pair{"adams_pc", 128}}) {
      for (int steps = 64; steps <= most; steps *= 2) {
        add_run(results, {"relaxation", scheme, steps}, gamma / steps, 1e-6 * steps);
        if (gamma != 0.5) results.records.back().key.scene.values = {{"gamma", gamma}};
      }
    }
  }
  return results;
}

// 1/2 is the default of gamma. N = 256 is not common to both lines.
TEST(Report, DrawsErrorAndTimeOverAParameterOfThreeValues) {
  const auto data = data_of(written(over_gamma({0.9, 0.1, 0.5})));
  ASSERT_THAT(section_ids(data), testing::Contains("curve-relaxation-gamma"));
  for (const auto& section : data["sections"]) {
    if (section["id"] != "curve-relaxation-gamma") continue;
    EXPECT_EQ(section["parameter"], "gamma");
    const auto& runs = section["runs"];
    EXPECT_EQ(runs["steps"], std::vector<int>(6, 128));
    EXPECT_EQ(runs["time_minimum"], std::vector<double>(6, 1.28e-4));
    EXPECT_EQ(runs["error_end"],
              std::vector<double>({7.8125e-4, 7.8125e-4, 3.9062e-3, 3.9062e-3, 7.0313e-3, 7.0313e-3}))
        << "to five digits";
    EXPECT_EQ(runs["value"], std::vector<double>({0.1, 0.1, 0.5, 0.5, 0.9, 0.9}));
    EXPECT_EQ(runs["lines"], std::vector<std::string>({"adams_pc", "l1"}));
    EXPECT_EQ(runs["line"], std::vector<int>({0, 1, 0, 1, 0, 1}));
  }
  EXPECT_THAT(section_ids(data_of(written(over_gamma({0.9, 0.5})))),
              Not(testing::Contains("curve-relaxation-gamma")));
}

TEST(Report, HoldsEverySceneSchemeSessionAndFailure) {
  Results results = two_lines();
  results.scenes.push_back({.scene = {"brusselator"}, .title = "Fractional Brusselator"});
  add_run(results, {"brusselator", "grunwald_letnikov", 64}, 1e-3, 1.0);
  add_ending(results, {"diethelm", "product_trapezoidal", 64}, 0.0,
             {SolveStatus::refused, "takes </script> for an order"});
  add_ending(results, {"diethelm", "l1", 64}, 1.5, {SolveStatus::non_finite, "at step 13, t = 1.5"});
  const auto data = data_of(written(results));
  const std::string shown = data.dump();
  for (const auto* text :
       {"adams_pc", "l1", "grunwald_letnikov", "product_trapezoidal", "Fractional Brusselator",
        "takes </script> for an order", "not_finite", "at step 13, t = 1.5", "the machine", "the compiler",
        "-O3", "0123abc", "2025-01-02T03:04:05Z"}) {
    EXPECT_THAT(shown, HasSubstr(text));
  }
  EXPECT_THAT(section_ids(data), ElementsAre("answer", "regions", "scene-pendulum", "scene-brusselator",
                                             "rates", "cost", "reference", "failures", "schemes"));
}

// At the end l1 is within 1e-4 with 256 steps of 1 us, adams_pc with 128 steps of 3 us: 1.5 times as long.
TEST(Report, HasTheCheapestRunOfASceneForEachAccuracyAndWhyItIs) {
  const auto data = data_of(written(two_lines()));
  EXPECT_EQ(section(data, "answer")["accuracies"][1], 1e-4);
  const auto answer = section(data, "scene-pendulum")["answers"]["error_end"][1];
  EXPECT_EQ(answer["accuracy"], 1e-4);
  EXPECT_EQ(answer["line"], "l1");
  EXPECT_EQ(answer["steps"], 256);
  EXPECT_NEAR(answer["seconds"].get<double>(), 256e-6, 1e-12);
  const auto& second = answer["second"];
  EXPECT_EQ(second["line"], "adams_pc");
  EXPECT_NEAR(second["ratio"].get<double>(), 1.5, 1e-6);
  EXPECT_NEAR(second["step_seconds"][0].get<double>(), 1e-6, 1e-12);
  EXPECT_NEAR(second["step_seconds"][1].get<double>(), 3e-6, 1e-12);
}

// To 1e-4 l1 is the cheapest by cheaper steps; 1e-6 is beyond all runs.
TEST(Report, ConcludesOnAScene) {
  const auto of = section(data_of(written(two_lines())), "scene-pendulum")["conclusions"]["error_end"];
  ASSERT_EQ(of["cheapest"].size(), 1U);
  EXPECT_EQ(of["cheapest"][0]["line"], "l1");
  EXPECT_EQ(of["cheapest"][0]["from"], 1e-2);
  EXPECT_EQ(of["cheapest"][0]["to"], 1e-4);
  EXPECT_EQ(of["leader"]["second"]["line"], "adams_pc");
  EXPECT_EQ(of["limit"]["accuracy"], 1e-6);
  EXPECT_EQ(of["limit"]["line"], "adams_pc");
}

// Early endings and refusals are listed against a scheme, but not that of steps that are too long for a scene
// which it solves.
TEST(Report, HasForEachSchemeWhereItIsNearestAndWhatSpeaksAgainstIt) {
  Results results = two_lines();
  add_ending(results, {"brusselator", "l1", 64}, 1.5, {SolveStatus::non_finite, "at step 13, t = 1.5"});
  add_ending(results, {"diethelm", "adams_pc", 64}, 0.0, {SolveStatus::refused, "takes no such order"});
  add_ending(results, {"pendulum", "adams_pc", 2}, 0.0, {SolveStatus::refused, "needs 3 steps"});
  const auto schemes = section(data_of(written(results)), "answer")["schemes"];
  ASSERT_EQ(schemes.size(), 2U);
  EXPECT_EQ(schemes[0]["line"], "adams_pc");  // in the order of the list of schemes
  const auto& nearest = schemes[0]["nearest"]["error_end"];
  EXPECT_EQ(nearest["scene"], "pendulum");
  EXPECT_EQ(nearest["accuracy"], 1e-4);
  EXPECT_NEAR(nearest["ratio"].get<double>(), 1.5, 1e-6);
  EXPECT_EQ(schemes[0]["against"],
            nlohmann::json::array({{{"refuses", {"diethelm"}}, {"reason", "takes no such order"}}}));
  EXPECT_EQ(schemes[1]["line"], "l1");
  EXPECT_EQ(schemes[1]["nearest"]["error_end"]["ratio"], 1);
  EXPECT_EQ(schemes[1]["against"][0]["fails"][0], "brusselator");
}

TEST(Report, HasHowFarTheBestRunIsFromAnAccuracy) {
  const auto row = section(data_of(written(two_lines())), "scene-pendulum")["answers"]["error_end"][2];
  EXPECT_FALSE(row.contains("line"));
  EXPECT_FALSE(row.contains("untimed"));
  EXPECT_EQ(row["best"]["line"], "adams_pc");
  EXPECT_EQ(row["best"]["steps"], 512);
  EXPECT_NEAR(row["best"]["error"].get<double>(), 2.44e-6, 1e-8);
  EXPECT_GT(row["needed"]["steps"], 512);
}

// The same runs with another grid, history or tolerance are other lines, with names that say so.
TEST(Report, NamesALineByWhatTellsItsSetupFromOthers) {
  Results results = two_lines();
  for (const auto& row : two_lines().records) {
    if (row.key.scheme != "l1") continue;
    results.records.push_back(row);
    results.records.back().key.settings.grading = 2.0;
  }
  const auto lines = [](const Results& of) {
    return data_of(written(of))["lines"].get<std::vector<std::string>>();
  };
  EXPECT_THAT(lines(results), testing::UnorderedElementsAre("adams_pc", "l1", "l1, graded:2"));
  EXPECT_THAT(to_text(recommend(runs_of(results), {"pendulum"}, {Norm::end, Scale::absolute}, 3e-5)),
              HasSubstr("--scheme l1 --steps 512\n"));
  EXPECT_THAT(lines(two_lines()), testing::UnorderedElementsAre("adams_pc", "l1"));
}

// Gradings that depend on the orders of the scenes give one line; its rows name the grading.
TEST(Report, NamesALineOnceWhoseGradingDiffersFromSceneToScene) {
  Results results = two_lines();
  for (const auto& [scene, grading] : {std::pair{"pendulum", 2.0}, std::pair{"brusselator", 3.0}}) {
    for (auto row : two_lines().records) {
      if (row.key.scheme != "l1") continue;
      row.key.scene = {scene};
      row.key.settings.grading = grading;
      results.records.push_back(row);
    }
  }
  const auto data = data_of(written(results));
  EXPECT_THAT(data["lines"].get<std::vector<std::string>>(),
              testing::UnorderedElementsAre("adams_pc", "l1", "l1, graded"));
  const auto rates = section(data, "rates").dump();
  EXPECT_THAT(rates, HasSubstr(R"("grid":"graded:2","line":"l1, graded")"));
  EXPECT_THAT(rates, HasSubstr(R"("grid":"graded:3","line":"l1, graded")"));
}

// With adaptive step size there is no step size h, hence no rate.
TEST(Rates, AreOfRunsOverGridsOnly) {
  Results results = two_lines();
  for (auto& row : results.records) {
    if (row.key.scheme == "l1") row.key.settings.resolution = Tolerance{.rtol = row.h(), .atol = row.h()};
  }
  const auto rows = rates(runs_of(results));
  ASSERT_EQ(rows.size(), 1);
  EXPECT_EQ(rows[0].scheme, "adams_pc");
}

TEST(Report, HasWhatAReferenceRestsOnAndTakes) {
  const auto of = section(data_of(written(two_lines())), "reference");
  const auto row = of["groups"][0]["rows"][0];
  EXPECT_EQ(row["evidence"], "two methods");
  EXPECT_EQ(row["seconds"], 0.25);
  EXPECT_EQ(of["cost"]["seconds"], std::vector({0.25, 0.25}));
}

// D^beta phi is phi at beta = 0 and tends to phi - phi(0).
TEST(Report, HasWhereASolutionIsNotTheLimitOfItsNeighbours) {
  Results results = two_lines();
  for (auto& row : results.records) row.key.scene.values["beta"] = 0.0;
  results.scenes.front().scene.values["beta"] = 0.0;
  results.scenes.front().discontinuities = {{"beta", "D^beta phi tends to phi - phi(0)"}};
  const auto of = section(data_of(written(results)), "scene-pendulum:beta=0");
  ASSERT_EQ(of["discontinuities"].size(), 1U);
  EXPECT_EQ(of["discontinuities"][0]["parameter"], "beta");
  EXPECT_EQ(of["discontinuities"][0]["limit"], "D^beta phi tends to phi - phi(0)");
}

TEST(Report, HasHowFarRatesDeviate) {
  const auto of = section(data_of(written(two_lines())), "rates");
  EXPECT_EQ(of["fits"], 4);
  EXPECT_EQ(of["deviating"], 2);
  for (const auto& row : of["groups"][0]["rows"]) {
    EXPECT_FALSE(row["end"].contains("above") || row["end"].contains("below"));
    EXPECT_NEAR(row["maximum"]["below"].get<double>(), 1.0, 1e-6);
  }
}

// In the second results adams_pc has twice the errors and a fifth of the time.
TEST(Report, SetsTwoResultsSideBySide) {
  Results now = empty_results();
  add_line(now, "l1", 1.5, 1e-6);
  add_line(now, "adams_pc", 2.0, 6e-7);
  for (Record& run : now.records) {
    for (const auto* error : {"error_end", "error_maximum"})
      if (run.key.scheme == "adams_pc") run.values.set(error, 2.0 * *run[error]);
  }
  const auto data = page_data(read_runs(now), read_runs(two_lines()));
  const auto compared = section(data, "compared");
  EXPECT_EQ(compared["common"], 8);
  EXPECT_EQ(compared["only_before"], 0);
  const auto& groups = compared["groups"];
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0]["change"], "errors");
  EXPECT_EQ(groups[0]["count"], 4);
  const auto& row = groups[0]["rows"][0];
  EXPECT_EQ(row["to"], "scene-pendulum");
  EXPECT_EQ(row["line"], "adams_pc");
  EXPECT_NEAR(row["factor"].get<double>(), 2.0, 1e-6);
  EXPECT_TRUE(row["worse"]);
  EXPECT_EQ(groups[1]["change"], "times");
  EXPECT_EQ(groups[1]["count"], 4);
  EXPECT_NEAR(groups[1]["rows"][0]["ratio"].get<double>(), 0.2, 1e-6);
  EXPECT_THAT(section_ids(page_data(read_runs(now))), Not(testing::Contains("compared")));
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
  const std::string charts = unpacked(page, "vega");
  for (const auto& text : {page, charts}) {
    EXPECT_FALSE(std::regex_search(text, std::regex(R"((src|href)\s*=\s*["']?(https?:)?//)")));
    EXPECT_FALSE(std::regex_search(text, std::regex(R"(@import|url\(\s*["']?http)")));
  }
  EXPECT_THAT(charts, HasSubstr("vegaEmbed"));
  EXPECT_THAT(page, HasSubstr("University of Washington Interactive Data Lab"));
}

TEST(Report, LeavesOneFileAndReplacesAnOlderOne) {
  const fs::path folder = fresh_folder() / "new" / "folder";
  const fs::path path = write_report(read_runs(empty_results()), folder);
  EXPECT_EQ(path, folder / "index.html");
  const auto before = fs::file_size(path);
  write_report(read_runs(two_lines()), folder);
  EXPECT_GT(fs::file_size(path), before);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
}

TEST(Report, NamesThePathThatCannotBeWritten) {
  const fs::path folder = fresh_folder(), file = folder / "a_file";
  fs::create_directories(folder);
  std::ofstream(file) << "x";
  EXPECT_THAT(
      message_of<std::invalid_argument>([&] { write_report(read_runs(two_lines()), file / "below"); }),
      HasSubstr((file / "below").string()));
}

}  // namespace
}  // namespace fde::bench
