// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <ostream>
#include <system_error>

#include "fdebench/benchmarks/files/atomic_file.hpp"
#include "fdebench/benchmarks/text/printable.hpp"
#include "fdebench/reports/command/command.hpp"
#include "fdebench/reports/command/progress_display.hpp"
#include "fdebench/reports/command/solved_table.hpp"

namespace fde::bench {
namespace {

void print_rows(const SolvedTable& table, std::ostream& out) {
  out << fmt::format("{}{}t,{}\n", table.events ? "event," : "", table.solutions ? "solution," : "",
                     csv_names(table.names));
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

SolvedTable shown_while_solved(const Scene& scene, const Given& given, const Streams& streams) {
  ProgressLine line(streams, given.text("--scheme"));
  const auto complain = [&](const std::string& problem) {
    line.interrupt([&] { say(streams, Message::error, problem); });
  };
  if (streams.columns == 0 || streams.quiet) return solved_table(scene, given, complain);
  return solved_table(scene, given, complain, [&](const Progress& progress) { line.set(progress); });
}

void solve(const Given& given, const Streams& streams, const SceneRegistry& known) {
  auto variant = read_variant(given, known);
  if (given.has("--until") && variant.until) given.refuse("--until", "without until= in the scene");
  if (const auto until = given.find_number("--until")) variant.until = until;
  const Scene scene = make_scene(variant);
  const SolvedTable table = shown_while_solved(scene, given, streams);
  const bool fails = given.has("--strict") && !table.warning.empty();
  const auto field = given.find("--field");
  if (!fails && field) write_field(table, *field);
  if (!fails) print_rows(table, streams.out);
  std::error_code ignored;
  if (!table.checkpoint.empty() && streams.out.flush()) std::filesystem::remove(table.checkpoint, ignored);
  if (fails) throw NumericalFailure("warning: " + table.warning);
  warn(streams, table.warning);
  if (!table.ended.empty()) say(streams, Message::note, table.ended);
  if (given.has("--cost")) streams.err << table.cost << '\n';
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
                {"--points K]", "print K times from 0 to the end, of the grid with --steps",
                 CountRange{2, most_rows}},
                {"[--events]", "with --accuracy: print the events of the scene in place of times"},
                {"[--all]",
                 "of a problem at both ends: print all solutions that a search from other starts finds"},
                {"[--field FILE]", "write a CSV of all unknowns at the times that are printed",
                 Completion::file}},
               run_settings_arguments("3600"),
               {{"[--threads T]",
                 "threads among which the unknowns of a step are divided where they are many; the result is "
                 "the same for any number",
                 CountRange{1, 1024}, fmt::format("{}", Options{}.threads)},
                {"[--checkpoint FILE]",
                 "keep the state of the run in a file: the same command goes on from it", Completion::file},
                {"[--checkpoint-every SECONDS]", "time between two states kept", not_negative, "300"},
                {"[--check]", "also warn where half the steps give another result"},
                {"[--strict]", "a warning is a failure: exit code 3, only its line is printed"},
                {"[--cost]", "write a JSON line on standard error: time, calls, memory, rate"}}}),
       {{"fdebench solve pendulum --scheme bdf5 --steps 302",
         "prints the solution at all 303 times, from 0 to 20."},
        {"fdebench solve relaxation:gamma=0.5 --scheme l1 --steps 1000 --grid graded:auto --points 11",
         "grades the grid towards 0 and prints eleven of its times."}},
       {"choose", "exact", "schemes", "grids", "history"}},
      solve};
}

}  // namespace fde::bench
