// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <memory>
#include <ostream>
#include <string>
#include <system_error>

#include "fdebench/benchmarks/files/unfinished.hpp"
#include "fdebench/reports/command/command.hpp"
#include "fdebench/reports/command/progress_display.hpp"
#include "fdebench/reports/export/flat_table.hpp"
#include "fdebench/reports/export/tables.hpp"

namespace fde::bench {
namespace {

std::unique_ptr<TableWriter> writer_to(const std::string& format, const NewPath& out) {
  if (format == "sqlite") return sqlite_tables(out.unfinished(), out.path());
  return csv_tables(out.unfinished(), out.path());
}

void export_flat(const std::string& file, const NewPath& out, const Streams& streams) {
  std::ofstream stream(out.unfinished(), std::ios::binary);
  const auto table = [&] {
    const ProgressLine line(streams, "reads " + file);
    return write_flat_table(file, stream);
  }();
  stream.close();
  if (!stream) cannot_write(out.path(), {errno, std::generic_category()});
  out.commit();
  warn(streams, table.warning);
  streams.out << fmt::format("{}\n{} runs\n", std::filesystem::absolute(out.path()).string(), table.rows);
}

void export_file(const Given& given, const Streams& streams, const SceneRegistry& /*known*/) {
  const auto file = given.text("file"), format = given.word("--to");
  const NewPath out(given.text("--out"));
  if (format == "flat") return export_flat(file, out, streams);
  const auto counts = [&] {
    const ProgressLine line(streams, "reads " + file);
    const auto writer = writer_to(format, out);
    return write_tables(file, *writer);
  }();
  out.commit();
  warn(streams, counts.warning);
  streams.out << fmt::format("{}\n{} sessions, {} scenes, {} runs, {} results\n",
                             std::filesystem::absolute(out.path()).string(), counts.sessions, counts.scenes,
                             counts.runs, counts.results);
}

}  // namespace

Command export_command() {
  return {{"export",
           "Measure",
           "Write a results file as tables, for SQL or other programs",
           {{"FILE", "results file", Completion::results},
            {"--to FORMAT",
             "a database of SQLite, a folder of CSV with a file for each table, or one CSV file with a row "
             "for each run",
             Words{"sqlite", "csv", "flat"}},
            {"--out PATH", "the new file or folder", Completion::file}},
           {{"fdebench export results.jsonl --to sqlite --out results.sqlite",
             "writes a database; sqlite3 results.sqlite .schema shows its tables."},
            {"fdebench export results.jsonl --to csv --out tables", "writes tables/runs.csv and others."},
            {"fdebench export results.jsonl --to flat --out runs.csv",
             "writes one table, which pgfplots, pandas and R read without joins."}},
           {"merge", "report", "output"}},
          export_file};
}

}  // namespace fde::bench
