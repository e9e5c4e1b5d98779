// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/declaration_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "fdebench/benchmarks/expressions/formula.hpp"
#include "fdebench/benchmarks/text/entry_named.hpp"
#include "fdebench/benchmarks/text/printable.hpp"

namespace fde::bench {

bool is_added_column(std::string_view name) {
  constexpr std::array<std::string_view, 3> added{"energy", "constraint", "bound"};
  return std::ranges::find(added, name) != added.end();
}

std::string DeclarationReader::printable_text(const toml::node& node, std::string_view name) const {
  constexpr std::size_t longest = 200;
  const auto* text = node.as_string();
  if (text == nullptr) reject_kind(node, name, "a text");
  if (text->get().size() > longest || !is_printable(text->get()))
    reject(position_of(node), fmt::format("{}: must be at most {} bytes that print", name, longest));
  return text->get();
}

void DeclarationReader::require_name(const TomlEntry& entry, std::string_view kind) const {
  if (!is_name(entry.name)) {
    reject(entry.position,
           fmt::format("{} {}: must be letters, digits and _, at most 64, a letter first", kind, entry.name));
  }
  if (is_symbol(entry.name) || (kind != "parameter" && is_function(entry.name))) {
    reject(entry.position,
           fmt::format("{} {}: must be another name, formulas know this one", kind, entry.name));
  }
}

double DeclarationReader::number_of(const toml::node& node, std::string_view name) const {
  if (!node.is_number()) reject_kind(node, name, "a number");
  const double number = *node.value<double>();
  if (!std::isfinite(number))
    reject(position_of(node), fmt::format("{} = {}: must be a finite number", name, number));
  return number;
}

Range DeclarationReader::range_of(const toml::table& of) const {
  Range range;
  const auto set = [&](std::string_view open, std::string_view closed, double& end, bool& is_open) {
    const auto *above = of.get(open), *from = of.get(closed);
    if (above != nullptr && from != nullptr)
      reject(position_of(*from), fmt::format("{}: must not be given with {}", closed, open));
    is_open = above != nullptr;
    if (above != nullptr) end = number_of(*above, open);
    if (from != nullptr) end = number_of(*from, closed);
  };
  set("above", "at_least", range.low, range.open_low);
  set("below", "at_most", range.high, range.open_high);
  return range;
}

std::vector<std::string> DeclarationReader::choices_of(const toml::node& node) const {
  constexpr std::string_view allowed = "a list of two or more words";
  std::vector<std::string> choices;
  for (const auto& word : array(node, "choices", allowed)) {
    const std::string text = printable_text(word, "choices");
    if (!is_name(text) || std::ranges::find(choices, text) != choices.end()) {
      reject(position_of(word),
             fmt::format("choices: {}: must be a new word of letters, digits and _", text));
    }
    choices.push_back(text);
  }
  if (choices.size() < 2) reject(position_of(node), fmt::format("choices: must be {}", allowed));
  return choices;
}

ParameterText DeclarationReader::described_parameter(const TomlEntry& entry) const {
  const auto& of = *entry.node->as_table();
  const auto name = fmt::format("parameter {}", entry.name);
  require_keys(of, name, {"value", "formula", "choices", "above", "at_least", "below", "at_most", "meaning"});
  const auto *value = of.get("value"), *formula_node = of.get("formula"), *choices = of.get("choices");
  const std::array<const toml::node*, 3> given{value, formula_node, choices};
  if (std::ranges::count(given, nullptr) != 2)
    reject(entry.position, fmt::format("{}: must have one of value, formula and choices", name));
  const auto* meaning_node = of.get("meaning");
  const std::string meaning =
      meaning_node == nullptr ? "of the file" : printable_text(*meaning_node, "meaning");
  if (choices != nullptr) return {.declared = choice(entry.name, choices_of(*choices), meaning)};
  const Range range = range_of(of);
  if (formula_node != nullptr) {
    const auto written = formula(*formula_node, "formula");
    return {.declared = derived_number(entry.name, written.text, range, meaning), .formula = written};
  }
  const double number = number_of(*value, entry.name);
  if (!range.contains(number))
    reject(position_of(*value), fmt::format("{} = {}: must be {}", entry.name, number, range.text()));
  return {.declared = {entry.name, number, range, meaning}};
}

ParameterText DeclarationReader::parameter_of(const TomlEntry& entry) const {
  require_name(entry, "parameter");
  if (entry.name == "until")
    reject(entry.position, "parameter until: must be another name, this one sets the end");
  if (entry.node->is_table()) return described_parameter(entry);
  if (entry.node->is_string())
    reject_kind(*entry.node, entry.name, fmt::format("a number, or {} = {{ formula = ... }}", entry.name));
  return {.declared = {entry.name, number_of(*entry.node, entry.name), any_number, "of the file"}};
}

std::vector<ParameterText> DeclarationReader::parameters_of(const toml::node& node) const {
  std::vector<ParameterText> parameters;
  for (const auto& entry : entries(node, "parameters")) parameters.push_back(parameter_of(entry));
  return parameters;
}

const Parameter& DeclarationReader::known_parameter(const TomlEntry& entry,
                                                    const std::vector<ParameterText>& known) const {
  std::vector<std::string_view> names;
  for (const auto& one : known) {
    if (one.declared.name == entry.name) return one.declared;
    names.push_back(one.declared.name);
  }
  reject(entry.position, fmt::format("{}: no such parameter{}; there are {}", entry.name,
                                     did_you_mean(entry.name, names), fmt::join(names, ", ")));
}

ParameterValues DeclarationReader::unless_of(const toml::table& of,
                                             const std::vector<ParameterText>& known) const {
  const auto* node = of.get("unless");
  if (node == nullptr) return {};
  ParameterValues values;
  for (const auto& entry : entries(*node, "unless")) {
    const auto& parameter = known_parameter(entry, known);
    const bool is_word = !parameter.choices.empty();
    const ParameterValue value = is_word ? ParameterValue(printable_text(*entry.node, entry.name))
                                         : ParameterValue(number_of(*entry.node, entry.name));
    if (!parameter.allows(value)) {
      reject(position_of(*entry.node),
             fmt::format("{} = {}: must be {}", entry.name, to_text(value), parameter.allowed()));
    }
    values.emplace(entry.name, value);
  }
  return values;
}

RequirementText DeclarationReader::requirement_of(const toml::node& node,
                                                  const std::vector<ParameterText>& known) const {
  using Condition = RequirementText::Condition;
  constexpr std::array conditions{std::pair{"not_zero", Condition::not_zero},
                                  std::pair{"not_negative", Condition::is_not_negative},
                                  std::pair{"positive", Condition::is_positive}};
  const auto& of = table(node, "require");
  const auto place = position_of(node);
  require_keys(of, "require", {"parameter", "not_zero", "not_negative", "positive", "allowed", "unless"});
  const auto& parameter = required(of, place, "require", "parameter");
  const auto name = printable_text(parameter, "parameter");
  [[maybe_unused]] const auto& found = known_parameter({name, position_of(parameter), &parameter}, known);
  RequirementText requirement{.parameter = name,
                              .allowed = printable_text(required(of, place, "require", "allowed"), "allowed"),
                              .unless = unless_of(of, known)};
  int given = 0;
  for (const auto& [key, kind] : conditions) {
    const auto* node_of_key = of.get(key);
    if (node_of_key == nullptr) continue;
    ++given;
    requirement.condition = kind;
    requirement.formula = formula(*node_of_key, key);
  }
  if (given != 1) reject(place, "require: must have one of not_zero, not_negative and positive");
  return requirement;
}

std::vector<RequirementText> DeclarationReader::requirements_of(
    const toml::node& node, const std::vector<ParameterText>& known) const {
  constexpr std::size_t most = 100;
  const auto& list = array(node, "require", "tables [[require]]");
  if (list.size() > most) {
    reject(position_of(node),
           fmt::format("there are {} requirements: must be at most {}", list.size(), most));
  }
  std::vector<RequirementText> requirements;
  for (const auto& one : list) requirements.push_back(requirement_of(one, known));
  return requirements;
}

std::vector<ColumnText> DeclarationReader::columns_of(const toml::node& node,
                                                      const std::vector<ParameterText>& known) const {
  constexpr std::size_t most = 1000;
  const auto found = entries(node, "columns");
  if (found.empty() || found.size() > most)
    reject(position_of(node), fmt::format("there are {} columns: must be 1 to {}", found.size(), most));
  std::vector<ColumnText> columns;
  for (const auto& entry : found) {
    if (!is_name(entry.name) || is_added_column(entry.name)) {
      reject(entry.position,
             fmt::format("column {}: must be letters, digits and _, a letter first, and no name of a column "
                         "that a command adds",
                         entry.name));
    }
    ColumnText column{.name = entry.name, .position = entry.position};
    if (const auto* of = entry.node->as_table()) {
      const auto name = fmt::format("column {}", entry.name);
      require_keys(*of, name, {"value", "unless"});
      column.formula = formula(required(*of, entry.position, name, "value"), "value");
      column.unless = unless_of(*of, known);
    } else {
      column.formula = formula(*entry.node, entry.name);
    }
    columns.push_back(std::move(column));
  }
  return columns;
}

DomainText DeclarationReader::domain_of(const toml::node& node) const {
  const auto& of = table(node, "domain");
  const auto place = position_of(node);
  require_keys(of, "domain", {"edge", "positive"});
  return {.edge = printable_text(required(of, place, "domain", "edge"), "edge"),
          .positive = formula(required(of, place, "domain", "positive"), "positive")};
}

}  // namespace fde::bench
