// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/records/record_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "fdebench/benchmarks/files/lines.hpp"
#include "fdebench/benchmarks/measures/error_kind.hpp"
#include "fdebench/benchmarks/records/description_text.hpp"
#include "fdebench/benchmarks/records/key_text.hpp"
#include "fdebench/benchmarks/records/record_validation.hpp"

namespace fde::bench {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Course, t, value)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE_WITH_DEFAULT(ProgramFacts, code, version, language)

namespace {

using Json = nlohmann::json;

constexpr int format = 3;

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

// A field with the values of single columns, and the measures that its lists are of.
struct ColumnField {
  std::string name;
  std::vector<std::string> measures{};
};

const std::vector<ColumnField>& column_fields() {
  static const auto all = [] {
    ColumnField errors{"errors"}, baselines{"baselines"}, unresolved{"unresolved"};
    for (const ErrorKind& kind : error_kinds) {
      errors.measures.emplace_back(error_measure(kind));
      baselines.measures.emplace_back(baseline_measure(kind));
    }
    for (const Scale scale : error_scales) unresolved.measures.emplace_back(unresolved_measure(scale));
    return std::vector{errors, baselines, unresolved};
  }();
  return all;
}

Json json_of(const ColumnErrors& columns) {
  Json json{{"names", columns.names}};
  if (columns.is_part) json["part"] = true;
  for (const auto& [name, measures] : column_fields()) {
    std::vector<std::vector<double>> lists;
    for (const auto& measure : measures) {
      const auto* const found = columns.values.find(measure);
      lists.push_back(found != nullptr ? *found : std::vector<double>());
    }
    if (std::ranges::any_of(lists, [](const auto& list) { return !list.empty(); })) json[name] = lists;
  }
  return json;
}

ColumnErrors column_errors_of(const Json& json) {
  ColumnErrors columns{.names = json.at("names"), .is_part = json.value("part", false)};
  for (const auto& [name, measures] : column_fields()) {
    if (!json.contains(name)) continue;
    const auto lists = json[name].get<std::vector<std::vector<double>>>();
    if (lists.size() != measures.size())
      throw std::invalid_argument(fmt::format("{}: must be {} lists", name, measures.size()));
    for (std::size_t i = 0; i < lists.size(); ++i)
      if (!lists[i].empty()) columns.values.set(measures[i], lists[i]);
  }
  columns.values.shrink();
  return columns;
}

Json json_of(const QuantityValues& values) {
  Json json;
  for (const auto& [quantity, value] : values) json[std::string(quantity)] = number_of(value);
  return json;
}

QuantityValues values_of(const Json& json) {
  QuantityValues values;
  for (const auto& [quantity, value] : json.get_ref<const Json::object_t&>()) {
    if (!value.is_number())
      throw std::invalid_argument(fmt::format("{} = {}: must be a number", quantity, value.dump()));
    values.set(quantity, value.get<double>());
  }
  values.shrink();
  return values;
}

void add(const Timing& timing, Json& json) {
  if (!timing.values.empty()) json["time"] = json_of(timing.values);
  if (timing.wall_clock) json["wall_clock"] = true;
}

Timing timing_of(const Json& json) {
  Timing timing{.wall_clock = json.value("wall_clock", false)};
  if (!json.contains("time")) return timing;
  timing.values = values_of(json["time"]);
  timing.count = 1;
  return timing;
}

Record record_of(const Json& json) {
  const bool is_adaptive = json.contains("accuracy");  // and may have taken no step
  Record run{.key = run_of(json),
             .steps = steps_of(json, is_adaptive ? 0 : 1),
             .end = json.at("end"),
             .ending = {outcome_named(json.at("ending").get<std::string>()), json.value("detail", "")},
             .program = json.value("program", ProgramFacts()),
             .timing = timing_of(json)};
  run.ended_at = json.value("ended_at", run.end);
  if (json.contains("columns")) run.columns = column_errors_of(json["columns"]);
  if (json.contains("values")) run.values = values_of(json["values"]);
  if (json.contains("courses")) json["courses"].get_to(run.courses);
  return run;
}

ResultsLine line_in(const Json& json) {
  if (json.contains("session")) {
    if (json.value("format", 1) != format) throw UnsupportedFormat("a session of another format");
    return session_of(json["session"]);
  }
  if (json.at("scene").is_object()) return description_of(json["scene"]);
  if (json.contains("ending")) return record_of(json);
  if (!json.contains("time")) throw std::runtime_error("a run without ending and time");
  return LaterTimes{run_of(json), timing_of(json)};
}

}  // namespace

std::string line_of(const Session& session) {
  return Json{{"format", format}, {"session", json_of(session)}}.dump() + '\n';
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

Json json_of(const Record& run) {
  Json json = json_of(run.key);
  json.update({{"steps", run.steps}, {"end", number_of(run.end)}, {"ending", name(run.ending.kind)}});
  if (!run.ending.detail.empty()) json["detail"] = run.ending.detail;
  if (run.ended_at != run.end) json["ended_at"] = number_of(run.ended_at);
  if (run.program != ProgramFacts{}) json["program"] = run.program;
  if (!run.columns.names.empty()) json["columns"] = json_of(run.columns);
  if (!run.values.empty()) json["values"] = json_of(run.values);
  if (!run.courses.empty()) json["courses"] = run.courses;
  add(run.timing, json);
  return json;
}

std::string line_of(const Record& run) { return json_of(run).dump() + '\n'; }

std::string line_of(const LaterTimes& times) {
  Json json = json_of(times.key);
  add(times.timing, json);
  return json.dump() + '\n';
}

ResultsLine parse_line(const std::string& line) {
  ResultsLine parsed = line_in(Json::parse(line));
  std::visit([](const auto& of) { require_valid(of); }, parsed);
  return parsed;
}

}  // namespace fde::bench
