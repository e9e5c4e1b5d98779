// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <ostream>
#include <stdexcept>
#include <string>

#include "fdebench/benchmarks/files/unfinished.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/reports/command/command.hpp"
#include "fdebench/reports/command/command_line.hpp"
#include "fdebench/reports/command/progress_display.hpp"
#include "fdebench/reports/export/tables.hpp"

namespace fde::bench {
namespace {

struct ExportArguments {
  std::string file, to, out;
};

const Words& export_formats() {
  static const Words words{"sqlite", "csv"};
  return words;
}

std::unique_ptr<TableWriter> writer_to(const std::string& format, const NewPath& out) {
  if (format == "sqlite") return sqlite_tables(out.unfinished(), out.path());
  if (format == "csv") return csv_tables(out.unfinished(), out.path());
  reject_text("--to", format, choice_text(export_formats()));
}

void export_file(const ExportArguments& arguments, const Streams& streams) {
  const NewPath out(arguments.out);
  const auto counts = [&] {
    const ProgressLine line(streams, "reads " + arguments.file);
    const auto writer = writer_to(arguments.to, out);
    return write_tables(arguments.file, *writer);
  }();
  out.commit();
  warn(streams, counts.warning);
  streams.out << fmt::format("{}\n{} sessions, {} scenes, {} runs, {} results\n",
                             std::filesystem::absolute(out.path()).string(), counts.sessions, counts.scenes,
                             counts.runs, counts.results);
}

}  // namespace

void add_export_command(CommandLine& program, const Streams& streams, const SceneRegistry& /*known*/) {
  auto given = std::make_shared<ExportArguments>();
  Subcommand command(program, "export", "Write a results file as tables, for SQL or other programs");
  command.group("Measure");
  command.required("file", given->file, "results file").takes("FILE").completed_by(Completion::results);
  command.required("--to", given->to, "a database of SQLite, or a folder with a file for each table")
      .takes("FORMAT", export_formats());
  command.required("--out", given->out, "the new file or folder")
      .takes("PATH")
      .completed_by(Completion::file);
  command.example("fdebench export results.jsonl --to sqlite --out results.sqlite",
                  "writes a database; sqlite3 results.sqlite .schema shows its tables.");
  command.example("fdebench export results.jsonl --to csv --out tables",
                  "writes tables/runs.csv and others.");
  command.see_also({"merge", "report", "output"});
  command.callback([=, &streams] { export_file(*given, streams); });
}

}  // namespace fde::bench
