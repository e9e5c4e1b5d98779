// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <utility>

#include "fdebench/benchmarks/records/results_file.hpp"
#include "fdebench/benchmarks/sweep/forecast.hpp"
#include "fdebench/benchmarks/sweep/sweep.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/reports/analysis/runs.hpp"
#include "fdebench/reports/analysis/text.hpp"
#include "fdebench/reports/command/arguments.hpp"
#include "fdebench/reports/command/command.hpp"
#include "fdebench/reports/command/progress_display.hpp"
#include "fdebench/reports/command/requested_sweep.hpp"
#include "fdebench/reports/command/signal_cleanup.hpp"
#include "fdebench/reports/page/report.hpp"

namespace fde::bench {
namespace {

Forecast forecast_of(const std::vector<Sweep>& sweeps, const RecordedLookup& recorded) {
  Forecast expected;
  for (const auto& sweep : sweeps) expected.merge(forecast(sweep, recorded));
  return expected;
}

// The refused runs of a sweep.
class Refusals {
 public:
  void add(const Record& run) {
    if (run.ending.kind != SolveStatus::refused) return;
    if (++count_ == 1) {
      first_ = fmt::format("{} {} {}: {}", label_of(run.key.scene), run.key.scheme,
                           resolution_text(run.key.setup), run.ending.detail);
    }
  }

  [[nodiscard]] int count() const { return count_; }

  // "3 runs are refused, the first: relaxation l1 N = 64: ...".
  [[nodiscard]] std::string text() const {
    return count_ == 1 ? fmt::format("1 run is refused: {}", first_)
                       : fmt::format("{} runs are refused, the first: {}", count_, first_);
  }

