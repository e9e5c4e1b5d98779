// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "fdebench/benchmarks/study/study_plan.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/reports/command/command.hpp"
#include "fdebench/reports/command/command_line.hpp"
#include "fdebench/reports/command/progress_display.hpp"
#include "fdebench/reports/command/requested_sweep.hpp"

namespace fde::bench {
namespace {

constexpr CountRange shard_counts{1, 9999};

struct StudyArguments {
  std::string action, file;
  std::optional<std::string> shards, seconds, out;
};

Forecast forecast_in_one_thread(std::vector<Sweep> sweeps, const Streams& streams) {
  ProgressLine line(streams, "solves some scenes to forecast the times");
  Forecast expected;
  for (auto& sweep : sweeps) {
    sweep.threads = 1;
    expected.merge(forecast(sweep, [](const RunKey&) { return std::optional<Record>(); }));
  }
  return expected;
}

// Read before the forecast, which takes long.
struct Division {
  explicit Division(const StudyArguments& arguments) {
    if (arguments.shards) shards = parse_count("--shards", *arguments.shards, shard_counts);
    if (arguments.seconds) seconds = parse_number("--seconds", *arguments.seconds, positive);
  }
  int shards = 1;
  std::optional<double> seconds{};
};

int shard_count(const StudyArguments& arguments, const Division& wanted, const PlannedWork& work) {
  if (!wanted.seconds) return wanted.shards;
  const double count = std::ceil(work.seconds.total() / *wanted.seconds);
  if (count > shard_counts.highest) {
    reject_text("--seconds", *arguments.seconds,
                fmt::format("at least {:.3g}: the study would have more than {} shards",
                            work.seconds.total() / shard_counts.highest, shard_counts.highest));
  }
  return std::max(1, static_cast<int>(count));
}

std::string size_text(double bytes) {
  constexpr double mega = 1e6;
  return fmt::format("{:.1f} MB", bytes / mega);
}

void plan(const StudyArguments& arguments, const Streams& streams, const SceneRegistry& known) {
  if (arguments.action != "plan") reject_text("action", arguments.action, "plan");
  const Division wanted(arguments);
  const auto study = read_study(arguments.file, known);
  const auto sweeps = sweeps_of(study);
  const auto scenes = planned_scenes(forecast_in_one_thread(sweeps, streams));
  const auto work = sum_of(scenes);
  const auto shards = shards_of(study, scenes, shard_count(arguments, wanted, work));
  streams.out << fmt::format(
      "{}{} runs of {} scenes\n"
      "examinations: about {} in one thread\n"
      "timings:      about {}\n"
      "results:      about {}\n",
      count_is_exact(sweeps) ? "" : "about ", work.runs, work.scenes, duration_text(work.seconds.examination),
      duration_text(work.seconds.timing), size_text(work.bytes));
  if (shards.size() > 1 || arguments.shards || arguments.seconds) {
    const auto [least, most] =
        std::ranges::minmax(shards, {}, [](const auto& shard) { return shard.work.seconds.total(); });
    streams.out << fmt::format("shards:       {}, about {} to {} each\n", shards.size(),
                               duration_text(least.work.seconds.total()),
                               duration_text(most.work.seconds.total()));
  }
  if (!arguments.out) return;
  write_plan(study, shards, *arguments.out);
  streams.out << (std::filesystem::absolute(*arguments.out) / "plan.json").string() << '\n';
}

}  // namespace

void add_study_command(CommandLine& program, const Streams& streams, const SceneRegistry& known) {
  auto arguments = std::make_shared<StudyArguments>();
  Subcommand command(program, "study", "Print how long a study takes, and split it into shards");
  command.group("Measure");
  command.required("action", arguments->action, "what to do").takes("plan", Words{"plan"});
  command.required("file", arguments->file, "study file").completed_by(Completion::file);
  const auto shards = command
                          .option("--shards", arguments->shards,
                                  "number of parts that take about the same time; a scene is in one of them")
                          .takes("N", shard_counts)
                          .usual("1");
  const auto seconds = command.option("--seconds", arguments->seconds, "expected time of each part")
                           .takes("S", positive, "seconds");
  command.exclude(shards, seconds);
  command.option("--out", arguments->out, "folder for shard-0001.toml, ... and plan.json")
      .takes("DIR")
      .completed_by(Completion::folder);
  command.example("fdebench study plan study.toml", "prints the runs, the time and the size of the results.");
  command.example("fdebench study plan study.toml --seconds 600 --out shards",
                  "writes study files that take about ten minutes each; run --study measures each.");
  command.see_also({"run", "merge", "report"});
  command.callback([=, &streams, &known] { plan(*arguments, streams, known); });
}

}  // namespace fde::bench
