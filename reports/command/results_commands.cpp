// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "fdebench/benchmarks/records/merge.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/reports/analysis/comparison.hpp"
#include "fdebench/reports/analysis/line_names.hpp"
#include "fdebench/reports/analysis/runs.hpp"
#include "fdebench/reports/command/command.hpp"
#include "fdebench/reports/command/command_line.hpp"
#include "fdebench/reports/command/progress_display.hpp"

namespace fde::bench {
namespace {

constexpr Range factors{.low = 1.0};

// "machine, compiler, commit" of each build, without repetitions.
std::set<std::string> builds_of(const std::vector<Session>& sessions) {
  std::set<std::string> builds;
  for (const Session& s : sessions)
    builds.insert(fmt::format("{}, {}, commit {}", s.machine, s.compiler, s.commit));
  return builds;
}

std::set<std::string> machines_of(const std::vector<Session>& sessions) {
  std::set<std::string> machines;
  for (const Session& session : sessions) machines.insert(session.machine);
  return machines;
}

// Empty if the file says of no timing that it was disturbed.
std::string disturbed_text(const std::string& file, const Runs& runs) {
  const auto disturbed =
      std::ranges::count_if(runs.finished, [](const Record& run) { return run.timing.is_disturbed(); });
  const auto timed =
      std::ranges::count_if(runs.finished, [](const Record& run) { return run["time_median"].has_value(); });
  return disturbed == 0 ? ""
                        : fmt::format("{}: other work disturbed {} of {} times\n", file, disturbed, timed);
}

struct CompareArguments {
  std::string first, second;
  std::optional<std::string> max_slowdown;
  bool require_all = false;
};

// The requested checks that the second file fails.
std::vector<std::string> complaints(const Comparison& comparison, const std::optional<double>& max_slowdown,
                                    bool require_all) {
  std::vector<std::string> all;
  if (comparison.is_worse()) all.emplace_back("an error grew or a verdict got worse");
  const auto slower = max_slowdown ? comparison.slower_than(*max_slowdown) : 0;
  if (slower > 0) all.push_back(fmt::format("{} times grew by more than {}", slower, *max_slowdown));
  if (require_all && !comparison.has_all()) {
    all.push_back(fmt::format("{} runs and {} times of the first are missing", comparison.only_before,
                              comparison.timed_before));
  }
  return all;
}

void compare_files(const CompareArguments& arguments, const Streams& streams) {
  const auto& [first, second, slowdown, require_all] = arguments;
  std::optional<double> most;
  if (slowdown) most = parse_number("--max-slowdown", *slowdown, factors);
  const auto read = [&](const std::string& file) {
    ProgressLine line(streams, "reads " + file);
    return read_runs(file);
  };
  const auto [sessions_before, before, warning_before] = read(first);
  const auto [sessions_now, now, warning_now] = read(second);
  warn(streams, warning_before);
  warn(streams, warning_now);
  const Comparison comparison = compare(before, now);
  if (comparison.common == 0)
    throw std::invalid_argument(fmt::format("{} and {}: have no run in common", first, second));
  streams.out << fmt::format("first:  {}: {}\nsecond: {}: {}\n", first,
                             fmt::join(builds_of(sessions_before), "; "), second,
                             fmt::join(builds_of(sessions_now), "; "));
  if (machines_of(sessions_before) != machines_of(sessions_now))
    streams.out << "times are of different machines: they say nothing of the programs\n";
  streams.out << disturbed_text(first, before) << disturbed_text(second, now);
  streams.out << comparison_text(comparison, LineNames(now));
  const auto worse = complaints(comparison, most, require_all);
  if (!worse.empty()) throw WorseResults(fmt::format("{}: {}", second, fmt::join(worse, "; ")));
}

void merge_files(const std::vector<std::string>& files, const std::string& out, const Streams& streams) {
  const auto merged = [&] {
    ProgressLine line(streams, fmt::format("merges {} files", files.size()));
    return merge_results({files.begin(), files.end()}, out);
  }();
  for (const auto& warning : merged.warnings) warn(streams, warning);
  streams.out << fmt::format("{}\n{} sessions, {} rows, {} repeated rows left out\n",
                             std::filesystem::absolute(out).string(), merged.sessions, merged.rows,
                             merged.repeated_rows);
}

}  // namespace

void add_results_commands(CommandLine& program, const Streams& streams, const SceneRegistry& /*known*/) {
  auto compared = std::make_shared<CompareArguments>();
  Subcommand compare_command(program, "compare", "Print what is worse or better in the second results file");
  compare_command.group("Measure");
  compare_command.required("first", compared->first, "results file, before")
      .completed_by(Completion::results);
  compare_command.required("second", compared->second, "results file, now").completed_by(Completion::results);
  compare_command
      .option("--max-slowdown", compared->max_slowdown,
              "how many times as long a run may take; beyond it the exit code is 1")
      .takes("FACTOR", factors);
  compare_command.flag("--require-all", compared->require_all,
                       "exit code 1 where runs or times of the first are not in the second");
  compare_command.example("fdebench compare old.jsonl new.jsonl",
                          "prints what changed; exit code 1 if an error grew.");
  compare_command.example("fdebench compare old.jsonl new.jsonl --max-slowdown 1.2 --require-all",
                          "also fails where a run is slower by a fifth, or missing.");
  compare_command.see_also({"run", "report", "exit-codes"});
  compare_command.callback([=, &streams] { compare_files(*compared, streams); });

  auto files = std::make_shared<std::vector<std::string>>();
  auto out = std::make_shared<std::string>();
  Subcommand merge_command(program, "merge", "Put results files together; sessions stay apart");
  merge_command.group("Measure");
  merge_command.list("files", *files, "results files").takes("FILE").completed_by(Completion::results);
  merge_command.required("--out", *out, "the new results file")
      .takes("NEW")
      .completed_by(Completion::results);
  merge_command.example("fdebench merge first.jsonl second.jsonl --out both.jsonl",
                        "writes one file from two.");
  merge_command.example("fdebench merge shard-*.jsonl --out sweep.jsonl",
                        "puts the parts of a sweep together that run --shard measured.");
  merge_command.see_also({"run", "compare"});
  merge_command.callback([=, &streams] {
    if (files->empty()) throw std::invalid_argument("files is required");
    merge_files(*files, *out, streams);
  });
}

}  // namespace fde::bench
