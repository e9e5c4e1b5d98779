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

void solve(const SolveArguments& arguments, const Streams& streams, const SceneRegistry& known) {
  auto variant = read_variant(arguments.scene, known);
  if (arguments.until && variant.until)
    reject_text("--until", *arguments.until, "without until= in the scene");
  if (arguments.until) variant.until = parse_number("--until", *arguments.until, valid_end_times);
  const Scene scene = make_scene(variant);
  const SolvedTable table = solved_table(scene, arguments.run, [&](const std::string& problem) {
    streams.err << fmt::format("fdebench: {}\n", problem) << std::flush;
  });
  const bool fails = arguments.strict && !table.warning.empty();
  if (!fails && arguments.run.field) write_field(table, *arguments.run.field);
  if (!fails) print_rows(table, streams.out);
  std::error_code ignored;
  if (!table.checkpoint.empty() && streams.out.flush()) std::filesystem::remove(table.checkpoint, ignored);
  if (fails) throw NumericalFailure(table.warning);
  if (!table.warning.empty()) streams.err << fmt::format("fdebench: {}\n", table.warning);
  if (!table.ended.empty()) streams.err << fmt::format("fdebench: {}\n", table.ended);
  if (arguments.cost) streams.err << table.cost << '\n';
}

}  // namespace

void add_solve_command(CommandLine& program, const Streams& streams, const SceneRegistry& known) {
  auto arguments = std::make_shared<SolveArguments>();
  Subcommand command(program, "solve", "Solve a scene with a scheme; CSV on standard output");
  add_scene(command, arguments->scene);
  command.required("--scheme", arguments->run.scheme, "id of the scheme");
  auto* steps = command.option("--steps", arguments->run.steps, "number of steps N");
  auto* accuracy = command.option("--accuracy", arguments->run.accuracy,
                                  "of schemes that choose their steps: relative, and absolute");
  Subcommand::exclude(accuracy, steps);
  command.option("--until", arguments->until, "end of the time interval");
  auto* at = command.option("--at", arguments->run.at, "grid times to print, T1,T2,...; default all");
  auto* every = command.option("--every", arguments->run.every, "print each K-th grid time, and the last");
  auto* points = command.option("--points", arguments->run.points, "print K grid times from 0 to the end");
  command.flag("--events", arguments->run.events,
               "print the events of the scene in place of times, with --accuracy");
  command.flag("--all", arguments->run.all,
               "of a problem at both ends: all solutions that a search from other starts finds");
  Subcommand::exclude(every, at);
  Subcommand::exclude(points, at);
  Subcommand::exclude(points, every);
  command.option("--field", arguments->run.field, "a CSV of all unknowns at the times that are printed");
  add_options(command, arguments->run.settings);
  command.option("--threads", arguments->run.threads,
                 "among which the unknowns of a step are shared where they are many, default 1; the same "
                 "bits for any number");
  command.option("--checkpoint", arguments->run.checkpoint,
                 "a file that keeps the state of the run: the same command goes on from it");
  command.option("--checkpoint-every", arguments->run.checkpoint_every,
                 "seconds between two states kept, default 300");
  command.flag("--check", arguments->run.check, "also warn where half the steps give another result");
  command.flag("--strict", arguments->strict, "a warning is a failure: exit 3, nothing printed but its line");
  command.flag("--cost", arguments->cost, "one JSON line on standard error: time, calls, memory, rate");
  command.callback([=, &known] { solve(*arguments, streams, known); });
}

}  // namespace fde::bench
