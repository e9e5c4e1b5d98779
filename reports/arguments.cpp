#include "arguments.hpp"

#include <fmt/format.h>

#include <charconv>
#include <limits>
#include <stdexcept>

namespace fde {
namespace {

[[noreturn]] void reject_text(std::string_view name, std::string_view text, std::string_view allowed) {
  throw std::invalid_argument(fmt::format("{} = {}: must be {}", name, text, allowed));
}

// The whole text as a number; false when it is not one.
template <typename Number>
bool read(std::string_view text, Number& number) {
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc{} && end == text.data() + text.size();
}

template <typename Entries>
const auto& named(const Entries& entries, std::string_view kind, std::string_view id) {
  std::vector<std::string_view> ids;
  for (const auto& entry : entries) {
    if (entry.id == id) return entry;
    ids.push_back(entry.id);
  }
  throw std::invalid_argument(fmt::format("{} {}: no such {}{}; there are {}", kind, id, kind,
                                          nearest(id, ids), fmt::join(ids, ", ")));
}

}  // namespace

double parse_number(std::string_view name, std::string_view text, const Range& allowed) {
  double value = 0.0;
  if (!read(text, value)) reject_text(name, text, allowed.text());
  if (!allowed.contains(value)) reject(name, value, allowed.text());
  return value;
}

int parse_count(std::string_view name, std::string_view text, int lowest, int highest) {
  int value = 0;
  if (!read(text, value) || value < lowest || value > highest) {
    reject_text(name, text, fmt::format("a whole number from {} to {}", lowest, highest));
  }
  return value;
}

std::vector<std::string> split_list(std::string_view text) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const auto end = std::min(text.find(',', begin), text.size());
    parts.emplace_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

ComplexText split_complex(std::string_view text) {
  if (!text.ends_with('i')) return {std::string(text), "0"};
  text.remove_suffix(1);
  // the last sign that begins a number and not an exponent
  auto sign = text.find_last_of("+-");
  while (sign != std::string_view::npos && sign > 0 && (text[sign - 1] == 'e' || text[sign - 1] == 'E'))
    sign = text.find_last_of("+-", sign - 1);
  const std::size_t begin = sign == std::string_view::npos ? 0 : sign;
  std::string im(text.substr(begin));
  if (im.empty() || im == "+" || im == "-") im += "1";
  return {begin == 0 ? "0" : std::string(text.substr(0, begin)), im};
}

std::vector<double> parse_numbers(std::string_view name, std::string_view text, const Range& allowed) {
  std::vector<double> numbers;
  for (const auto& part : split_list(text)) numbers.push_back(parse_number(name, part, allowed));
  return numbers;
}

std::map<std::string, double> parse_settings(const SceneMaker& maker,
                                             const std::vector<std::string>& settings) {
  std::map<std::string, double> values;
  for (const auto& setting : settings) {
    const auto equals = setting.find('=');
    if (equals == std::string::npos || equals == 0) reject_text("--set", setting, "NAME=VALUE");
    const auto name = setting.substr(0, equals);
    const auto& parameter = parameter_named(name, maker.id, maker.parameters);
    const double value = parameter.read(std::string_view(setting).substr(equals + 1));
    if (!values.emplace(name, value).second) reject_text("--set", setting, "one value for each name");
  }
  return values;
}

Grid parse_grid(std::string_view text, double end, int steps) {
  constexpr std::string_view graded = "graded:";
  Grid grid{.end = end, .steps = steps};
  if (text.starts_with(graded)) {
    grid.grading = parse_number("--grid graded", text.substr(graded.size()), {.low = 1.0, .high = 100.0});
  } else if (text != "uniform") {
    reject_text("--grid", text, "uniform or graded:R with R in [1, 100]");
  }
  return grid;
}

const SceneMaker& scene_named(std::string_view id) { return named(scenes(), "scene", id); }
SceneVariant parse_variant(const std::string& text) {
  constexpr std::string_view until = "until=";
  const auto colon = text.find(':');
  SceneVariant variant{.maker = &scene_named(text.substr(0, colon))};
  if (colon == std::string::npos) return variant;
  auto settings = split_list(text.substr(colon + 1));
  const auto end =
      std::ranges::find_if(settings, [&](const auto& setting) { return setting.starts_with(until); });
  if (end != settings.end()) {
    variant.until = parse_number("until", end->substr(until.size()), any_end);
    settings.erase(end);
  }
  variant.values = parse_settings(*variant.maker, settings);
  [[maybe_unused]] const Scene checked = make_scene(variant);
  return variant;
}

std::vector<SceneVariant> default_scenes() {
  std::vector<SceneVariant> variants;
  for (const auto& maker : scenes()) variants.push_back({.maker = &maker});
  for (const auto* text :
       {"relaxation:gamma=0.2", "relaxation:gamma=1.5", "power:p=0.7", "pendulum:alpha=1.25,beta=0.75",
        "pendulum:alpha=1.9,beta=0.1", "fractional_diffusion:components=8"}) {
    variants.push_back(parse_variant(text));
  }
  return variants;
}

std::vector<SceneVariant> sweep_scenes() {
  auto variants = default_scenes();
  const auto add = [&](std::string_view scene, const std::vector<std::string_view>& settings) {
    for (const auto setting : settings)
      variants.push_back(parse_variant(fmt::format("{}:{}", scene, setting)));
  };
  const std::vector<std::string_view> others{"formulation=acceleration", "formulation=stabilised",
                                             "formulation=multiplier"};
  add("fractional_constraint_2d",
      {"formulation=multiplier", "alpha=0.3", "alpha=0.3,formulation=acceleration",
       "alpha=0.3,formulation=stabilised", "alpha=0.3,formulation=multiplier"});
  for (const auto* scene : {"nonholonomic_particle", "knife_edge", "loxodrome", "fractional_knife_edge"})
    add(scene, others);
  for (const auto* scene : {"isokinetic", "fractional_constraint_nonlinear"})
    add(scene, {"formulation=stabilised", "formulation=multiplier"});
  add("nonlinear_fractional_oscillator", {"form=integrated", "form=multiplier"});
  return variants;
}

const Scheme& scheme_named(std::string_view id) { return named(schemes(), "scheme", id); }

}  // namespace fde
