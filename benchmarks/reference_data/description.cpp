// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/reference_data/description.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "fdebench/benchmarks/records/record.hpp"
#include "fdebench/benchmarks/sweep/measured_run.hpp"

namespace fde::bench {
namespace {

using Json = nlohmann::ordered_json;

constexpr int schema_version = 1;
constexpr auto index_id = "fdebench.index";

Json generator() {
  const Session session = this_session();
  return {{"name", "fdebench"}, {"version", session.version}, {"commit", session.commit}};
}

Json schema_of(const TableKind& kind, const TableMetadata& facts) {
  Json columns = Json::array();
  for (const auto& column : facts.columns) {
    columns.push_back({{"name", column.name},
                       {"meaning", column.description},
                       {"unit", unit_of(column)},
                       {"type", type_name(column)}});
  }
  return {{"id", schema_id(kind)}, {"version", schema_version}, {"columns", columns}};
}

// All parameters of the scene, defaults included.
Json parameters_of(const SceneVariant& of) {
  Json parameters = Json::object();
  for (const auto& parameter : of.factory->parameters) {
    const auto given = of.values.find(parameter.name);
    const auto& value = given == of.values.end() ? parameter.value : given->second;
    std::visit([&](const auto& one) { parameters[parameter.name] = one; }, value);
  }
  return parameters;
}

ParameterValue parameter_value(const Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_array()) return value.get<std::vector<double>>();
  return value.get<double>();
}

std::string to_text(const Json& json) { return json.dump(2) + "\n"; }

// The message of a JSON exception without its prefix "[json.exception.type_error.302] ".
std::string in_short(std::string_view message) {
  const auto end = message.find("] ");
  return std::string(end == std::string_view::npos ? message : message.substr(end + 2));
}

// The result of `read` for the parsed text. JSON exceptions become std::invalid_argument naming the file.
template <typename Read>
auto with_json(const std::string& name, std::string_view text, const Read& read) {
  try {
    return read(Json::parse(text));
  } catch (const Json::parse_error& error) {
    throw std::invalid_argument(fmt::format("{}: is not JSON, at byte {}", name, error.byte));
  } catch (const Json::exception& error) {
    throw std::invalid_argument(
        fmt::format("{}: is not as docs/reference_data.md says: {}", name, in_short(error.what())));
  }
}

void require_version(const std::string& name, const Json& schema) {
  const int version = schema.value("version", schema_version);
  if (version == schema_version) return;
  throw std::invalid_argument(
      fmt::format("{}: schema version = {}: must be {}", name, version, schema_version));
}

}  // namespace

std::string_view type_name(const TableColumn& column) {
  switch (column.type) {
    case ColumnType::integer:
      return "integer";
    case ColumnType::text:
      return "string";
    case ColumnType::number:
      break;
  }
  return "number";
}

std::string unit_of(const TableColumn& column) { return column.type == ColumnType::text ? "" : column.unit; }

std::string schema_id(const TableKind& kind) { return fmt::format("fdebench.{}", kind.id); }

std::string write_description(const TableKind& kind, const SceneVariant& of, const ComputedTable& made,
                              std::string_view checksum) {
  const TableMetadata facts = kind.facts(of);
  Json json{{"schema", schema_of(kind, facts)}, {"title", facts.title}};
  if (of.factory != nullptr) {
    json["scene"] = of.factory->id;
    json["parameters"] = parameters_of(of);
  } else {
    json["parameters"] = Json::object();
  }
  json["digits"] = facts.digits;
  json["bound"] = facts.bound;
  json["method"] = facts.method;
  json["source"] = facts.source;
  json["generator"] = generator();
  json["rows"] = made.table.rows.size();
  if (!made.left_out.empty()) {
    json["left_out"] = Json::array();
    for (const auto& [run, reason] : made.left_out)
      json["left_out"].push_back({{"run", run}, {"reason", reason}});
  }
  json["sha256"] = checksum;
  return to_text(json);
}

Description parse_description(const std::string& name, std::string_view text) {
  return with_json(name, text, [&](const Json& json) {
    const Json schema = json.value("schema", Json::object());
    require_version(name, schema);
    Description description{.schema = schema.value("id", ""),
                            .scene = json.value("scene", ""),
                            .checksum = json.value("sha256", "")};
    for (const auto& column : schema.value("columns", Json::array()))
      description.columns.push_back(column.at("name"));
    const Json parameters = json.value("parameters", Json::object());
    for (const auto& [parameter, value] : parameters.items())
      description.parameters[parameter] = parameter_value(value);
    if (json.contains("rows")) description.rows = json.at("rows").get<std::size_t>();
    return description;
  });
}

std::string write_index(const std::vector<IndexEntry>& tables) {
  Json list = Json::array();
  for (const auto& [table, description, checksum, rows] : tables)
    list.push_back({{"file", table}, {"description", description}, {"rows", rows}, {"sha256", checksum}});
  return to_text({{"schema", {{"id", index_id}, {"version", schema_version}}},
                  {"generator", generator()},
                  {"tables", list}});
}

std::vector<std::string> parse_index(const std::string& name, std::string_view text) {
  return with_json(name, text, [&](const Json& json) {
    require_version(name, json.value("schema", Json::object()));
    std::vector<std::string> tables;
    for (const auto& entry : json.at("tables")) tables.push_back(entry.at("file"));
    return tables;
  });
}

}  // namespace fde::bench
