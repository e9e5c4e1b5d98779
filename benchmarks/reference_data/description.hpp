#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reference_data/table_kind.hpp"

namespace fde {

// The JSON beside a table: schema, parameters, digits, bound, method, source, generator, rows and checksum.
std::string write_description(const TableKind& kind, const SceneVariant& of, const MadeTable& made,
                              std::string_view checksum);

// What such a file of any program says; what it does not say is empty.
struct Description {
  std::string schema{}, scene{}, checksum{};
  ParameterValues parameters{};
  std::vector<std::string> columns{};
  std::optional<std::size_t> rows{};
};

// Throws std::invalid_argument naming the file when it is not JSON, or a field is of another type.
Description parse_description(const std::string& name, std::string_view text);

// The list of all tables, index.json.
struct IndexEntry {
  std::string table, description, checksum;
  std::size_t rows = 0;
};
std::string write_index(const std::vector<IndexEntry>& tables);

// The tables that an index names.
std::vector<std::string> parse_index(const std::string& name, std::string_view text);

// "fdebench.mittag_leffler": what the description of a kind has as the id of its schema.
std::string schema_id(const TableKind& kind);

}  // namespace fde
