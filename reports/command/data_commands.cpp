// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <ostream>

#include "fdebench/benchmarks/reference_data/reference_check.hpp"
#include "fdebench/benchmarks/sweep/default_sweep.hpp"
#include "fdebench/reports/command/command.hpp"
#include "fdebench/reports/command/progress_display.hpp"

namespace fde::bench {
namespace {

TableProgress reporter(ProgressLine& line) {
  return
      [&line](std::size_t done, std::size_t total, const std::string& what) { line.set(done, total, what); };
}

void write_tables(const std::string& folder, const Streams& streams) {
  const auto tables = planned_tables(default_scenes());
  require_replaceable(folder, tables);
  replace_folder(folder, [&] {
    ProgressLine line(streams, "", true);
    return compute_files(tables, reporter(line));
  }());
  streams.out << std::filesystem::absolute(folder).string() << '\n';
}

std::string describe(const RowComparison& row) {
  if (!row.failure.empty()) return fmt::format("no value: {}", row.failure);
  return fmt::format("{}: error {}, allowed {}, ratio {:.3g}", row.column, row.error, row.allowed, row.ratio);
}

void print(const TableCheck& verdict, std::ostream& out) {
  out << fmt::format("{}: {} rows, {} recomputed, {} wrong\n", verdict.table, verdict.rows,
                     verdict.recomputed, verdict.wrong);
  if (verdict.recomputed > 0) {
    out << fmt::format("  worst: line {}, {}{}\n    {}\n", verdict.worst_line, describe(verdict.worst),
                       verdict.worst.holds() ? "" : " WRONG", verdict.worst_row);
  }
  for (const auto& what : verdict.assumptions) out << fmt::format("  absent: {}\n", what);
}

// The summary if no row is wrong. Without a description, scene and parameters of a table are assumed.
std::string outcome(const std::vector<TableCheck>& tables) {
  const auto guessed = std::ranges::count(tables, false, &TableCheck::described);
  if (guessed == 0) return "all hold";
  return fmt::format("none is wrong, but {} without a JSON {} not say what {}", guessed,
                     guessed == 1 ? "does" : "do", guessed == 1 ? "it is" : "they are");
}

std::string summary(const std::vector<TableCheck>& tables) {
  const auto worst =
      std::ranges::max_element(tables, {}, [](const TableCheck& table) { return table.worst.ratio; });
  std::size_t rows = 0;
  for (const auto& table : tables) rows += table.recomputed;
  return fmt::format("{} tables, {} rows recomputed: {}; worst ratio {:.3g}, {} line {}", tables.size(), rows,
                     outcome(tables), worst->worst.ratio, worst->table, worst->worst_line);
}

// Wrong values are reported first: a wrong value also changes the checksum.
void check_tables(const std::string& folder, std::size_t every, const Streams& streams) {
  const auto [tables, changed] = [&] {
    ProgressLine line(streams, "", true);
    return check_folder(folder, every, reporter(line));
  }();
  for (const auto& table : tables) print(table, streams.out);
  for (const auto& file : changed) streams.out << fmt::format("{}: CHECKSUM DIFFERS\n", file);
  for (const auto& table : tables) {
    if (table.wrong == 0) continue;
    throw NumericalFailure(fmt::format("{}: {} of {} rows wrong, the worst in line {}, {}", table.table,
                                       table.wrong, table.recomputed, table.worst_line,
                                       describe(table.worst)));
  }
  streams.out << summary(tables) << '\n';
  if (!changed.empty())
    throw std::invalid_argument(fmt::format("{}: all rows hold, but its checksum differs", *changed.begin()));
}

void reference(const Given& given, const Streams& streams, const SceneRegistry& /*known*/) {
  if (given.has("--out") == given.has("--check")) given.refuse("one of --out and --check is required");
  if (given.has("--every") && !given.has("--check")) given.refuse("--every requires --check");
  if (const auto out = given.find("--out")) return write_tables(*out, streams);
  check_tables(given.text("--check"), static_cast<std::size_t>(given.count("--every")), streams);
}

}  // namespace

Command reference_command() {
  return {{"reference",
           "Data",
           "Write the tables of reference data, or check a folder of them",
           {{"(--out DIR |", "folder to write: CSV, JSON, index and checksums", Completion::folder},
            {"--check DIR)", "folder to recompute, of any program", Completion::folder},
            {"[--every K]", "with --check: recompute each K-th row only", CountRange{1, 1'000'000}, "1"}},
           {{"fdebench reference --check reference/data --every 29",
             "recomputes each 29th row of the tables of the repository."},
            {"fdebench reference --out tables", "writes all tables to a folder; this takes minutes."}},
           {"exact", "mittag-leffler", "accuracy"}},
          reference};
}

}  // namespace fde::bench
