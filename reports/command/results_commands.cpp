// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <ostream>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "fdebench/benchmarks/records/merge.hpp"
#include "fdebench/reports/analysis/comparison.hpp"
#include "fdebench/reports/analysis/line_names.hpp"
#include "fdebench/reports/analysis/runs.hpp"
#include "fdebench/reports/command/command.hpp"
#include "fdebench/reports/command/progress_display.hpp"

namespace fde::bench {
namespace {

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

void compare_files(const Given& given, const Streams& streams, const SceneRegistry& /*known*/) {
  const auto first = given.text("first"), second = given.text("second");
  const auto most = given.find_number("--max-slowdown");
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
  const auto worse = complaints(comparison, most, given.has("--require-all"));
  if (!worse.empty()) throw WorseResults(fmt::format("{}: {}", second, fmt::join(worse, "; ")));
}

void merge_files(const Given& given, const Streams& streams, const SceneRegistry& /*known*/) {
  const auto& files = given.all("files");
  const auto out = given.text("--out");
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

Command compare_command() {
  return {{"compare",
           "Measure",
           "Print what is worse or better in the second results file",
           {{"FIRST", "results file, before", Completion::results},
            {"SECOND", "results file, now", Completion::results},
            {"[--max-slowdown FACTOR]", "how many times as long a run may take; beyond it the exit code is 1",
             Range{.low = 1.0}},
            {"[--require-all]", "exit code 1 where runs or times of the first are not in the second"}},
           {{"fdebench compare old.jsonl new.jsonl", "prints what changed; exit code 1 if an error grew."},
            {"fdebench compare old.jsonl new.jsonl --max-slowdown 1.2 --require-all",
             "also fails where a run is slower by a fifth, or missing."}},
           {"run", "report", "exit-codes"}},
          compare_files};
}

Command merge_command() {
  return {{"merge",
           "Measure",
           "Put results files together; sessions stay apart",
           {{"files:FILE...", "results files", Completion::results},
            {"--out NEW", "the new results file", Completion::results}},
           {{"fdebench merge first.jsonl second.jsonl --out both.jsonl", "writes one file from two."},
            {"fdebench merge shard-*.jsonl --out sweep.jsonl",
             "puts the parts of a sweep together that run --shard measured."}},
           {"run", "compare"}},
          merge_files};
}

}  // namespace fde::bench
