// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/parameters.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/text/entry_named.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"

namespace fde::bench {

namespace {

// A list is shown in brackets if the parameter is not a list.
std::string shown(const ParameterValue& value, const Parameter& parameter) {
  const bool list = std::holds_alternative<std::vector<double>>(value);
  return list && value.index() != parameter.value.index() ? fmt::format("[{}]", to_text(value))
                                                          : to_text(value);
}

}  // namespace

std::string to_text(const ParameterValue& value) {
  if (const auto* numbers = std::get_if<std::vector<double>>(&value))
    return fmt::format("{}", fmt::join(*numbers, ","));
  const auto* word = std::get_if<std::string>(&value);
  return word != nullptr ? *word : fmt::format("{}", std::get<double>(value));
}

ParameterValue parse_value(std::string_view text) {
  if (const auto number = try_parse_number(text)) return *number;
  if (auto numbers = try_parse_numbers(text); numbers && !numbers->empty()) return std::move(*numbers);
  return std::string(text);
}

bool Parameter::allows(const ParameterValue& given) const {
  if (const auto* word = std::get_if<std::string>(&given)) {
    return std::ranges::find(choices, *word) != choices.end() ||
           (!default_formula.empty() && *word == default_formula);
  }
  const bool list = std::holds_alternative<std::vector<double>>(value);
  const auto fits = [this](double number) { return range.contains(number); };
  if (const auto* numbers = std::get_if<std::vector<double>>(&given))
    return list && std::ranges::all_of(*numbers, fits);
  return choices.empty() && !list && fits(std::get<double>(given));
}

std::string Parameter::allowed() const {
  if (!choices.empty()) return fmt::format("one of {}", fmt::join(choices, ", "));
  if (std::holds_alternative<std::vector<double>>(value)) return fmt::format("a list, each {}", range.text());
  return default_formula.empty() ? range.text() : fmt::format("{}, or {}", range.text(), default_formula);
}

ParameterValue Parameter::read(std::string_view text) const {
  std::string suggestion;
  if (!choices.empty()) {
    if (std::ranges::find(choices, text) != choices.end()) return std::string(text);
    suggestion = did_you_mean(text, {choices.begin(), choices.end()});
  } else if (std::holds_alternative<std::vector<double>>(value)) {
    if (const auto numbers = try_parse_numbers(text)) return *numbers;
  } else if (const auto number = try_parse_number(text)) {
    return *number;
  } else if (!default_formula.empty() && text == default_formula) {
    return default_formula;
  }
  throw std::invalid_argument(
      fmt::format("{} = {}: {}must be {}{}", name, text, double_range_message(text), allowed(), suggestion));
}

Parameter choice(std::string name, std::vector<std::string> choices, std::string meaning) {
  const std::string first = choices.front();
  return {std::move(name), first, any_number, std::move(meaning), std::move(choices)};
}

Parameter derived_number(std::string name, std::string formula, Range range, std::string meaning) {
  return {std::move(name), formula, range, std::move(meaning), {}, formula};
}

Parameter list_of_numbers(std::string name, std::vector<double> numbers, Range range, std::string meaning) {
  return {std::move(name), std::move(numbers), range, std::move(meaning)};
}

const Parameter& parameter_named(std::string_view name, std::string_view scene,
                                 const std::vector<Parameter>& parameters) {
  const auto parameter = std::ranges::find(parameters, name, &Parameter::name);
  if (parameter != parameters.end()) return *parameter;
  std::vector<std::string_view> names;
  for (const auto& known : parameters) names.push_back(known.name);
  throw std::invalid_argument(fmt::format("{}: scene {} has no such parameter{}; it has {}", name, scene,
                                          did_you_mean(name, names), fmt::join(names, ", ")));
}

Parameters::Parameters(std::string_view scene, const std::vector<Parameter>& parameters,
                       const ParameterValues& values) {
  for (const auto& parameter : parameters) values_.emplace(parameter.name, parameter.value);
  for (const auto& [name, value] : values) {
    const auto& parameter = parameter_named(name, scene, parameters);
    if (!parameter.allows(value)) reject_text(name, shown(value, parameter), parameter.allowed());
    values_.at(name) = value;
  }
}

double Parameters::operator[](std::string_view name) const {
  return std::get<double>(values_.at(std::string(name)));
}

const std::string& Parameters::choice(std::string_view name) const {
  return std::get<std::string>(values_.at(std::string(name)));
}

std::optional<double> Parameters::explicit_value(std::string_view name) const {
  const auto* number = std::get_if<double>(&values_.at(std::string(name)));
  return number == nullptr ? std::nullopt : std::optional(*number);
}

const std::vector<double>& Parameters::numbers(std::string_view name) const {
  return std::get<std::vector<double>>(values_.at(std::string(name)));
}

const ParameterValue& Parameters::value(std::string_view name) const { return values_.at(std::string(name)); }

std::string Parameters::text() const {
  std::string text;
  for (const auto& [name, value] : values_)
    text += fmt::format("{}{}={}", text.empty() ? "" : " ", name, to_text(value));
  return text;
}

void reject(std::string_view name, const ParameterValue& value, std::string_view allowed) {
  reject_text(name, to_text(value), allowed);
}

std::string settings_text(const SceneSettings& scene) {
  std::vector<std::string> texts;
  for (const auto& [name, value] : scene.values) texts.push_back(fmt::format("{}={}", name, to_text(value)));
  if (scene.until) texts.push_back(fmt::format("until={}", *scene.until));
  return fmt::format("{}", fmt::join(texts, ","));
}

std::string label_of(const SceneSettings& scene) {
  const auto settings = settings_text(scene);
  return settings.empty() ? scene.id : fmt::format("{}:{}", scene.id, settings);
}

std::string short_checksum(const SceneSettings& scene) {
  constexpr std::size_t digits = 8;
  return scene.checksum.substr(0, digits);
}

}  // namespace fde::bench
