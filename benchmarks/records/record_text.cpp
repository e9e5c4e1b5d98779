// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/records/record_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "fdebench/benchmarks/records/description_text.hpp"
#include "fdebench/benchmarks/records/key_text.hpp"
#include "fdebench/benchmarks/records/lines.hpp"

namespace fde::bench {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Course, t, value)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(ProgramFacts, code, version, language)

namespace {

using Json = nlohmann::json;

constexpr int format = 2;

// Quantities and outcomes that version 0.2.0 named otherwise are read under their present names.
std::string present_name(const std::string& name) {
  constexpr std::string_view former_baseline = "trivial_";
  if (name.starts_with(former_baseline))
    return fmt::format("baseline_{}", name.substr(former_baseline.size()));
  return name == "outran_growth" ? "step_too_large" : name;
}

// Absent entries: accuracy of a run over a grid, an infinite budget.
void add_setup(const RunSettings& setup, Json& json) {
  if (const auto* accuracy = std::get_if<Tolerance>(&setup.resolution))
    json["accuracy"] = {{"relative", accuracy->rtol}, {"absolute", accuracy->atol}};
  json["grid"] = grid_text(setup.grading);
  json["history"] = name(setup.history);
  json["tolerance"] = setup.tolerance;
  if (std::isfinite(setup.budget)) json["budget"] = setup.budget;
}

RunSettings setup_of(const Json& json, int steps) {
  RunSettings setup{.resolution = steps,
                    .grading = parse_grading(json.at("grid").get<std::string>()),
                    .history = parse_history(json.at("history").get<std::string>()),
                    .tolerance = json.at("tolerance")};
  if (json.contains("accuracy")) {
    setup.resolution =
        Tolerance{.rtol = json["accuracy"].at("relative"), .atol = json["accuracy"].at("absolute")};
  }
  if (json.contains("budget")) setup.budget = json["budget"];
  return setup;
}

// The setup of another program.
RunSettings external_setup_of(const Json& json, int steps) {
  return {.resolution = steps, .grading = parse_grading(json.value("grid", grid_text(1.0)))};
}

// A session without a node has no such entry.
Json json_of(const Session& session) {
  Json json{{"date", session.date},         {"machine", session.machine}, {"system", session.system},
            {"compiler", session.compiler}, {"flags", session.flags},     {"commit", session.commit},
            {"version", session.version},   {"cores", session.cores}};
  if (!session.node.empty()) json["node"] = session.node;
  return json;
}

Session session_of(const Json& json) {
  return {.date = json.at("date"),
          .machine = json.at("machine"),
          .system = json.at("system"),
          .compiler = json.at("compiler"),
          .flags = json.at("flags"),
          .commit = json.at("commit"),
          .version = json.at("version"),
          .cores = json.at("cores"),
          .node = json.value("node", "")};
}

RunOutcome outcome_of(const Json& json) {
  return {outcome_named(present_name(json.at("ending"))), json.value("detail", "")};
}

Json json_of(const ColumnErrors& columns) {
  Json json{{"names", columns.names}};
  if (columns.is_part) json["part"] = true;
  if (!columns.values.empty()) json["values"] = columns.values;
  return json;
}

ColumnErrors column_errors_of(const Json& json) {
  ColumnErrors columns{.names = json.at("names"), .is_part = json.value("part", false)};
  if (json.contains("values")) json["values"].get_to(columns.values);
  return columns;
}

// A run to a tolerance may have taken no step.
int steps_of(const Json& json) {
  constexpr int most = std::numeric_limits<int>::max();
  const auto& given = json.at("steps");
  const int fewest = json.contains("accuracy") ? 0 : 1;
  if (given.is_number_integer() && given >= fewest && given <= most) return given;
  throw std::invalid_argument(
      fmt::format("steps = {}: must be a whole number from {} to {}", given.dump(), fewest, most));
}

double value_of(const Json& json) {
  const auto& value = json.at("value");
  if (value.is_number()) return value;
  throw std::invalid_argument(
      fmt::format("{} = {}: must be a number", json.at("quantity").get<std::string>(), value.dump()));
}

Record row_of(const Json& json) {
  const int steps = steps_of(json);
  const bool external = json.value("external", false);
  Record row{.key = {.scene = scene_of(json),
                     .scheme = json.at("scheme"),
                     .setup = external ? external_setup_of(json, steps) : setup_of(json, steps),
                     .external = external},
             .steps = steps,
             .h = json.at("h"),
             .quantity = present_name(json.at("quantity")),
             .value = value_of(json),
             .unit = json.at("unit"),
             .wall_clock = json.value("wall_clock", false)};
  if (json.contains("ending")) row.ending = outcome_of(json);
  if (json.contains("program")) row.program = json["program"].get<ProgramFacts>();
  if (json.contains("columns")) row.columns = column_errors_of(json["columns"]);
  if (json.contains("course")) row.course = json["course"].get<Course>();
  return row;
}

constexpr std::string_view quantity_begin = R"("quantity":")", unit_begin = R"(,"unit":")",
                           value_begin = R"(","value":)";

