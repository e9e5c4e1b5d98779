// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <system_error>

#include "fdebench/benchmarks/files/atomic_file.hpp"
#include "fdebench/benchmarks/requests/answers_json.hpp"
#include "fdebench/benchmarks/requests/solve.hpp"
#include "fdebench/benchmarks/text/output_text.hpp"
#include "fdebench/benchmarks/text/printable.hpp"
#include "fdebench/reports/command/command.hpp"
#include "fdebench/reports/command/progress_display.hpp"

namespace fde::bench {
namespace {

void print_rows(const SolvedTable& table, bool plain_names, std::ostream& out) {
  auto names = table.names;
  if (plain_names) std::ranges::transform(names, names.begin(), plain_name);
  out << fmt::format("{}{}t,{}\n", table.events ? "event," : "", table.solutions ? "solution," : "",
                     csv_names(names));
  for (std::size_t c = 0; c < table.times.size(); ++c) {
    if (table.events) out << (*table.events)[c] << ',';
    if (table.solutions) out << (*table.solutions)[c] << ',';
    out << fmt::format("{:.17g}", table.times[c]);
    for (const double value : table.values.col(static_cast<Eigen::Index>(c)))
      out << fmt::format(",{:.17g}", value);
    out << '\n';
  }
}

// Writes CSV, one row a time: t and all unknowns of the problem.
void write_field(const SolvedTable& table, const std::string& name) {
  AtomicFile file(name);
  std::string line = "t";
  for (Eigen::Index i = 1; i <= table.field.rows(); ++i) line += fmt::format(",u{}", i);
  for (Eigen::Index c = 0; c < table.field.cols(); ++c) {
    file.write(line + '\n');
    line = fmt::format("{:.17g},{:.17g}", table.times[static_cast<std::size_t>(c)],
                       fmt::join(Vec(table.field.col(c)), ","));
  }
  file.write(line + '\n');
  file.commit();
}

std::optional<std::vector<double>> find_numbers(const Given& given, std::string_view name) {
  return given.has(name) ? std::optional(given.numbers(name)) : std::nullopt;
}

// The file of --checkpoint, and how often it is written.
std::optional<CheckpointRequest> checkpoint_of(const Given& given) {
  const auto file = given.find("--checkpoint");
  if (!file && given.has("--checkpoint-every")) given.refuse("--checkpoint-every", "with --checkpoint");
  if (!file) return std::nullopt;
  return CheckpointRequest{*file, std::chrono::duration<double>(given.number("--checkpoint-every"))};
}

SolveRequest request_of(const Given& given) {
  const auto accuracy = given.find_number("--accuracy");
  SolveRequest request{.scheme = given.text("--scheme"), .settings = parse_run_settings(given)};
  request.settings.resolution = resolution_from(given.find_count("--steps"), accuracy);
  request.optimal_grading = given.text("--grid") == optimal_grid;
  request.times = output_times_from(find_numbers(given, "--at"), given.find_count("--every"),
                                    given.find_count("--points"));
  request.events = given.has("--events");
  request.all_solutions = given.has("--all");
  refuse_overwriting(given, "--field", {"scene"});
  request.field = given.has("--field");
  request.check = given.has("--check");
  request.threads = given.count("--threads");
  request.checkpoint = checkpoint_of(given);
  return request;
}

std::string quicker_text(const std::string& scheme, const QuickerScheme& found) {
  return fmt::format("{} has taken {} so far; {} --accuracy {:g} solves this in {}", scheme,
                     duration_text(found.seconds_of_run.count()), found.scheme, found.accuracy,
                     time_text(found.seconds.count()));
}

SolvedTable shown_while_solved(const Scene& scene, const Given& given, const Streams& streams) {
  ProgressLine line(streams, given.text("--scheme"));
  SolveListener listener;
  listener.complain = [&](const std::string& problem) {
    line.interrupt([&] { say(streams, Message::error, problem); });
  };
  if (streams.columns > 0 && !streams.quiet)
    listener.progress = [&](const Progress& progress) { line.set(progress); };
  const auto say_quicker = [&](const QuickerScheme& found) {
    line.interrupt([&] { say(streams, Message::note, quicker_text(given.text("--scheme"), found)); });
  };
  if (!streams.quiet) listener.quicker = say_quicker;
  // As progress lines: without a terminal a command says nothing beside its answer in its first minute.
  constexpr std::chrono::minutes without_terminal{1};
  if (streams.columns == 0) listener.long_run = without_terminal;
  try {
    return solve(scene, request_of(given), listener);
  } catch (const Refusal& refusal) {
    given.refuse(refusal);
  }
}

void print_solution(const Given& given, const Streams& streams, const SceneRegistry& known) {
  auto variant = read_variant(given, known);
  if (given.has("--until") && variant.until) given.refuse("--until", "without until= in the scene");
  if (const auto until = given.find_number("--until")) variant.until = until;
  const Scene scene = make_scene(variant);
  const SolvedTable table = shown_while_solved(scene, given, streams);
  const auto warning = warning_text(table.warnings);
  const bool fails = given.has("--strict") && !warning.empty();
  const auto field = given.find("--field");
  if (!fails && field) write_field(table, *field);
  if (!fails) print_rows(table, given.has("--plain-names"), streams.out);
  std::error_code ignored;
  if (!table.checkpoint.empty() && streams.out.flush()) std::filesystem::remove(table.checkpoint, ignored);
  if (fails) throw NumericalFailure("warning: " + warning);
  warn(streams, warning);
  if (!table.ended.empty()) say(streams, Message::note, table.ended);
  if (given.has("--cost")) streams.err << json_of(table.cost).dump() << '\n';
}

}  // namespace

Command solve_command() {
  return {
      {"solve",
       "Solve and choose",
       "Solve a scene with a scheme; CSV on standard output",
       joined({{scene_argument(),
                set_argument(),
                {"--scheme ID", "id of the scheme", Completion::scheme},
                {"(--steps N |", "number of steps over a grid", step_counts},
                {"--accuracy E)", "tolerance, relative and absolute, of schemes that choose their steps",
                 positive},
                until_argument(),
                {"[--at T1,T2,... |", "times to print, of the grid with --steps", not_negative, "all"},
                {"--every K |", "print each K-th grid time, and the last", step_counts},
                {"--points K]", "print K times from 0 to the end, of the grid with --steps", point_counts},
                {"[--events]", "with --accuracy: print the events of the scene in place of times"},
                {"[--all]",
                 "of a problem at both ends: print all solutions that a search from other starts finds"},
                {"[--field FILE]", "write a CSV of all unknowns at the times that are printed",
                 Completion::file}},
               run_settings_arguments("3600"),
               {{"[--threads T]",
                 "threads among which the unknowns of a step are divided where they are many; the result is "
                 "the same for any number",
                 thread_counts, fmt::format("{}", Options{}.threads)},
                {"[--checkpoint FILE]",
                 "keep the state of the run in a file: the same command goes on from it", Completion::file},
                {"[--checkpoint-every SECONDS]", "time between two states kept", not_negative, "300"},
                {"[--check]", "also warn where half the steps give another result"},
                {"[--strict]", "a warning is a failure: exit code 3, only its line is printed"},
                plain_names_argument(),
                {"[--cost]", "write a JSON line on standard error: time, calls, memory, rate"}}}),
       {{"fdebench solve pendulum --scheme bdf5 --steps 302",
         "prints the solution at all 303 times, from 0 to 20."},
        {"fdebench solve relaxation:gamma=0.5 --scheme l1 --steps 1000 --grid graded:auto --points 11",
         "grades the grid towards 0 and prints eleven of its times."}},
       {"choose", "exact", "schemes", "grids", "history"}},
      print_solution};
}

}  // namespace fde::bench
