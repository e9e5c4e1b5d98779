// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/reference_data/reference_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <mutex>
#include <stdexcept>
#include <string_view>
#include <thread>

#include "fdebench/benchmarks/reference_data/description.hpp"
#include "fdebench/benchmarks/references/checksum.hpp"
#include "fdebench/benchmarks/scenes/registry.hpp"
#include "fdebench/benchmarks/sweep/in_parallel.hpp"
#include "fdebench/benchmarks/text/entry_named.hpp"

namespace fde::bench {
namespace {

namespace fs = std::filesystem;

// A table of the folder with its description and checksum.
struct GivenTable {
  DataTable table;
  Description description{};
  const TableKind* kind = nullptr;
  SceneVariant of{.factory = nullptr};
  std::string checksum{};
  TableCheck verdict{};
};

[[noreturn]] void reject(const std::string& file, const std::string& what) {
  throw InvalidTable(fmt::format("{}: {}", file, what));
}

std::vector<fs::path> tables_in(const fs::path& folder) {
  std::error_code problem;
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder, problem)) {
    if (entry.path().extension() == ".csv") files.push_back(entry.path());
  }
  if (problem) reject(folder.string(), fmt::format("cannot be read: {}", problem.message()));
  if (files.empty()) reject(folder.string(), "holds no table (.csv)");
  std::ranges::sort(files);
  return files;
}

const TableKind& kind_of(const DataTable& table) {
  std::vector<std::string_view> known;
  for (const auto& kind : table_kinds()) {
    if (table.find(kind.identifying_column)) return kind;
    known.push_back(kind.identifying_column);
  }
  reject(table.name,
         fmt::format("line 1: must have a column {}, by which a table is known", fmt::join(known, " or ")));
}

// fdebench 0.1 wrote a choice parameter as an index into its words: replaces the index by the word.
ParameterValues with_words(ParameterValues values, const SceneFactory& factory) {
  for (const auto& parameter : factory.parameters) {
    const auto given = values.find(parameter.name);
    for (std::size_t i = 0; given != values.end() && i < parameter.choices.size(); ++i) {
      if (given->second == ParameterValue(static_cast<double>(i))) given->second = parameter.choices[i];
    }
  }
  return values;
}

// The scene named in the description, otherwise the scene that the file is named after.
SceneVariant scene_of(const GivenTable& given, const fs::path& file) {
  const auto& name = given.description.scene.empty() ? file.stem().string() : given.description.scene;
  std::vector<std::string_view> ids;
  for (const auto& factory : built_in_scenes()) {
    if (factory.id == name)
      return {.factory = &factory, .values = with_words(given.description.parameters, factory)};
    ids.push_back(factory.id);
  }
  reject(given.table.name, fmt::format("scene {}: no such scene{}; there are {}", name,
                                       did_you_mean(name, ids), fmt::join(ids, ", ")));
}

void require_columns(const GivenTable& given) {
  const auto& [table, description, kind, of, checksum, verdict] = given;
  for (const auto& column : kind->facts(of).columns) {
    if (column.required && !table.find(column.name))
      reject(table.name, fmt::format("line 1: column {} is missing", column.name));
  }
  for (const auto& column : description.columns) {
    if (!table.find(column))
      reject(table.name, fmt::format("line 1: column {} of the description is missing", column));
  }
  if (description.rows && *description.rows != table.rows.size()) {
    reject(table.name,
           fmt::format("has {} rows, {} in its description", table.rows.size(), *description.rows));
  }
}

GivenTable read_table(const fs::path& file) {
  const std::string text = read_file(file);
  GivenTable given{.table = parse_csv(file.string(), text)};
  const fs::path description = fs::path(file).replace_extension(".json");
  const bool described = fs::exists(description);
  if (described) given.description = parse_description(description.string(), read_file(description));
  given.kind = &kind_of(given.table);
  const auto& schema = given.description.schema;
  if (!schema.empty() && schema != schema_id(*given.kind))
    reject(description.string(), fmt::format("schema id = {}: must be {}", schema, schema_id(*given.kind)));
  try {
    if (given.kind->of_scenes()) given.of = scene_of(given, file);
    require_columns(given);
  } catch (const InvalidTable&) {
    throw;
  } catch (const std::invalid_argument& error) {  // for a bad parameter
    reject(description.string(), error.what());
  }
  auto& verdict = given.verdict;
  verdict.rows = given.table.rows.size();
  if (verdict.rows == 0) {
    throw std::invalid_argument(
        fmt::format("{}: has no rows below its header; lines end with \\n", given.table.name));
  }
  given.checksum = sha256(text);
  verdict.described = described;
  if (!described) {
    verdict.assumptions.emplace_back(given.kind->of_scenes() ? "description: default parameters"
                                                             : "description");
  }
  return given;
}

