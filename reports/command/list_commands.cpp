// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>
#include <ostream>
#include <stdexcept>
#include <string_view>

#include "fdebench/benchmarks/references/reference_of.hpp"
#include "fdebench/benchmarks/requests/answers_json.hpp"
#include "fdebench/benchmarks/scenes/registry.hpp"
#include "fdebench/benchmarks/scenes/start_time.hpp"
#include "fdebench/benchmarks/sweep/measured_run.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/benchmarks/text/output_text.hpp"
#include "fdebench/benchmarks/text/printable.hpp"
#include "fdebench/reports/command/command.hpp"

namespace fde::bench {
namespace {

using Json = nlohmann::ordered_json;
using Row = TableRow;

constexpr std::size_t few_names = 16, gap = 3;

std::string column_text(const std::vector<std::string>& names) {
  if (names.size() <= few_names) return fmt::format("{}", fmt::join(names, ", "));
  return fmt::format("{}, {}, ..., {}", names[0], names[1], names.back());
}

template <typename Entries>
void print_json(const Entries& entries, std::ostream& out) {
  Json all = Json::array();
  for (const auto& entry : entries) all.push_back(json_of(entry));
  out << all.dump(2) << '\n';
}

template <typename Entries>
std::vector<Row> titles(const Entries& entries) {
  std::vector<Row> rows;
  for (const auto& entry : entries) rows.push_back({std::string(entry.id), std::string(entry.title)});
  return rows;
}

std::vector<Row> parameters_of(const SceneRegistry& known) {
  std::vector<Row> rows{{"scene", "parameter", "default", "allowed", "meaning"}};
  for (const auto& factory : known) {
    std::string id = factory.id;
    for (const auto& parameter : factory.parameters) {
      rows.push_back(
          {id, parameter.name, to_text(parameter.value), parameter.allowed(), parameter.description});
      id.clear();
    }
  }
  return rows;
}

std::string need_text(const Json& value) {
  if (value.is_boolean()) return value ? "yes" : "no";
  return fmt::format("{}", value.get<double>());
}

std::vector<Row> needs_of_all(std::span<const Scheme> known) {
  std::vector<Row> rows{{"scheme"}};
  const Json of_first = needs_of(known.front());
  for (const auto& [need, value] : of_first.items()) rows.front().push_back(need);
  for (const auto& scheme : known) {
    rows.push_back({std::string(scheme.id)});
    for (const auto& value : needs_of(scheme)) {
      rows.back().push_back(need_text(value));
    }
  }
  return rows;
}

// The end, and where the interval begins unless at 0.
std::string time_text(const Scene& scene) {
  const auto end = fmt::format("{}", end_time(scene));
  return scene.start == 0.0 ? end : fmt::format("{}, from {}", end, scene.start);
}

// Prints all data of one scene, one item a line.
void print_one(const SceneFactory& factory, std::ostream& out) {
  const Scene scene = make_scene_unchecked(factory);
  std::vector<std::string> over_grids, to_accuracies;
  for (const auto& scheme : schemes()) {
    if (!scene.ill_posed_reason.empty()) break;
    if (!unsupported_reason(scheme, scene.problem, Grid{scene.problem.end, 1024}))
      over_grids.emplace_back(scheme.id);
    if (!unsupported_reason(scheme, scene.problem, Tolerance{1e-6, 1e-6}))
      to_accuracies.emplace_back(scheme.id);
  }
  out << fmt::format(
      "{}: {}\nsource: {}\nend: {}\ncolumns: {}\nhas: {}\nreference: {}\nschemes: {}\n"
      "schemes that take an accuracy: {}\n",
      factory.id, factory.title, factory.source, time_text(scene), column_text(scene.outputs.names),
      fmt::join(defined_by(scene), ", "), evidence_of(scene), fmt::join(over_grids, ", "),
      fmt::join(to_accuracies, ", "));
  if (!factory.parameters.empty()) {
    std::vector<Row> rows{{"parameter", "default", "allowed", "meaning"}};
    for (const auto& parameter : factory.parameters)
      rows.push_back({parameter.name, to_text(parameter.value), parameter.allowed(), parameter.description});
    out << '\n';
    out << aligned(rows, gap);
  }
  if (!over_grids.empty()) {
    out << fmt::format("\nfdebench solve {} --scheme {} --steps 1024 --at {}\n", shell_word(factory.id),
                       over_grids.back(), end_time(scene));
  }
  if (!to_accuracies.empty()) {
    out << fmt::format("{}fdebench solve {} --scheme {} --accuracy 1e-6 --at {}\n",
                       over_grids.empty() ? "\n" : "", shell_word(factory.id), to_accuracies.front(),
                       end_time(scene));
  }
}

void print_one(const Scheme& scheme, std::ostream& out) {
  out << fmt::format("{}: {}\nsource: {}\n", scheme.id, scheme.title, scheme.source);
  if (!scheme.alias.empty()) out << fmt::format("other name: {}\n", scheme.alias);
  out << '\n';
  std::vector<Row> rows;
  const Json needs = needs_of(scheme);
  for (const auto& [need, value] : needs.items()) rows.push_back({need, need_text(value)});
  out << aligned(rows, gap);
}

// Prints the equation file of a scene.
void print_toml(const SceneFactory& factory, std::ostream& out) {
  if (factory.toml.empty()) reject_text("--toml", factory.id, "a scene that is an equation file");
  out << factory.toml;
}

// Prints all: id and title, or `details` with the flag `detail`, or JSON.
template <typename Entries, typename Details>
void print_all(const Given& given, std::string_view detail, const Entries& entries, const Details& details,
               std::ostream& out) {
  if (given.has("--json")) return print_json(entries, out);
  out << aligned(given.has(detail) ? details(entries) : titles(entries), gap);
}

void require_alone(const Given& given, std::string_view detail) {
  if (given.has("--json") || given.has(detail)) given.refuse("id", "alone");
}

void print_scenes(const Given& given, const Streams& streams, const SceneRegistry& known) {
  if (given.has("--toml") && !given.has("id"))
    throw std::invalid_argument("--toml: must have the id of a scene");
  if (!given.has("id")) return print_all(given, "--parameters", known, parameters_of, streams.out);
  const auto& one = known.named(given.text("id"));
  require_alone(given, "--parameters");
  given.has("--toml") ? print_toml(one, streams.out) : print_one(one, streams.out);
}

void print_schemes(const Given& given, const Streams& streams, const SceneRegistry& /*known*/) {
  if (!given.has("id")) return print_all(given, "--needs", schemes(), needs_of_all, streams.out);
  const auto& one = scheme_named(given.text("id"));
  require_alone(given, "--needs");
  print_one(one, streams.out);
}

constexpr auto all_as_json = "everything about each, as JSON", one_in_full = "one of them, in full";

}  // namespace

Command scenes_command() {
  return {{"scenes",
           "Look up",
           "List the scenes, or describe one",
           {{"[--json |", all_as_json},
            {"--parameters |", "the parameters of each, with defaults and what is allowed"},
            {"ID]", one_in_full, Completion::scene},
            {"[--toml]", "the equation file of the scene, a start for one's own"}},
           {{"fdebench scenes pendulum", "describes a scene and the schemes that accept it."},
            {"fdebench scenes pendulum --toml > mine.toml", "starts an equation file of one's own."}},
           {"schemes", "solve", "equation-files"}},
          print_scenes};
}

Command schemes_command() {
  return {{"schemes",
           "Look up",
           "List the schemes, or describe one",
           {{"[--json |", all_as_json},
            {"--needs |", "what each takes and needs of a problem"},
            {"ID]", one_in_full, Completion::scheme}},
           {{"fdebench schemes --needs", "prints what each scheme takes and needs."},
            {"fdebench schemes spectral_collocation", "describes a scheme and names its source."}},
           {"scenes", "choose", "stability"}},
          print_schemes};
}

}  // namespace fde::bench
