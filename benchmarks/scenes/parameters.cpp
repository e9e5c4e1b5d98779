#include "scenes/parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace fde {
namespace {

// Levenshtein distance.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substitute = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({substitute, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

bool Range::contains(double value) const {
  return std::isfinite(value) && (open_low ? value > low : value >= low) &&
         (open_high ? value < high : value <= high);
}

std::string Range::text() const {
  const bool below = low > any_number.low, above = high < any_number.high;
  if (!below && !above) return "a finite number";
  if (!above) return fmt::format("a finite number {} {}", open_low ? "above" : "of at least", low);
  return fmt::format("a number in {}{}, {}{}", open_low ? '(' : '[', low, high, open_high ? ')' : ']');
}

std::string Parameter::allowed() const {
  return choices.empty() ? range.text() : fmt::format("one of {}", fmt::join(choices, ", "));
}

std::string Parameter::text_of(double number) const {
  return choices.empty() ? fmt::format("{}", number)
                         : std::string(choices.at(static_cast<std::size_t>(number)));
}

double Parameter::read(std::string_view text) const {
  if (const auto found = std::ranges::find(choices, text); found != choices.end())
    return static_cast<double>(found - choices.begin());
  const auto digits = text.substr(text.starts_with('+') ? 1 : 0);
  double number = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (!choices.empty() || error != std::errc{} || end != digits.data() + digits.size()) {
    throw std::invalid_argument(fmt::format("--set {} = {}: must be {}{}", name, text, allowed(),
                                            choices.empty() ? "" : nearest(text, choices)));
  }
  return number;
}

Parameter choice(std::string_view name, std::vector<std::string_view> choices, std::string_view meaning) {
  const Range places{.low = 0.0, .high = static_cast<double>(choices.size() - 1)};
  return {name, 0.0, places, meaning, std::move(choices)};
}

const Parameter& parameter_named(std::string_view name, std::string_view scene,
                                 const std::vector<Parameter>& parameters) {
  const auto parameter = std::ranges::find(parameters, name, &Parameter::name);
  if (parameter != parameters.end()) return *parameter;
  std::vector<std::string_view> names;
  for (const auto& known : parameters) names.push_back(known.name);
  throw std::invalid_argument(fmt::format("{}: scene {} has no such parameter{}; it has {}", name, scene,
                                          nearest(name, names), fmt::join(names, ", ")));
}

Parameters::Parameters(std::string_view scene, const std::vector<Parameter>& parameters,
                       const std::map<std::string, double>& values) {
  for (const auto& parameter : parameters) values_.emplace(parameter.name, parameter.value);
  for (const auto& [name, value] : values) {
    const auto& parameter = parameter_named(name, scene, parameters);
    const bool placed = parameter.choices.empty() || value == std::floor(value);
    if (!placed || !parameter.range.contains(value)) reject(name, value, parameter.allowed());
    values_.find(name)->second = value;
  }
}

std::string Parameters::text() const {
  std::string text;
  for (const auto& [name, value] : values_)
    text += fmt::format("{}{}={}", text.empty() ? "" : " ", name, value);
  return text;
}

void reject(std::string_view name, double value, std::string_view allowed) {
  throw std::invalid_argument(fmt::format("{} = {}: must be {}", name, value, allowed));
}

std::string nearest(std::string_view name, const std::vector<std::string_view>& candidates) {
  const auto distance = [=](std::string_view candidate) { return edit_distance(name, candidate); };
  const auto best = std::ranges::min_element(candidates, {}, distance);
  return best == candidates.end() ? "" : fmt::format(", did you mean '{}'?", *best);
}

void no_such(std::string_view kind, std::string_view id, const std::vector<std::string_view>& ids) {
  throw std::invalid_argument(fmt::format("{} {}: no such {}{}; there are {}", kind, id, kind,
                                          nearest(id, ids), fmt::join(ids, ", ")));
}

}  // namespace fde
