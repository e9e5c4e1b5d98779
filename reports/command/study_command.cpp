// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "fdebench/benchmarks/study/study.hpp"
#include "fdebench/benchmarks/study/study_plan.hpp"
#include "fdebench/reports/command/command.hpp"
#include "fdebench/reports/command/progress_display.hpp"
#include "fdebench/reports/command/requested_sweep.hpp"

namespace fde::bench {
namespace {

constexpr CountRange shard_counts{1, 9999};

Forecast forecast_in_one_thread(std::vector<Sweep> sweeps, const Streams& streams) {
  ProgressLine line(streams, "solves some scenes to forecast the times");
  Forecast expected;
  for (auto& sweep : sweeps) {
    sweep.threads = 1;
    expected.merge(forecast(sweep, [](const RunKey&) { return std::optional<Record>(); }));
  }
  return expected;
}

int shard_count(const Given& given, const PlannedWork& work) {
  const auto seconds = given.find_number("--seconds");
  if (!seconds) return given.count("--shards");
  const double count = std::ceil(work.seconds.total() / *seconds);
  if (count > shard_counts.highest) {
    given.refuse("--seconds", fmt::format("at least {:.3g}: the study would have more than {} shards",
                                          work.seconds.total() / shard_counts.highest, shard_counts.highest));
  }
  return std::max(1, static_cast<int>(count));
}

std::string size_text(double bytes) {
  constexpr double mega = 1e6;
  return fmt::format("{:.1f} MB", bytes / mega);
}

void plan(const Given& given, const Streams& streams, const SceneRegistry& known) {
  static_cast<void>(given.word("action"));
  // What is wrong is refused before the forecast, which takes long.
  static_cast<void>(given.count("--shards") + given.find_number("--seconds").value_or(0.0));
  const auto study = read_study(given.text("file"), known);
  const auto sweeps = sweeps_of(study);
  const auto scenes = planned_scenes(forecast_in_one_thread(sweeps, streams));
  const auto work = sum_of(scenes);
  const auto shards = shards_of(study, scenes, shard_count(given, work));
  streams.out << fmt::format(
      "{}{} runs of {} scenes\n"
      "examinations: about {} in one thread\n"
      "timings:      about {}\n"
      "results:      about {}\n",
      count_is_exact(sweeps) ? "" : "about ", work.runs, work.scenes, duration_text(work.seconds.examination),
      duration_text(work.seconds.timing), size_text(work.bytes));
  if (shards.size() > 1 || given.has("--shards") || given.has("--seconds")) {
    const auto [least, most] =
        std::ranges::minmax(shards, {}, [](const auto& shard) { return shard.work.seconds.total(); });
    streams.out << fmt::format("shards:       {}, about {} to {} each\n", shards.size(),
                               duration_text(least.work.seconds.total()),
                               duration_text(most.work.seconds.total()));
  }
  const auto out = given.find("--out");
  if (!out) return;
  write_plan(study, shards, *out);
  streams.out << (std::filesystem::absolute(*out) / "plan.json").string() << '\n';
}

}  // namespace

Command study_command() {
  return {{"study",
           "Measure",
           "Print how long a study takes, and split it into shards",
           {{"action:plan", "what to do", Words{"plan"}},
            {"FILE", "study file", Completion::file},
            {"[--shards N |", "number of parts that take about the same time; a scene is in one of them",
             shard_counts, "1"},
            {"--seconds S]", "expected time of each part", positive},
            {"[--out DIR]", "folder for shard-0001.toml, ... and plan.json", Completion::folder}},
           {{"fdebench study plan study.toml", "prints the runs, the time and the size of the results."},
            {"fdebench study plan study.toml --seconds 600 --out shards",
             "writes study files that take about ten minutes each; run --study measures each."}},
           {"run", "merge", "report"}},
          plan};
}

}  // namespace fde::bench