// Takes the word of letters, digits and underscores at the beginning of a text.
std::string_view take_word(std::string_view& text) {
  const auto is_plain = [](unsigned char c) { return c == '_' || std::isalnum(c) != 0; };
  const auto word = text.substr(0, std::ranges::find_if_not(text, is_plain) - text.begin());
  text.remove_prefix(word.size());
  return word;
}

bool take(std::string_view& text, std::string_view beginning) {
  if (beginning.empty() || !text.starts_with(beginning)) return false;
  text.remove_prefix(beginning.size());
  return true;
}

}  // namespace

std::string line_of(const Session& session) {
  return Json{{"format", format}, {"session", json_of(session)}}.dump() + '\n';
}

std::string line_of(const Record& row, bool last) {
  Json json = json_of(row.key.scene);
  json.update({{"scheme", row.key.scheme},
               {"steps", row.steps},
               {"h", row.h},
               {"quantity", row.quantity},
               {"value", row.value},
               {"unit", row.unit}});
  if (row.key.external) {
    json["external"] = true;
    if (row.key.setup.grading != 1.0) json["grid"] = grid_text(row.key.setup.grading);
  } else {
    add_setup(row.key.setup, json);
  }
  if (row.ending) json["ending"] = name(row.ending->kind);
  if (row.ending && !row.ending->detail.empty()) json["detail"] = row.ending->detail;
  if (row.program != ProgramFacts{}) json["program"] = row.program;
  if (!row.columns.names.empty()) json["columns"] = json_of(row.columns);
  if (!row.course.empty()) json["course"] = row.course;
  if (row.wall_clock) json["wall_clock"] = true;
  if (last) json["last"] = true;
  return json.dump() + '\n';
}

std::string line_of(const SceneDescription& scene) {
  Json json{{"scene", json_of(scene)}};
  std::string text = json.dump();
  for (const auto* part : {"parameters", "equations", "solution"}) {
    if (text.size() <= most_line_bytes) break;
    json["scene"].erase(part);
    text = json.dump();
  }
  return text + '\n';
}

ResultsLine LineParser::parse(const std::string& line) {
  if (auto row = continued(line)) return {.row = std::move(*row)};
  ResultsLine parsed = parse_line(line);
  if (!parsed.session && !parsed.scene && !parsed.last) keep(line, parsed.row);
  return parsed;
}

std::optional<Record> LineParser::continued(std::string_view line) const {
  if (!take(line, until_quantity_)) return std::nullopt;
  const auto quantity = take_word(line);
  if (!take(line, until_unit_)) return std::nullopt;
  const auto unit = take_word(line);
  if (!take(line, value_begin) || !line.ends_with('}')) return std::nullopt;
  line.remove_suffix(1);
  const Json value = Json::parse(line, nullptr, false);
  if (!value.is_number()) return std::nullopt;
  Record row = row_;
  row.quantity = present_name(std::string(quantity));
  row.value = value;
  row.unit = unit;
  return row;
}

// Only of the text that line_of writes is it known where the fields are.
void LineParser::keep(std::string_view line, const Record& row) {
  if (row.ending || !row.course.empty() || row.wall_clock || line_of(row, false) != std::string(line) + '\n')
    return;
  const auto quantity = line.find(quantity_begin) + quantity_begin.size();
  const auto unit = line.rfind(unit_begin) + unit_begin.size();
  row_ = row;
  until_quantity_ = line.substr(0, quantity);
  until_unit_ = line.substr(line.find('"', quantity), unit - line.find('"', quantity));
}

ResultsLine parse_line(const std::string& line) {
  const Json json = Json::parse(line);
  if (!json.contains("session")) {
    if (json.at("scene").is_object()) return {.scene = description_of(json["scene"])};
    return {.row = row_of(json), .last = json.value("last", false)};
  }
  if (json.value("format", 1) != format) throw UnsupportedFormat("a session of another format");
  return {.session = session_of(json["session"])};
}

}  // namespace fde::bench
