// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/requests/recorded_sweep.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "fdebench/benchmarks/requests/own_scheme.hpp"
#include "fdebench/benchmarks/sweep/sweep.hpp"
#include "support/command_output.hpp"
#include "support/refusal_of.hpp"
#include "support/temporary_folder.hpp"

namespace fde::bench {
namespace {

// E_{1/2}(-t^{1/2}) = e^t erfc(t^{1/2}), which solves the relaxation.
Rows exact_values(const Problem& /*problem*/, const std::vector<double>& times) {
  Rows y(1, std::ssize(times));
  for (Eigen::Index c = 0; const double t : times) y(0, c++) = std::exp(t) * std::erfc(std::sqrt(t));
  return y;
}

const OwnScheme& mine() {
  static const OwnScheme scheme("mine", exact_values);
  return scheme;
}

// |y - reference| at the last time, which is error_end.
std::optional<double> distance(const std::vector<double>& /*times*/, const Rows& values,
                               const Rows& reference) {
  return std::abs(values(0, values.cols() - 1) - reference(0, reference.cols() - 1));
}

SweepRequest of_relaxation() {
  return {.scenes = {parse_variant("relaxation")},
          .schemes = {find_scheme("l1"), &mine().scheme()},
          .measures = {{"distance", distance}, {"never", [](auto&&...) { return std::nullopt; }}},
          .resolutions = {8, 16},
          .repeats = 1};
}

TEST(RecordedSweep, MeasuresASchemeOfTheCallerBesideOurs) {
  const auto runs = sweep(of_relaxation());
  ASSERT_EQ(runs.size(), 4U);
  for (const Record& run : runs) {
    EXPECT_TRUE(run.is_complete()) << run.key.scheme;
    EXPECT_EQ(run["distance"], run["error_end"]) << run.key.scheme;
    EXPECT_FALSE(run["never"]);
    EXPECT_EQ(*run["error_maximum"] < 1e-15, run.key.scheme == "mine");
  }
  EXPECT_EQ(std::ranges::count(runs, "mine", [](const Record& run) { return run.key.scheme; }), 2);
}

// The file has the runs of the first sweep: the second makes none, and the page shows the scheme and the
// measure.
TEST(RecordedSweep, ContinuesAFileThatThePageShows) {
  const TemporaryFolder folder;
  const auto file = folder.file("results.jsonl");
  int made = 0;
  const SweepListener listener{.on_run = [&](const Record&) { ++made; }};
  const auto first = sweep(of_relaxation(), file, listener), second = sweep(of_relaxation(), file, listener);
  EXPECT_EQ(made, 4);
  ASSERT_EQ(second.size(), first.size());
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(second[i].key, first[i].key);
    for (const auto& [quantity, value] : first[i].values) EXPECT_EQ(second[i][quantity], value) << quantity;
    for (const auto& [quantity, value] : first[i].timing.values)
      EXPECT_EQ(second[i][quantity], value) << quantity;
  }
  expect_success(fdebench({"report", file, "--out", folder.file("page")}));
  const auto page = content_of(folder.file("page/index.html"));
  EXPECT_THAT(page, testing::HasSubstr("mine"));
  const auto chosen = printed(fdebench(
      {"choose", "relaxation", "--error", "1e-10", "--results", file, "--norm", "end", "--scale", "mixed"}));
  EXPECT_THAT(chosen, testing::StartsWith("run: mine with N = ")) << "no command of ours repeats it";
}

TEST(RecordedSweep, EndsARunWhoseMeasureIsNoNumber) {
  auto request = of_relaxation();
  request.measures = {{"pole", [](auto&&...) { return std::numeric_limits<double>::infinity(); }}};
  for (const Record& run : sweep(request)) EXPECT_EQ(sentence(run.ending), "not finite in pole");
}

std::string refused(const std::function<void(SweepRequest&)>& change) {
  auto request = of_relaxation();
  change(request);
  return refusal_of([&] { sweeps_of(request); });
}

TEST(SweepRequests, NameTheFieldThatIsRefused) {
  EXPECT_EQ(refused([](auto&) {}), "");
  EXPECT_EQ(refused([](auto& of) { of.repeats = 0; }), "<repeat> = 0: must be a whole number from 1 to 1000");
  EXPECT_EQ(refused([](auto& of) { of.resolutions = {0}; }),
            "<steps> = 0: must be a whole number from 1 to 1000000000");
  EXPECT_EQ(refused([](auto& of) { of.budget = 0.0; }), "<budget> = 0: must be a finite number above 0");
  EXPECT_EQ(refused([](auto& of) { of.trials = true; }),
            "<trials> = yes: must be without <scene> and <steps>, trials have their own");
  EXPECT_EQ(refused([](auto& of) { of.thorough = true; }),
            "<thorough> = yes: must be without <steps> and <accuracy>, it has its own");
  EXPECT_EQ(refused([](auto& of) { of.examine = of.undisturbed = true; }),
            "<undisturbed> = yes: must be without <examine>, which times nothing");
  EXPECT_EQ(refused([](auto& of) {
              of.resolutions.clear();
              of.examine = true;
            }),
            "<examine> = yes: must be with numbers of steps or tolerances: otherwise times decide which runs "
            "are made");
  EXPECT_EQ(refused([](auto& of) {
              of.resolutions = {Tolerance{1e-3, 1e-3}};
              of.settings.grading = 2.0;
            }),
            "<grid> = graded:2: must be with <steps>: schemes that take <accuracy> choose their times");
}

TEST(SweepRequests, GiveSchemesAndMeasuresOfTheCallerIdsOfTheirOwn) {
  const OwnScheme taken("l1", exact_values);
  EXPECT_EQ(refused([&](auto& of) { of.schemes.push_back(&taken.scheme()); }),
            "<schemes> = l1: must be an id that prints and that no other scheme has");
  for (const std::string id : {"error_end", "time_median", "", "two words", "distance"}) {
    EXPECT_EQ(refused([&](auto& of) {
                of.measures.push_back({id, distance});
              }),
              "<measures> = " + id + ": must be a word of letters, digits and _ that no other measure has");
  }
}

}  // namespace
}  // namespace fde::bench
