// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/study/study_points.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <stdexcept>

#include "fdebench/benchmarks/study/exact_numbers.hpp"
#include "fdebench/benchmarks/study/study.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/benchmarks/text/range.hpp"

namespace fde::bench {
namespace {

constexpr int most_values = static_cast<int>(max_study_scenes);

bool is_distribution(const toml::node& node) {
  const auto* of = node.as_table();
  return of != nullptr && of->get("distribution") != nullptr;
}

bool takes_list(const Parameter& parameter) {
  return std::holds_alternative<std::vector<double>>(parameter.value);
}

}  // namespace

struct StudyPoints::DrawnParameter {
  enum class Kind { uniform, log_uniform, normal };

  const Parameter* parameter;
  TextPosition position;
  Kind kind = Kind::uniform;
  double first = 0.0, second = 1.0;  // from and to, or mean and deviation
  Range within{};                    // draws of a normal distribution outside are repeated

  // nullopt: no draw of a thousand is within the range.
  [[nodiscard]] std::optional<double> draw(NumberSource& source) const {
    if (kind == Kind::uniform) return source.uniform(first, second);
    if (kind == Kind::log_uniform) return source.uniform(first, second, Spacing::logarithmic);
    constexpr int attempts = 1000;
    for (int attempt = 0; attempt < attempts; ++attempt) {
      const double value = source.normal(first, second);
      if (within.contains(value)) return value;
    }
    return std::nullopt;
  }
};

std::string StudyPoints::text_value(const toml::node& node, std::string_view name) const {
  if (const auto* text = node.as_string()) return text->get();
  reject_kind(node, name, "a text");
}

double StudyPoints::number_value(const toml::node& node, std::string_view name) const {
  // node.value<double>() has no value for a whole number that rounds.
  if (const auto* whole = node.as_integer()) return static_cast<double>(whole->get());
  const auto* number = node.as_floating_point();
  if (number == nullptr) reject_kind(node, name, "a number");
  if (!std::isfinite(number->get()))
    reject(position_of(node), fmt::format("{} = {}: must be {}", name, number->get(), any_number.text()));
  return number->get();
}

int StudyPoints::count_value(const toml::node& node, std::string_view name, int lowest, int highest) const {
  const auto allowed = CountRange{lowest, highest}.text();
  if (!node.is_number()) reject_kind(node, name, allowed);
  const double number = number_value(node, name);
  if (number != std::floor(number) || number < lowest || number > highest) {
    const auto* whole = node.as_integer();
    const auto value = whole == nullptr ? fmt::format("{}", number) : fmt::format("{}", whole->get());
    reject(position_of(node), fmt::format("{} = {}: must be {}", name, value, allowed));
  }
  return static_cast<int>(number);
}

double StudyPoints::number_at(const toml::table& of, const TextPosition& place, std::string_view name,
                              std::string_view key) const {
  return number_value(required(of, place, name, key), fmt::format("{}.{}", name, key));
}

const Parameter& StudyPoints::declared(const TomlEntry& entry, const SceneFactory& factory) const {
  static const Parameter until{.name = "until", .value = 1.0, .range = valid_end_times, .description = {}};
  if (entry.name == until.name) return until;
  try {
    return parameter_named(entry.name, factory.id, factory.parameters);
  } catch (const std::invalid_argument& unknown) {
    reject(entry.position, unknown.what());
  }
}

void StudyPoints::require_allowed(const TextPosition& place, const ParameterValue& value,
                                  const Parameter& parameter) const {
  if (!parameter.allows(value)) {
    reject(place, fmt::format("{} = {}: must be {}", parameter.name, to_text(value), parameter.allowed()));
  }
}

ParameterValue StudyPoints::value_of(const toml::node& node, const Parameter& parameter) const {
  ParameterValue value;
  if (const auto* list = node.as_array(); list != nullptr && takes_list(parameter)) {
    std::vector<double> numbers;
    for (const auto& number : *list) numbers.push_back(number_value(number, parameter.name));
    value = std::move(numbers);
  } else if (node.is_string() && (!parameter.choices.empty() || !parameter.default_formula.empty())) {
    value = text_value(node, parameter.name);
  } else if (node.is_number()) {
    value = number_value(node, parameter.name);
  } else {
    reject_kind(node, parameter.name, parameter.allowed());
  }
  require_allowed(position_of(node), value, parameter);
  return value;
}

void StudyPoints::require_one_sign(const TextPosition& place, std::string_view name, double from,
                                   double to) const {
  if ((from > 0.0 && to > 0.0) || (from < 0.0 && to < 0.0)) return;
  reject(place, fmt::format("{}: from {} to {}: must be two numbers of one sign, their logarithms are taken",
                            name, from, to));
}

std::vector<ParameterValue> StudyPoints::range_of(const toml::node& node, const Parameter& parameter) const {
  const auto& name = parameter.name;
  const auto& of = table(node, name);
  const auto place = position_of(node);
  require_keys(of, fmt::format("the range of {}", name), {"from", "to", "step", "count", "spacing"});
  const double from = number_at(of, place, name, "from"), to = number_at(of, place, name, "to");
  const auto *step = of.get("step"), *count = of.get("count"), *spacing = of.get("spacing");
  if ((step == nullptr) == (count == nullptr))
    reject(place, fmt::format("{}: must have either step or count", name));
  std::vector<ParameterValue> values;
  if (step != nullptr) {
    if (spacing != nullptr)
      reject(position_of(*spacing), fmt::format("{}: spacing: must be with count", name));
    const double size = number_value(*step, fmt::format("{}.step", name));
    if (!(from <= to ? size > 0.0 : size < 0.0)) {
      reject(position_of(*step),
             fmt::format("{}.step = {}: must lead from {} towards {}", name, size, from, to));
    }
    const auto text = fmt::format("{}:{}:{}", from, to, size);
    try {
      for (const auto& value : expand_decimal_range(name, text, max_study_scenes))
        values.emplace_back(parse_number(name, value, any_number));
    } catch (const std::invalid_argument& wrong) {
      reject(place, wrong.what());
    }
  } else {
    const auto word = spacing == nullptr ? "linear" : text_value(*spacing, fmt::format("{}.spacing", name));
    if (word != "linear" && word != "log") {
      reject(position_of(*spacing), fmt::format(R"({}.spacing = {}: must be "linear" or "log")", name, word));
    }
    const auto scale = word == "log" ? Spacing::logarithmic : Spacing::linear;
    if (scale == Spacing::logarithmic) require_one_sign(place, name, from, to);
    const int number = count_value(*count, fmt::format("{}.count", name), 2, most_values);
    for (int i = 0; i < number; ++i) values.emplace_back(spaced_number(from, to, i, number, scale));
  }
  for (const auto& value : values) require_allowed(place, value, parameter);
  return values;
}

std::vector<ParameterValue> StudyPoints::values_of(const toml::node& node, const Parameter& parameter) const {
  if (node.is_table()) return range_of(node, parameter);
  const auto* list = node.as_array();
  const bool is_one =
      list == nullptr || (takes_list(parameter) && !list->empty() && !list->front().is_array());
  if (is_one) return {value_of(node, parameter)};
  if (list->empty())
    reject(position_of(node), fmt::format("{}: is an empty list, must have a value", parameter.name));
  std::vector<ParameterValue> values;
  for (const auto& value : *list) values.push_back(value_of(value, parameter));
  return values;
}

StudyPoints::DrawnParameter StudyPoints::drawn_of(const toml::node& node, const Parameter& parameter) const {
  const auto& name = parameter.name;
  const auto& of = table(node, name);
  DrawnParameter drawn{.parameter = &parameter, .position = position_of(node)};
  const auto& word_node = *of.get("distribution");
  const auto word = text_value(word_node, fmt::format("{}.distribution", name));
  const auto what = fmt::format("the distribution of {}", name);
  if (word == "normal") {
    require_keys(of, what, {"distribution", "mean", "deviation", "from", "to"});
    drawn.kind = DrawnParameter::Kind::normal;
    drawn.first = number_at(of, drawn.position, name, "mean");
    drawn.second = number_at(of, drawn.position, name, "deviation");
    if (!(drawn.second > 0.0)) {
      reject(position_of(*of.get("deviation")),
             fmt::format("{}.deviation = {}: must be {}", name, drawn.second, positive.text()));
    }
    if (of.get("from") != nullptr) drawn.within.low = number_at(of, drawn.position, name, "from");
    if (of.get("to") != nullptr) drawn.within.high = number_at(of, drawn.position, name, "to");
    return drawn;
  }
  if (word != "uniform" && word != "log-uniform") {
    reject(position_of(word_node),
           fmt::format(R"({}.distribution = {}: must be "uniform", "log-uniform" or "normal")", name, word));
  }
  require_keys(of, what, {"distribution", "from", "to"});
  drawn.kind = word == "uniform" ? DrawnParameter::Kind::uniform : DrawnParameter::Kind::log_uniform;
  drawn.first = number_at(of, drawn.position, name, "from");
  drawn.second = number_at(of, drawn.position, name, "to");
  if (drawn.kind == DrawnParameter::Kind::log_uniform)
    require_one_sign(drawn.position, name, drawn.first, drawn.second);
  return drawn;
}

StudyPoints::Axis StudyPoints::draws_of(const toml::table& family,
                                        const std::vector<DrawnParameter>& drawn) const {
  const auto *draws = family.get("draws"), *seed = family.get("seed");
  if (drawn.empty()) {
    for (const auto* node : {draws, seed}) {
      if (node != nullptr)
        reject(position_of(*node), "draws and seed: must be with a parameter that has a distribution");
    }
    return {};
  }
  if (draws == nullptr) {
    reject(drawn.front().position,
           fmt::format("{}: has a distribution: the family must have draws", drawn.front().parameter->name));
  }
  constexpr int most_seed = 2'000'000'000;
  const int count = count_value(*draws, "draws", 1, most_values);
  NumberSource source(seed == nullptr ? 1U : static_cast<unsigned>(count_value(*seed, "seed", 0, most_seed)));
  Axis axis(static_cast<std::size_t>(count));
  for (auto& point : axis) {
    for (const auto& one : drawn) {
      const auto value = one.draw(source);
      if (!value) {
        reject(one.position,
               fmt::format("{}: no draw of a thousand is within its from and to: must be likelier there",
                           one.parameter->name));
      }
      require_allowed(one.position, *value, *one.parameter);
      point.emplace_back(one.parameter->name, *value);
    }
  }
  return axis;
}

StudyPoints::Axis StudyPoints::listed_points(const toml::node& node, const SceneFactory& factory) const {
  const auto& list = array(node, "points", "a list of tables {NAME = VALUE, ...}");
  if (list.empty()) reject(position_of(node), "points: is an empty list, must have a point");
  Axis axis;
  for (const auto& one : list) {
    auto& point = axis.emplace_back();
    for (const auto& entry : entries(one, "a point"))
      point.emplace_back(entry.name, value_of(*entry.node, declared(entry, factory)));
  }
  return axis;
}

std::vector<StudyPoints::Axis> StudyPoints::axes_of(const toml::table& family, const TextPosition& place,
                                                    const SceneFactory& factory) const {
  std::vector<Axis> axes;
  if (const auto* points = family.get("points")) axes.push_back(listed_points(*points, factory));
  std::vector<TomlEntry> varied;
  if (const auto* parameters = family.get("parameters")) varied = entries(*parameters, "parameters");
  if (const auto* until = family.get("until")) varied.push_back({"until", place, until});
  std::vector<DrawnParameter> drawn;
  for (const auto& entry : varied) {
    const auto& parameter = declared(entry, factory);
    if (is_distribution(*entry.node)) {
      drawn.push_back(drawn_of(*entry.node, parameter));
      continue;
    }
    auto& axis = axes.emplace_back();
    for (auto& value : values_of(*entry.node, parameter)) axis.push_back({{entry.name, std::move(value)}});
  }
  if (auto axis = draws_of(family, drawn); !axis.empty()) axes.push_back(std::move(axis));
  return axes;
}

std::vector<SceneVariant> StudyPoints::scenes_of(const toml::table& family, const TextPosition& place,
                                                 const SceneFactory& factory) const {
  std::vector<SceneVariant> scenes{{.factory = &factory}};
  for (const auto& axis : axes_of(family, place, factory)) {
    if (axis.size() * scenes.size() > max_study_scenes) {
      reject(place,
             fmt::format("the family has more than {} scenes, the most that are allowed", max_study_scenes));
    }
    std::vector<SceneVariant> more;
    for (const auto& scene : scenes) {
      for (const auto& point : axis) {
        auto& next = more.emplace_back(scene);
        for (const auto& [name, value] : point) {
          const bool is_first = name == "until" ? !next.until : next.values.emplace(name, value).second;
          if (!is_first) reject(place, fmt::format("{}: must have one value in a point", name));
          if (name == "until") next.until = std::get<double>(value);
        }
      }
    }
    scenes = std::move(more);
  }
  for (const auto& scene : scenes) {
    try {
      [[maybe_unused]] const Scene checked = make_scene(scene);
    } catch (const std::invalid_argument& ill_posed) {
      reject(place, fmt::format("{}: {}", scene.label(), ill_posed.what()));
    }
  }
  return scenes;
}

}  // namespace fde::bench
