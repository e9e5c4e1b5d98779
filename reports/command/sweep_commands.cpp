// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/records/results_file.hpp"
#include "fdebench/benchmarks/requests/failure.hpp"
#include "fdebench/benchmarks/requests/recorded_sweep.hpp"
#include "fdebench/benchmarks/requests/sweep_request.hpp"
#include "fdebench/benchmarks/sweep/forecast.hpp"
#include "fdebench/benchmarks/sweep/sweep.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/benchmarks/text/output_text.hpp"
#include "fdebench/reports/analysis/runs.hpp"
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
    ++by_scheme_[run.key.scheme];
    if (++count_ == 1) {
      first_ = fmt::format("{} {} {}: {}", label_of(run.key.scene), run.key.scheme,
                           resolution_text(run.key.settings), run.ending.detail);
    }
  }

  [[nodiscard]] int count() const { return count_; }

  // "3 runs are refused, 2 of bdf2, 1 of l1; the first: relaxation l1 N = 64: ...".
  [[nodiscard]] std::string text() const {
    if (count_ == 1) return fmt::format("1 run is refused: {}", first_);
    std::vector<std::pair<int, std::string>> parts;
    for (const auto& [scheme, count] : by_scheme_) parts.emplace_back(count, scheme);
    std::ranges::stable_sort(parts, std::greater<>(), &std::pair<int, std::string>::first);
    constexpr std::size_t named = 4;
    std::string schemes;
    int others = count_;
    for (std::size_t i = 0; i < std::min(named, parts.size()); others -= parts[i++].first)
      schemes += fmt::format(", {} of {}", parts[i].first, parts[i].second);
    if (others > 0) schemes += fmt::format(", {} of others", others);
    return fmt::format("{} runs are refused{}; the first: {}", count_, schemes, first_);
  }

 private:
  int count_ = 0;
  std::map<std::string, int> by_scheme_{};
  std::string first_{};
};

void run_and_show(const std::vector<Sweep>& sweeps, const Streams& streams, ResultsFile& file) {
  const auto recorded = [&](const RunKey& key) { return file.recorded(key); };
  const Forecast expected = streams.quiet ? Forecast() : forecast_of(sweeps, recorded);
  SweepProgress progress(streams, expected, count_is_exact(sweeps));
  Refusals refusals;
  std::optional<NumericalFailure> failure;
  try {
    run_into(file, sweeps,
             {.on_event = [&](const SweepEvent& event) { progress.on_event(event); },
              .on_run = [&](const Record& run) { refusals.add(run); }});
  } catch (const NumericalFailure& unwritten) {
    failure = unwritten;
  }
  if (refusals.count() > 0) say(streams, Message::note, refusals.text());
  if (failure) throw NumericalFailure(*failure);
}

// Prints the remaining runs with their expected seconds, and the total.
void list_runs(const std::vector<Sweep>& sweeps, const std::optional<std::string>& out,
               const Streams& streams) {
  const auto recorded = out ? read_recorded(*out) : std::nullopt;
  if (recorded) warn(streams, recorded->warning());
  const auto expected =
      forecast_of(sweeps, [&](const RunKey& key) { return recorded ? recorded->find(key) : std::nullopt; });
  std::size_t refused = 0;
  for (const auto& [run, seconds] : expected) {
    refused += seconds.refusal.empty() ? 0 : 1;
    streams.out << fmt::format(
        "{} {} {}  {}\n", label_of(run.scene), run.scheme, resolution_text(run.settings),
        seconds.refusal.empty() ? time_text(seconds.total()) : fmt::format("refused: {}", seconds.refusal));
  }
  streams.out << fmt::format("{}{} runs, {}about {}\n", count_is_exact(sweeps) ? "" : "about ",
                             expected.size(),
                             refused == 0 ? "" : fmt::format("{} of them refused, ", refused),
                             duration_text(total_seconds(expected)));
}

