#include <fmt/ostream.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <ostream>

#include "arguments.hpp"
#include "command.hpp"
#include "reference_check.hpp"

namespace fde {
namespace {

constexpr int largest_every = 1'000'000;

struct ReferenceArguments {
  std::optional<std::string> out, check;
  std::string every = "1";
};

void write_tables(const std::string& folder, const Streams& streams) {
  const auto tables = planned_tables(default_scenes());
  require_replaceable(folder, tables);
  replace_folder(folder, make_files(tables, progress_line(streams)));
  fmt::print(streams.out, "{}\n", std::filesystem::absolute(folder).string());
}

std::string describe(const RowVerdict& row) {
  if (!row.failure.empty()) return fmt::format("no value: {}", row.failure);
  return fmt::format("{}: error {}, allowed {}, ratio {:.3g}", row.column, row.error, row.allowed, row.ratio);
}

void print(const TableVerdict& verdict, std::ostream& out) {
  fmt::print(out, "{}: {} rows, {} recomputed, {} wrong{}\n", verdict.table, verdict.rows, verdict.recomputed,
             verdict.wrong, verdict.checksum_holds ? "" : ", CHECKSUM DIFFERS");
  if (verdict.recomputed > 0) {
    fmt::print(out, "  worst: line {}, {}{}\n    {}\n", verdict.worst_line, describe(verdict.worst),
               verdict.worst.holds() ? "" : " WRONG", verdict.worst_row);
  }
  for (const auto& what : verdict.absent) fmt::print(out, "  absent: {}\n", what);
}

// A wrong number weighs more than a checksum, which it changes too.
void check_tables(const std::string& folder, std::size_t every, const Streams& streams) {
  const auto verdicts = check_folder(folder, every, progress_line(streams));
  for (const auto& verdict : verdicts) print(verdict, streams.out);
  for (const auto& verdict : verdicts) {
    if (verdict.wrong == 0) continue;
    throw NumericalFailure(fmt::format("{}: {} of {} rows wrong, the worst in line {}, {}", verdict.table,
                                       verdict.wrong, verdict.recomputed, verdict.worst_line,
                                       describe(verdict.worst)));
  }
  const auto worst =
      std::ranges::max_element(verdicts, {}, [](const TableVerdict& verdict) { return verdict.worst.ratio; });
  fmt::print(streams.out, "all {} tables hold; worst ratio {:.3g}, {} line {}\n", verdicts.size(),
             worst->worst.ratio, worst->table, worst->worst_line);
  const auto changed = std::ranges::find(verdicts, false, &TableVerdict::checksum_holds);
  if (changed != verdicts.end())
    throw std::invalid_argument(fmt::format("{}: its rows hold, but its checksum differs", changed->table));
}

void reference(const ReferenceArguments& arguments, const Streams& streams) {
  if (arguments.out) {
    write_tables(*arguments.out, streams);
  } else {
    check_tables(*arguments.check,
                 static_cast<std::size_t>(parse_count("--every", arguments.every, 1, largest_every)),
                 streams);
  }
}

}  // namespace

void add_data_commands(CLI::App& app, const Streams& streams) {
  auto arguments = std::make_shared<ReferenceArguments>();
  auto* command =
      app.add_subcommand("reference", "Write the tables of reference data, or check a folder of them");
  auto* action = command->add_option_group("action");
  action->add_option("--out", arguments->out, "folder to write: CSV, JSON, index and checksums");
  auto* check = action->add_option("--check", arguments->check, "folder to recompute, of any program");
  action->require_option(1);
  command->add_option("--every", arguments->every, "with --check: recompute each K-th row only")
      ->needs(check);
  command->callback([=] { reference(*arguments, streams); });
}

}  // namespace fde
