// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/reference_data/table_kind.hpp"

namespace fde::bench {

// The JSON that describes a table: schema, parameters, digits, bound, method, source, generator, rows,
// checksum.
std::string write_description(const TableKind& kind, const SceneVariant& of, const ComputedTable& made,
                              std::string_view checksum);

// The parsed description of a table, by any program; missing fields are empty.
struct Description {
  std::string schema{}, scene{}, checksum{};
  ParameterValues parameters{};
  std::vector<std::string> columns{};
  std::optional<std::size_t> rows{};
};

// Throws std::invalid_argument naming the file if it is not JSON, a field has another type, or the schema
// version is not supported.
Description parse_description(const std::string& name, std::string_view text);

// The list of all tables, index.json.
struct IndexEntry {
  std::string table, description, checksum;
  std::size_t rows = 0;
};
std::string write_index(const std::vector<IndexEntry>& tables);

// The table files listed in an index. Throws like parse_description().
std::vector<std::string> parse_index(const std::string& name, std::string_view text);

// The type of a column, the same word in descriptions and in the data package, and its unit, "" of texts.
std::string_view type_name(const TableColumn& column);
std::string unit_of(const TableColumn& column);

// Schema id in the descriptions of a kind: "fdebench.mittag_leffler".
std::string schema_id(const TableKind& kind);

}  // namespace fde::bench