void run(const Given& given, const Streams& streams, const SceneRegistry& known) {
  for (const auto* option :
       {"--scene", "--set", "--scheme", "--external", "--steps", "--accuracy", "--repeat", "--grid",
        "--history", "--tolerance", "--budget", "--thorough", "--trials"})
    if (given.has("--study") && given.has(option)) given.refuse(fmt::format("{} excludes --study", option));
  const auto sweeps = sweeps_of(given, known);
  const auto out = given.find("--out");
  if (given.has("--dry-run")) return list_runs(sweeps, out, streams);
  if (!out) throw std::invalid_argument("--out is required");
  ResultsFile file(*out);
  warn(streams, file.warning());
  const SignalCleanup words(
      streams.quiet
          ? ""
          : fmt::format("{}fdebench: stopped; the same command continues, what is measured is kept\n",
                        streams.columns > 0 ? "\n" : ""));
  run_and_show(sweeps, streams, file);
  streams.out << std::filesystem::absolute(*out).string() << '\n';
}

void report(const Given& given, const Streams& streams, const SceneRegistry& /*known*/) {
  const bool first_runs = requests_first_run(given);
  const auto read = [&](const std::string& from) {
    auto of_file = read_runs(from);
    warn(streams, of_file.warning);
    if (first_runs) count_first_runs(of_file.runs);
    return of_file;
  };
  auto first = read(given.text("file"));
  const auto second = given.find("second"), folder = given.find("--out");
  const auto path = [&] {
    ProgressLine line(streams, "writes the page");
    return second ? write_report(read(*second), *folder, std::move(first))
                  : write_report(std::move(first), *folder);
  }();
  streams.out << path.string() << '\n';
}

}  // namespace

Command run_command() {
  return {
      {"run",
       "Measure",
       "Measure schemes on scenes; a file that exists is continued",
       joined({{{"[--scene SCENE]...", "id of a scene or an equation file, or ID:NAME=VALUE,...",
                 Completion::scene, "all"},
                {"[--set NAME=VALUE]...", "a parameter of all these scenes, a value or FIRST:LAST:STEP",
                 Completion::setting},
                {"[--scheme ID]...", "id of a scheme", Completion::scheme, "all"},
                {"[--external NAME=COMMAND]...",
                 "another program to measure; then of the schemes here only those of --scheme"},
                {"[--steps N1,N2,...]", "numbers of steps; without them the cheapest runs are searched",
                 step_counts},
                {"[--accuracy E1,E2,...]", "tolerances of schemes that choose their steps", positive},
                {"[--repeat R]", "how often each run is timed", repeat_counts, "3"}},
               run_settings_arguments(budget_of_sweeps_text()),
               {{"[--thorough]", "all numbers of steps, all tolerances and all trials"},
                {"[--trials]", "only the stiff and extreme trials of the report"},
                {"[--study FILE]", "study file: its scenes, schemes and settings; without the options above",
                 Completion::file},
                {"[--shard I/N]", "every N-th scene, from the I-th on"},
                {"[--examine]", "everything but the times, which the same command without it adds"},
                {"[--undisturbed]", "repeat the times that other work disturbed, also those of the file"},
                {"[--dry-run]", "list the runs and how long they take, and do nothing"},
                {"[--out FILE]", "results file; needed without --dry-run", Completion::results}}}),
       {{"fdebench run --out results.jsonl", "measures all schemes on all scenes; this takes minutes."},
        {"fdebench run --scene pendulum --scheme l1 --scheme bdf4 --steps 64,256,1024 --out few.jsonl",
         "measures six runs."},
        {"fdebench run --study study.toml --out study.jsonl", "measures the runs that a file describes."}},
       {"study", "report", "choose", "plot", "judge", "accuracy"}},
      run};
}

Command report_command() {
  return {{"report",
           "Measure",
           "Write the report page of a results file, or of what changed in a second",
           {{"FILE", "results file", Completion::results},
            {"[SECOND]", "results file, now: the page is of it, set against the first", Completion::results},
            {"--out DIR", "folder of the page", Completion::folder},
            runs_argument()},
           {{"fdebench report results.jsonl --out page", "writes page/index.html."},
            {"fdebench report old.jsonl new.jsonl --out page",
             "writes the page of the second file with what changed since the first."}},
           {"run", "compare", "plot"}},
          report};
}

}  // namespace fde::bench
