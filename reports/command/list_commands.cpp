#include <fmt/ostream.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <ostream>

#include "command/arguments.hpp"
#include "command/command.hpp"
#include "scenes/registry.hpp"
#include "sweep/experiment.hpp"

namespace fde {
namespace {

using Json = nlohmann::ordered_json;

// What a scene declares beyond its problem.
std::vector<std::string> capabilities(const Scene& scene) {
  std::vector<std::string> names;
  if (scene.reference.at) names.emplace_back("exact");
  if (has_jacobian(scene.problem)) names.emplace_back("jacobian");
  if (linear(scene.problem)) names.emplace_back("linear");
  if (scene.energy) names.emplace_back("energy");
  if (scene.constraint) names.emplace_back("constraint");
  return names;
}

Json describe(const SceneMaker& maker) {
  const Scene scene = make_scene(maker);
  Json parameters = Json::array();
  for (const auto& parameter : maker.parameters) {
    const auto as_json = [](const auto& value) -> Json { return value; };
    parameters.push_back({{"name", parameter.name},
                          {"default", std::visit(as_json, parameter.value)},
                          {"allowed", parameter.allowed()},
                          {"meaning", parameter.meaning}});
  }
  return {{"id", maker.id},
          {"title", maker.title},
          {"source", maker.source},
          {"parameters", parameters},
          {"end", scene.problem.end},
          {"columns", scene.outputs.names},
          {"has", capabilities(scene)}};
}

Json describe(const Scheme& scheme) {
  return {{"id", scheme.id},
          {"title", scheme.title},
          {"source", scheme.source},
          {"implicit", scheme.needs.implicit},
          {"algebraic_rows", scheme.needs.algebraic_rows},
          {"uniform_grid", scheme.needs.uniform_grid},
          {"largest_order", scheme.needs.largest_order},
          {"two_sided", scheme.needs.two_sided}};
}

template <typename Entries>
void list(const Entries& entries, bool json, std::ostream& out) {
  if (json) {
    Json all = Json::array();
    for (const auto& entry : entries) all.push_back(describe(entry));
    fmt::print(out, "{}\n", all.dump(2));
    return;
  }
  for (const auto& entry : entries) fmt::print(out, "{:<34}{}\n", entry.id, entry.title);
}

void add(CLI::App& app, const std::string& name, const std::string& help,
         const std::function<void(bool)>& print) {
  auto* command = app.add_subcommand(name, help);
  auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "everything about each, as JSON");
  command->callback([=] { print(*json); });
}

}  // namespace

void add_list_commands(CLI::App& app, const Streams& streams) {
  add(app, "scenes", "List the scenes", [&](bool json) { list(scenes(), json, streams.out); });
  add(app, "schemes", "List the schemes", [&](bool json) { list(schemes(), json, streams.out); });
}

}  // namespace fde