std::string cells_of(const DataTable& table, std::size_t row) {
  constexpr std::size_t longest = 24;
  std::vector<std::string> cells;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const std::string_view cell = table.rows[row][c];
    cells.push_back(fmt::format("{}={}{}", table.columns[c], cell.substr(0, longest),
                                cell.size() > longest ? "..." : ""));
  }
  return fmt::format("{}", fmt::join(cells, " "));
}

// A row whose value cannot be recomputed counts as wrong: the table states a value.
RowComparison verdict_of(const DataTable& table, const RowCheck& check, std::size_t row) {
  try {
    return check(row);
  } catch (const InvalidTable&) {
    throw;
  } catch (const std::invalid_argument& error) {  // for an argument out of range
    reject(table.name, fmt::format("line {}: {}", row + 2, error.what()));
  } catch (const std::runtime_error& failure) {
    return {.ratio = std::numeric_limits<double>::infinity(), .failure = failure.what()};
  }
}

// If the scene has no reference, the check of every row throws.
RowCheck check_of(const GivenTable& given) {
  try {
    return given.kind->check(given.of, given.table);
  } catch (const std::runtime_error& failure) {
    return [reason = std::string(failure.what())](std::size_t) -> RowComparison {
      throw std::runtime_error(reason);
    };
  }
}

void recompute(GivenTable& given, std::size_t every) {
  const auto& table = given.table;
  auto& verdict = given.verdict;
  const auto check = check_of(given);
  for (std::size_t row = 0; row < table.rows.size(); row += every) {
    const RowComparison found = verdict_of(table, check, row);
    ++verdict.recomputed;
    if (!found.holds()) ++verdict.wrong;
    if (verdict.recomputed > 1 && found.ratio <= verdict.worst.ratio) continue;
    verdict.worst = found;
    verdict.worst_line = row + 2;
    verdict.worst_row = cells_of(table, row);
  }
  if (!table.find("bound"))
    verdict.assumptions.emplace_back("bound: half a unit of the last digit is allowed");
}

// The files whose checksum differs from SHA256SUMS. Throws if a listed file cannot be read.
std::set<std::string> changed_files(const fs::path& folder, const Checksums& checksums) {
  std::set<std::string> changed;
  for (const auto& [name, digest] : checksums) {
    if (sha256(read_file(folder / name)) != digest) changed.insert(name);
  }
  return changed;
}

}  // namespace

FolderCheck check_folder(const fs::path& folder, std::size_t every, const TableProgress& progress) {
  const fs::path sums = folder / "SHA256SUMS", index = folder / "index.json";
  std::vector<GivenTable> given;
  for (const auto& file : tables_in(folder)) given.push_back(read_table(file));
  if (fs::exists(index)) {
    for (const auto& name : parse_index(index.string(), read_file(index))) read_file(folder / name);
  }
  FolderCheck verdict;
  const bool summed = fs::exists(sums);
  if (summed) verdict.changed = changed_files(folder, parse_checksums(sums.string(), read_file(sums)));
  std::mutex mutex;
  std::size_t done = 0;
  in_parallel(given.size(), std::thread::hardware_concurrency(), [&](std::size_t i) {
    recompute(given[i], every);
    const std::scoped_lock lock(mutex);
    progress(++done, given.size(), given[i].table.name);
  });
  for (auto& table : given) {
    const auto& described = table.description.checksum;
    table.verdict.table = fs::path(table.table.name).lexically_relative(folder).generic_string();
    if (!described.empty() && described != table.checksum) verdict.changed.insert(table.verdict.table);
    if (!summed && described.empty()) table.verdict.assumptions.emplace_back("checksum");
    verdict.tables.push_back(std::move(table.verdict));
  }
  return verdict;
}

}  // namespace fde::bench
