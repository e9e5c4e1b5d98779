// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/reference_data/data_package.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>

#include "fdebench/benchmarks/reference_data/description.hpp"
#include "fdebench/benchmarks/references/checksum.hpp"
#include "package_texts.hpp"

namespace fde::bench {
namespace {

using Json = nlohmann::ordered_json;

Json field_of(const TableColumn& column) {
  Json constraints{{"required", true}};
  if (column.minimum) constraints["minimum"] = *column.minimum;
  if (column.maximum) constraints["maximum"] = *column.maximum;
  return {{"name", column.name},
          {"type", type_name(column)},
          {"description", column.description},
          {"unit", unit_of(column)},
          {"constraints", constraints}};
}

// An empty cell is a missing value, which no column allows.
Json schema_of(const TableMetadata& facts) {
  Json fields = Json::array(), key = Json::array();
  for (const auto& column : facts.columns) {
    fields.push_back(field_of(column));
    if (column.argument) key.push_back(column.name);
  }
  return {{"fields", fields}, {"primaryKey", key}, {"missingValues", Json::array({""})}};
}

// All resources have the same keys: jsondecode of MATLAB and Octave then makes one array of structures.
Json resource_of(const TableSpec& table, const std::string& csv) {
  const TableMetadata facts = table.kind->facts(table.of);
  const std::string of_scene = table.of.factory != nullptr ? fmt::format("Scene {}. ", table.of.label()) : "";
  return {{"profile", "tabular-data-resource"},
          {"name", resource_name(table)},
          {"path", table.stem() + ".csv"},
          {"title", facts.title},
          {"description",
           fmt::format("{}Method: {}. The column bound: {}.", of_scene, facts.method, facts.bound)},
          {"format", "csv"},
          {"mediatype", "text/csv"},
          {"encoding", "utf-8"},
          {"bytes", csv.size()},
          {"hash", "sha256:" + sha256(csv)},
          {"dialect", {{"lineTerminator", "\n"}}},
          {"schema", schema_of(facts)},
          {"sources", Json::array({{{"title", facts.source}}})}};
}

// Strings of JSON are strings of YAML.
std::string citation(const Json& metadata) {
  std::string text = fmt::format(
      "cff-version: 1.2.0\nmessage: \"If you use these data in your work, please cite them as below.\"\n"
      "type: dataset\ntitle: {}\nabstract: {}\nversion: {}\nauthors:\n",
      metadata["title"].dump(), metadata["description"].dump(), metadata["version"].dump());
  for (const auto& author : metadata["contributors"])
    text += fmt::format("  - name: {}\n", author["title"].dump());
  text += fmt::format("license: {}\nkeywords:\n", metadata["licenses"][0]["name"].get<std::string>());
  for (const auto& keyword : metadata["keywords"]) text += fmt::format("  - {}\n", keyword.dump());
  return text;
}

}  // namespace

std::string resource_name(const TableSpec& table) {
  std::string name = table.stem();
  std::ranges::transform(name, name.begin(), [](unsigned char letter) {
    if (letter == '/') return '.';
    return letter == ',' || letter == '=' ? '-' : static_cast<char>(std::tolower(letter));
  });
  return name;
}

FolderFiles package_files(const std::vector<TableSpec>& tables, const FolderFiles& files) {
  const Json package = Json::parse(package_metadata);
  std::vector<std::string> resources;
  for (const auto& table : tables)
    resources.push_back(resource_of(table, files.at(table.stem() + ".csv")).dump());
  std::string described = package.dump(2);  // ends in "\n}"; a resource is a line
  described.resize(described.size() - 2);
  described += fmt::format(",\n  \"resources\": [\n{}\n  ]\n}}\n", fmt::join(resources, ",\n"));
  return {{"CITATION.cff", citation(package)},
          {"LICENSE", std::string(licence_text)},
          {"README.md", std::string(package_readme)},
          {"datapackage.json", described}};
}

}  // namespace fde::bench
