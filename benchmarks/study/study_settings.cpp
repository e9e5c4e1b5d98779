// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/study/study_settings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "fdebench/benchmarks/requests/solve_request.hpp"

namespace fde::bench {
namespace {

// The key for a field of a request.
std::string study_key(const std::string& field) {
  return field == "scheme" ? "schemes" : field == "accuracy" ? "accuracies" : field;
}

std::string list_text(const std::vector<std::string>& values) {
  return fmt::format("[{}]", fmt::join(values, ", "));
}

template <typename Resolution, typename Text>
std::string resolutions_text(const SweepRequest& request, Text text) {
  std::vector<std::string> values;
  for (const auto& resolution : request.resolutions)
    if (const auto* value = std::get_if<Resolution>(&resolution)) values.push_back(text(*value));
  return list_text(values);
}

std::string schemes_text(const SweepRequest& request) {
  std::vector<std::string> ids;
  for (const Scheme* scheme : request.schemes) ids.push_back(toml_text(std::string(scheme->id)));
  return list_text(ids);
}

std::string programs_text(const SweepRequest& request) {
  std::vector<std::string> programs;
  for (const auto& [name, command] : request.programs)
    programs.push_back(fmt::format("{} = {}", toml_key(name), toml_text(command)));
  return fmt::format("{{{}}}", fmt::join(programs, ", "));
}

}  // namespace

std::string toml_text(const std::string& text) { return nlohmann::json(text).dump(); }  // has JSON's escapes

std::string toml_key(const std::string& name) {
  constexpr std::string_view bare = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
  return name.find_first_not_of(bare) == std::string::npos && !name.empty() ? name : toml_text(name);
}

// A key, how its field of a request is read, and its value as text.
struct StudySettingsReader::Setting {
  std::string_view key;
  void (*read)(const StudySettingsReader& of, const toml::node& node, SweepRequest& request);
  std::string (*text)(const SweepRequest& request);
};

const std::vector<StudySettingsReader::Setting>& StudySettingsReader::all() {
  using Reader = StudySettingsReader;
  using Node = toml::node;
  static const std::vector<Setting> settings{
      {"schemes",
       [](const Reader& of, const Node& node, SweepRequest& request) {
         for (const Node* id : of.values_of(node, "schemes"))
           request.schemes.push_back(&scheme_named(of.text_value(*id, "schemes")));
       },
       schemes_text},
      {"external",
       [](const Reader& of, const Node& node, SweepRequest& request) {
         for (const auto& [name, place, command] : of.entries(node, "external"))
           request.programs.push_back(parse_external(name + '=' + of.text_value(*command, name)));
       },
       programs_text},
      {"steps",
       [](const Reader& of, const Node& node, SweepRequest& request) { of.read_steps(node, request); },
       [](const SweepRequest& request) {
         return resolutions_text<int>(request, [](int steps) { return fmt::format("{}", steps); });
       }},
      {"accuracies",
       [](const Reader& of, const Node& node, SweepRequest& request) { of.read_accuracies(node, request); },
       [](const SweepRequest& request) {
         return resolutions_text<Tolerance>(request,
                                            [](const auto& one) { return fmt::format("{}", one.rtol); });
       }},
      {"grid",
       [](const Reader& of, const Node& node, SweepRequest& request) {
         const auto grading = parse_grid(of.text_value(node, "grid"));
         request.optimal_grading = !grading;
         request.settings.grading = grading.value_or(1.0);
       },
       [](const SweepRequest& request) {
         return toml_text(request.optimal_grading ? std::string(optimal_grid)
                                                  : grid_text(request.settings.grading));
       }},
      {"history",
       [](const Reader& of, const Node& node, SweepRequest& request) {
         request.settings.history = parse_history(of.text_value(node, "history"));
       },
       [](const SweepRequest& request) { return toml_text(std::string(name(request.settings.history))); }},
      {"tolerance",
       [](const Reader& of, const Node& node, SweepRequest& request) {
         request.settings.newton_tolerance = of.number_value(node, "tolerance");
         require_in("tolerance", request.settings.newton_tolerance, newton_tolerances);
       },
       [](const SweepRequest& request) { return fmt::format("{}", request.settings.newton_tolerance); }},
      {"budget",
       [](const Reader& of, const Node& node, SweepRequest& request) {
         request.budget = of.number_value(node, "budget");
         require_in("budget", *request.budget, positive);
       },
       [](const SweepRequest& request) { return fmt::format("{}", *request.budget); }},
      {"repeat",
       [](const Reader& of, const Node& node, SweepRequest& request) {
         request.repeats = of.count_value(node, "repeat", repeat_counts.lowest, repeat_counts.highest);
       },
       [](const SweepRequest& request) { return fmt::format("{}", request.repeats); }}};
  return settings;
}

std::vector<std::string_view> StudySettingsReader::with_settings(std::vector<std::string_view> keys) {
  for (const Setting& one : all()) keys.push_back(one.key);
  return keys;
}

std::vector<const toml::node*> StudySettingsReader::values_of(const toml::node& node,
                                                              std::string_view key) const {
  const auto* list = node.as_array();
  if (list == nullptr) return {&node};
  std::vector<const toml::node*> values;
  for (const auto& one : *list) values.push_back(&one);
  if (values.empty()) reject(position_of(node), fmt::format("{}: is an empty list, must have a value", key));
  return values;
}

void StudySettingsReader::read_steps(const toml::node& node, SweepRequest& request) const {
  for (const toml::node* steps : values_of(node, "steps"))
    request.resolutions.emplace_back(count_value(*steps, "steps", step_counts.lowest, step_counts.highest));
}

void StudySettingsReader::read_accuracies(const toml::node& node, SweepRequest& request) const {
  for (const toml::node* one : values_of(node, "accuracies")) {
    const double accuracy = number_value(*one, "accuracies");
    require_in("accuracy", accuracy, positive);
    request.resolutions.emplace_back(Tolerance{.rtol = accuracy, .atol = accuracy});
  }
}

StudySettings StudySettingsReader::settings_of(const toml::table& study, const toml::table& family) const {
  StudySettings settings;
  for (const auto& [key, read, text] : all()) {
    const auto* node = family.get(key);
    if (node == nullptr) node = study.get(key);
    if (node == nullptr) continue;
    settings.places.emplace(key, position_of(*node));
    try {
      read(*this, *node, settings.request);
    } catch (const FileError&) {
      throw;
    } catch (const Refusal& refusal) {
      reject(position_of(*node), refusal.said(study_key).what());
    } catch (const std::invalid_argument& wrong) {
      reject(position_of(*node), wrong.what());
    }
  }
  return settings;
}

void reject_settings(const Refusal& refusal, const StudySettings& settings, const std::string& file,
                     const TextPosition& family) {
  const auto place = settings.places.find(study_key(refusal.field()));
  reject_at(file, place != settings.places.end() ? place->second : family, refusal.said(study_key).what());
}

std::string text_of(const StudySettings& settings) {
  std::string text;
  for (const auto& one : StudySettingsReader::all()) {
    if (settings.places.contains(std::string(one.key)))
      text += fmt::format("{} = {}\n", one.key, one.text(settings.request));
  }
  return text;
}

}  // namespace fde::bench
