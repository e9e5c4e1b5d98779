// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>
#include <system_error>

#include "fdebench/benchmarks/files/atomic_file.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/benchmarks/text/printable.hpp"
#include "fdebench/reports/command/arguments.hpp"
#include "fdebench/reports/command/command.hpp"
#include "fdebench/reports/command/progress_display.hpp"
#include "fdebench/reports/command/solved_table.hpp"

namespace fde::bench {
namespace {

struct SolveArguments {
  SceneArguments scene;
  RunArguments run;
  std::optional<std::string> until;
  bool cost = false, strict = false;
};

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

SolvedTable shown_while_solved(const Scene& scene, const RunArguments& run, const Streams& streams) {
  ProgressLine line(streams, run.scheme);
  const auto complain = [&](const std::string& problem) {
    line.interrupt([&] { say(streams, Message::error, problem); });
  };
  if (streams.columns == 0 || streams.quiet) return solved_table(scene, run, complain);
  return solved_table(scene, run, complain, [&](const Progress& progress) { line.set(progress); });
}

void solve(const SolveArguments& arguments, const Streams& streams, const SceneRegistry& known) {
  auto variant = read_variant(arguments.scene, known);
  if (arguments.until && variant.until)
    reject_text("--until", *arguments.until, "without until= in the scene");
  if (arguments.until) variant.until = parse_number("--until", *arguments.until, valid_end_times);
  const Scene scene = make_scene(variant);
  const SolvedTable table = shown_while_solved(scene, arguments.run, streams);
  const bool fails = arguments.strict && !table.warning.empty();
  if (!fails && arguments.run.field) write_field(table, *arguments.run.field);
  if (!fails) print_rows(table, streams.out);
  std::error_code ignored;
  if (!table.checkpoint.empty() && streams.out.flush()) std::filesystem::remove(table.checkpoint, ignored);
  if (fails) throw NumericalFailure(table.warning);
  if (!table.warning.empty()) say(streams, Message::warning, table.warning);
  if (!table.ended.empty()) say(streams, Message::note, table.ended);
  if (arguments.cost) streams.err << table.cost << '\n';
}

}  // namespace

void add_solve_command(CommandLine& program, const Streams& streams, const SceneRegistry& known) {
  auto arguments = std::make_shared<SolveArguments>();
  Subcommand command(program, "solve", "Solve a scene with a scheme; CSV on standard output");
  command.group("Solve and choose");
  add_scene(command, arguments->scene);
  command.required("--scheme", arguments->run.scheme, "id of the scheme")
      .takes("ID")
      .completed_by(Completion::scheme);
  const auto steps =
      command.option("--steps", arguments->run.steps, "number of steps over a grid").takes("N", step_counts);
  const auto accuracy = command
                            .option("--accuracy", arguments->run.accuracy,
                                    "tolerance, relative and absolute, of schemes that choose their steps")
                            .takes("E", positive);
  command.exclude(accuracy, steps, true);
  add_until(command, arguments->until);
  const auto at = command.option("--at", arguments->run.at, "times to print, of the grid with --steps")
                      .takes("T1,T2,...", not_negative)
                      .usual("all");
  const auto every =
      command.option("--every", arguments->run.every, "print each K-th grid time, and the last")
          .takes("K", step_counts);
  const auto points = command
                          .option("--points", arguments->run.points,
                                  "print K times from 0 to the end, of the grid with --steps")
                          .takes("K", point_counts);
  command.flag("--events", arguments->run.events,
               "with --accuracy: print the events of the scene in place of times");
  command.flag("--all", arguments->run.all,
               "of a problem at both ends: print all solutions that a search from other starts finds");
  command.exclude(every, at);
  command.exclude(points, at);
  command.exclude(points, every);
  command.option("--field", arguments->run.field, "write a CSV of all unknowns at the times that are printed")
      .takes("FILE")
      .completed_by(Completion::file);
  add_options(command, arguments->run.settings);
  command
      .option("--threads", arguments->run.threads,
              "threads among which the unknowns of a step are divided where they are many; the result is the "
              "same for any number")
      .takes("T", thread_counts)
      .usual(fmt::format("{}", Options{}.threads));
  command
      .option("--checkpoint", arguments->run.checkpoint,
              "keep the state of the run in a file: the same command goes on from it")
      .takes("FILE")
      .completed_by(Completion::file);
  command.option("--checkpoint-every", arguments->run.checkpoint_every, "time between two states kept")
      .takes("SECONDS", not_negative, "seconds")
      .usual(fmt::format("{}", usual_seconds_between_checkpoints));
  command.flag("--check", arguments->run.check, "also warn where half the steps give another result");
  command.flag("--strict", arguments->strict,
               "a warning is a failure: exit code 3, only its line is printed");
  command.flag("--cost", arguments->cost, "write a JSON line on standard error: time, calls, memory, rate");
  command.example("fdebench solve pendulum --scheme bdf5 --steps 302",
                  "prints the solution at all 303 times, from 0 to 20.");
  command.example(
      "fdebench solve relaxation:gamma=0.5 --scheme l1 --steps 1000 --grid graded:auto --points 11",
      "grades the grid towards 0 and prints eleven of its times.");
  command.see_also({"choose", "exact", "schemes", "grids", "history"});
  command.callback([=, &streams, &known] { solve(*arguments, streams, known); });
}

}  // namespace fde::bench
