// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/external/external_program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <utility>
#include <variant>

#include "fdebench/benchmarks/external/process_cleanup.hpp"
#include "fdebench/benchmarks/external/shell_command.hpp"
#include "fdebench/benchmarks/external/task_text.hpp"
#include "fdebench/benchmarks/measures/timing_conditions.hpp"
#include "fdebench/benchmarks/observers/comparison_steps.hpp"
#include "fdebench/benchmarks/records/external_trajectory.hpp"
#include "fdebench/benchmarks/records/record_validation.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"

namespace fde::bench {
namespace {

constexpr std::uint64_t most_bytes = std::uint64_t{1} << 28;
constexpr int does_not_take = 77;  // exit code of a program that refuses the scene

// Replaces bytes that are not printable ASCII: the output of a program becomes part of a message.
std::string printable(std::string_view text) {
  constexpr std::size_t most = 200;
  std::string shown;
  for (const char c : text.substr(0, most)) shown += c < ' ' || c > '~' ? '?' : c;
  return shown;
}

// The last line of a file that is not blank, among its last 4096 bytes.
std::string last_line(const std::filesystem::path& file) {
  constexpr std::streamoff most = 4096;
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  stream.seekg(std::max<std::streamoff>(0, stream.tellg() - most));
  std::string line, last;
  while (std::getline(stream, line)) {
    if (line.find_first_not_of(" \t\r") != std::string::npos) last = line;
  }
  return printable(last);
}

std::string with(std::string reason, const std::string& said) {
  return said.empty() ? std::move(reason) : fmt::format("{}: {}", reason, said);
}

// nullopt: exit code 0.
std::optional<RunOutcome> failure_of(const CommandResult& end, const std::string& said, double budget) {
  switch (end.status) {
    case CommandResult::Status::out_of_time:
      return RunOutcome{SolveStatus::out_of_budget, fmt::format("after {:g} s", budget)};
    case CommandResult::Status::too_much_output:
      return RunOutcome{Verdict::program_failed, fmt::format("it wrote more than {} bytes", most_bytes)};
    case CommandResult::Status::killed: {
      const char* known = sigdescr_np(end.code);
      const std::string name = known != nullptr ? known : "unknown";
      // The shell prints the name of the signal too: no need to say it twice.
      return RunOutcome{Verdict::program_failed, with(fmt::format("ended by signal {} ({})", end.code, name),
                                                      said.starts_with(name) ? "" : said)};
    }
    case CommandResult::Status::exited:
      break;
  }
  if (end.code == does_not_take)
    return RunOutcome{SolveStatus::refused, said.empty() ? fmt::format("exit code {}", end.code) : said};
  if (end.code != 0)
    return RunOutcome{Verdict::program_failed, with(fmt::format("exit code {}", end.code), said)};
  return std::nullopt;
}

// The rows at these times, matched to a relative 1e-12. Throws std::invalid_argument if one is missing.
ExternalTrajectory at_times(const ExternalTrajectory& path, const std::vector<double>& times) {
  constexpr double rounding = 1e-12;
  std::vector<Eigen::Index> rows;
  for (const double t : times) {
    const auto found = std::ranges::lower_bound(path.times, t * (1.0 - rounding));
    if (found == path.times.end() || *found > t * (1.0 + rounding))
      throw std::invalid_argument(fmt::format("standard output: has no row at t = {}", t));
    rows.push_back(found - path.times.begin());
  }
  return {.columns = path.columns,
          .times = times,
          .values = path.values(Eigen::all, rows),
          .report = path.report};
}

// The rows that are judged: those of the program's own times, the end included, or those at `times`. Throws
// std::invalid_argument if one is missing.
ExternalTrajectory judged_rows(const ExternalTrajectory& path, const std::vector<double>& times) {
  if (!path.report.chooses_times) return at_times(path, times);
  at_times(path, {times.back()});
  return at_comparison_times(path);
}

// One run of a program.
struct ProgramRun {
  std::optional<RunOutcome> failure{};
  ExternalTrajectory path{};  // the judged rows; all printed rows if a value is not finite
  double wall_seconds = 0.0;
};

ProgramRun run(const SceneVariant& variant, const Scene& scene, const ExternalProgram& program,
               const RunSettings& settings, TaskPurpose purpose) {
  const Grid grid{
      .end = scene.problem.end, .steps = std::get<int>(settings.resolution), .grading = settings.grading};
  const auto times = comparison_times(grid);
  const TemporaryFile task(".json"), out(".csv"), err(".txt");
  task.write(task_json(variant, scene, settings, times, purpose));
  const auto failed = [&](const RunOutcome& reason) {
    return ProgramRun{.failure = reason, .path = {.report = read_report(out.path())}};
  };
  CommandResult end;
  try {
    end = run_command(program.command, task.path().string(), out.descriptor(), err.descriptor(),
                      {settings.budget, most_bytes});
  } catch (const std::system_error& error) {
    return failed({Verdict::program_failed, fmt::format("it cannot be started: {}", error.what())});
  }
  if (const auto failure = failure_of(end, last_line(err.path()), settings.budget)) return failed(*failure);
  try {
    auto path = read_trajectory(out.path(), scene, "standard output");
    if (path.values.allFinite()) path = judged_rows(path, times);
    return {.path = std::move(path), .wall_seconds = end.seconds};
  } catch (const std::invalid_argument& error) {
    return failed({Verdict::program_failed, printable(error.what())});
  }
}

Record assessed(const Record& run, const ProgramRun& made, const Assessment& judgement) {
  Record found = assessed(run, judgement);
  found.program = made.path.report.facts;
  return found;
}

const std::vector<double>& seconds_of(const ProgramRun& made) { return made.path.report.seconds; }

TimedSolves process_times(const std::vector<ProgramRun>& runs) {
  TimedSolves timed;
  for (const auto& made : runs) timed.seconds.push_back(made.wall_seconds);
  return timed;
}

// The solves of all processes. Of the process with the shortest first solve: by how much that takes longer
// than the later ones, and what the process takes besides its solves.
TimedSolves solve_times(const std::vector<ProgramRun>& runs) {
  TimedSolves timed;
  for (const auto& made : runs)
    timed.seconds.insert(timed.seconds.end(), seconds_of(made).begin(), seconds_of(made).end());
  const auto& quickest = *std::ranges::min_element(runs, {}, [](const ProgramRun& made) {
    return made.path.report.first.value_or(std::numeric_limits<double>::infinity());
  });
  if (const auto first = quickest.path.report.first) {
    const auto& later = seconds_of(quickest);
    timed.setup_seconds = *first - spread_of(timed.seconds).median;
    const double solves = std::accumulate(later.begin(), later.end(), *first);
    timed.start_seconds = std::max(0.0, quickest.wall_seconds - solves);
  }
  return timed;
}

}  // namespace

ExternalProgram parse_external(std::string_view text) {
  const auto equals = text.find('=');
  const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\n'; };
  if (equals == std::string_view::npos || std::ranges::all_of(text.substr(equals + 1), is_blank))
    reject_text("external", text, "NAME=COMMAND, a name and a command of the shell");
  const auto name = text.substr(0, equals);
  require_external_name("external", name);
  return {std::string(name), std::string(text.substr(equals + 1))};
}

RunKey key_of(const ExternalProgram& program, const SceneSettings& scene, const RunSettings& settings) {
  return {.scene = scene,
          .scheme = program.name,
          .settings = {.resolution = settings.resolution, .grading = settings.grading},
          .external = true};
}

Record examine(const SceneVariant& variant, const Scene& scene, MemoizedReference& reference,
               const ExternalProgram& program, const RunSettings& settings) {
  const auto made = run(variant, scene, program, settings, TaskPurpose::errors);
  return assessed({.key = key_of(program, variant.key(), settings),
                   .steps = std::get<int>(settings.resolution),
                   .end = scene.problem.end},
                  made,
                  made.failure ? Assessment{*made.failure} : judge_trajectory(scene, made.path, reference));
}

void time_runs(Record& examined, const SceneVariant& variant, const Scene& scene,
               const ExternalProgram& program, const RunSettings& settings, int most, double enough_seconds) {
  std::vector<ProgramRun> runs;
  double total = 0.0;
  while (std::ssize(runs) < most && (runs.empty() || total < enough_seconds)) {
    runs.push_back(run(variant, scene, program, settings, TaskPurpose::times));
    if (runs.back().failure) {
      examined = assessed(examined, runs.back(), {*runs.back().failure});
      return;
    }
    total += runs.back().wall_seconds;
  }
  const bool is_wall_clock = std::ranges::any_of(runs, [](const auto& of) { return seconds_of(of).empty(); });
  Timing timing = timing_of(is_wall_clock ? process_times(runs) : solve_times(runs));
  timing.wall_clock = is_wall_clock;
  examined.take(std::move(timing));
}

}  // namespace fde::bench