 private:
  int count_ = 0;
  std::string first_{};
};

void run_and_show(const std::vector<Sweep>& sweeps, const Streams& streams, ResultsFile& file) {
  const auto recorded = [&](const RunKey& key) { return file.recorded(key); };
  const Forecast expected = forecast_of(sweeps, recorded);
  SweepProgress progress(streams, expected, count_is_exact(sweeps));
  std::string unwritten;  // the first line that could not be read back; the sweep goes on without it
  Refusals refusals;
  const auto write = [&](const auto& append) {
    try {
      append();
    } catch (const UnreadableLine& reason) {
      if (unwritten.empty()) unwritten = reason.what();
    }
  };
  const SweepCallbacks hooks{
      .recorded = recorded,
      .append =
          [&](const Record& run) {
            refusals.add(run);
            write([&] { file.append(run); });
          },
      .append_times = [&](const Record& run) { write([&] { file.append_times(run); }); },
      .on_event = [&](const SweepEvent& event) { progress.on_event(event); },
      .describes = [&](const SceneSettings& scene) { return file.describes(scene); },
      .append_scene = [&](const SceneDescription& scene) { write([&] { file.append(scene); }); }};
  for (const auto& sweep : sweeps) run_sweep(sweep, hooks, expected);
  if (refusals.count() > 0) say(streams, Message::note, refusals.text());
  if (!unwritten.empty()) throw NumericalFailure(unwritten);
}

// Prints the remaining runs with their expected seconds, and the total.
void list_runs(const std::vector<Sweep>& sweeps, const SweepArguments& arguments, const Streams& streams) {
  const auto recorded = arguments.out ? read_recorded(*arguments.out) : ReadRecorded();
  warn(streams, recorded.warning);
  const auto expected =
      forecast_of(sweeps, [&](const RunKey& key) { return recorded_of(recorded.runs, key); });
  std::size_t refused = 0;
  for (const auto& [run, seconds] : expected) {
    refused += seconds.refusal.empty() ? 0 : 1;
    streams.out << fmt::format(
        "{} {} {}  {}\n", label_of(run.scene), run.scheme, resolution_text(run.setup),
        seconds.refusal.empty() ? time_text(seconds.total()) : fmt::format("refused: {}", seconds.refusal));
  }
  streams.out << fmt::format("{}{} runs, {}about {}\n", count_is_exact(sweeps) ? "" : "about ",
                             expected.size(),
                             refused == 0 ? "" : fmt::format("{} of them refused, ", refused),
                             duration_text(total_seconds(expected)));
}

void run(const SweepArguments& arguments, const Streams& streams, const SceneRegistry& known) {
  const auto sweeps = sweeps_of(arguments, known);
  if (arguments.dry_run) return list_runs(sweeps, arguments, streams);
  if (!arguments.out) throw std::invalid_argument("--out is required");
  ResultsFile file(*arguments.out);
  warn(streams, file.warning());
  const SignalCleanup words(
      streams.quiet
          ? ""
          : fmt::format("{}fdebench: stopped; the same command continues, what is measured is kept\n",
                        streams.columns > 0 ? "\n" : ""));
  run_and_show(sweeps, streams, file);
  streams.out << std::filesystem::absolute(*arguments.out).string() << '\n';
}

}  // namespace

void add_sweep_commands(CommandLine& program, const Streams& streams, const SceneRegistry& known) {
  auto of_run = std::make_shared<SweepArguments>();
  Subcommand run_command(program, "run", "Measure schemes on scenes; a file that exists is continued");
  run_command.group("Measure");
  const auto scene =
      run_command.list("--scene", of_run->scenes, "id of a scene or an equation file, or ID:NAME=VALUE,...")
          .takes("SCENE")
          .usual("all")
          .completed_by(Completion::scene);
  const auto set =
      run_command
          .list("--set", of_run->settings, "a parameter of all these scenes, a value or FIRST:LAST:STEP")
          .takes("NAME=VALUE")
          .completed_by(Completion::setting);
  const auto scheme = run_command.list("--scheme", of_run->schemes, "id of a scheme")
                          .takes("ID")
                          .usual("all")
                          .completed_by(Completion::scheme);
  const auto external =
      run_command
          .list("--external", of_run->externals,
                "another program to measure; then of the schemes here only those of --scheme")
          .takes("NAME=COMMAND");
  const auto steps =
      run_command
          .option("--steps", of_run->steps, "numbers of steps; without them the cheapest runs are searched")
          .takes("N1,N2,...", step_counts);
  const auto accuracy =
      run_command.option("--accuracy", of_run->accuracies, "tolerances of schemes that choose their steps")
          .takes("E1,E2,...", positive);
  const auto repeat = run_command.option("--repeat", of_run->repeats, "how often each run is timed")
                          .takes("R", repeat_counts)
                          .usual(of_run->repeats);
  const auto means = add_options(run_command, of_run->means);
  const auto thorough =
      run_command.flag("--thorough", of_run->thorough, "all numbers of steps, all tolerances and all trials");
  const auto trials =
      run_command.flag("--trials", of_run->trials, "only the stiff and extreme trials of the report");
  const auto study = run_command
                         .option("--study", of_run->study,
                                 "study file: its scenes, schemes and settings; without the options above")
                         .takes("FILE")
                         .completed_by(Completion::file);
  Subcommand::replaces(study, {scene, set, scheme, external, steps, accuracy, repeat, thorough, trials});
  Subcommand::replaces(study, means);
  run_command.option("--shard", of_run->shard, "every N-th scene, from the I-th on").takes("I/N");
  run_command.flag("--examine", of_run->examine,
                   "everything but the times, which the same command without it adds");
  run_command.flag("--undisturbed", of_run->undisturbed,
                   "repeat the times that other work disturbed, also those of the file");
  run_command.flag("--dry-run", of_run->dry_run, "list the runs and how long they take, and do nothing");
  run_command.option("--out", of_run->out, "results file; needed without --dry-run")
      .takes("FILE")
      .completed_by(Completion::results);
  run_command.example("fdebench run --out results.jsonl",
                      "measures all schemes on all scenes; this takes minutes.");
  run_command.example(
      "fdebench run --scene pendulum --scheme l1 --scheme bdf4 --steps 64,256,1024 --out few.jsonl",
      "measures six runs.");
  run_command.example("fdebench run --study study.toml --out study.jsonl",
                      "measures the runs that a file describes.");
  run_command.see_also({"study", "report", "choose", "plot", "judge", "accuracy"});
  run_command.callback([=, &streams, &known] { run(*of_run, streams, known); });

  auto file = std::make_shared<std::string>(), folder = std::make_shared<std::string>();
  auto second = std::make_shared<std::optional<std::string>>();
  Subcommand report_command(program, "report",
                            "Write the report page of a results file, or of what changed in a second");
  report_command.group("Measure");
  report_command.required("file", *file, "results file").completed_by(Completion::results);
  report_command.option("second", *second, "results file, now: the page is of it, set against the first")
      .completed_by(Completion::results);
  report_command.required("--out", *folder, "folder of the page")
      .takes("DIR")
      .completed_by(Completion::folder);
  auto runs = std::make_shared<std::string>(run_words().back());
  add_runs(report_command, *runs);
  report_command.example("fdebench report results.jsonl --out page", "writes page/index.html.");
  report_command.example("fdebench report old.jsonl new.jsonl --out page",
                         "writes the page of the second file with what changed since the first.");
  report_command.see_also({"run", "compare", "plot"});
  report_command.callback([=, &streams] {
    const bool first_runs = requests_first_run(*runs);
    const auto read = [&](const std::string& from) {
      auto of_file = read_runs(from);
      warn(streams, of_file.warning);
      if (first_runs) count_first_runs(of_file.runs);
      return of_file;
    };
    auto first = read(*file);
    const auto path = [&] {
      ProgressLine line(streams, "writes the page");
      return *second ? write_report(read(**second), *folder, std::move(first))
                     : write_report(std::move(first), *folder);
    }();
    streams.out << path.string() << '\n';
  });
}

}  // namespace fde::bench
