// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/scenes/parameters.hpp"
#include "fdebench/benchmarks/scenes/registry.hpp"

namespace fde::bench {

// A scene with some parameters, or its end, replaced. In results and on the command line:
// "pendulum:alpha=1.9,beta=0.1,until=100", "multi_term:alpha=1.2,1.6,c=0".
struct SceneVariant {
  const SceneFactory* factory;  // not owned: its `SceneRegistry` must outlive this object
  ParameterValues values{};
  std::optional<double> until{};  // the end of the time interval

  [[nodiscard]] SceneSettings key() const;
  // The key without the parameters of which the solution does not depend: the same for scenes with the same
  // exact columns.
  [[nodiscard]] SceneSettings key_of_solution() const;
  [[nodiscard]] std::string label() const { return label_of(key()); }
};

// The scene made from its defaults with some values replaced. Throws std::invalid_argument if its problem
// cannot be posed (Scene::ill_posed_reason).
Scene make_scene(const SceneFactory& factory, const ParameterValues& values = {});

// The same without the check of Scene::ill_posed_reason: for what is known about a scene independently of the
// form of its problem.
Scene make_scene_unchecked(const SceneFactory& factory, const ParameterValues& values = {});

// Both with the end of the variant. Throw std::invalid_argument if the scene is two-sided and the end differs
// from its own.
Scene make_scene(const SceneVariant& variant);
Scene make_scene_unchecked(const SceneVariant& variant);

// Parses "pendulum" or "pendulum:alpha=1.9,beta=0.1,until=100", where `until` replaces the end, and further
// settings NAME=VALUE, each name once. Throws std::invalid_argument naming what is wrong and what is allowed.
SceneVariant read_variant(const std::string& text, const std::vector<std::string>& settings,
                          const SceneRegistry& among = built_in_scenes());

// The same for a scene that need not exist, such as a file that is absent: values are read by parse_value,
// and the checksum is empty.
SceneSettings read_settings(const std::string& text, const std::vector<std::string>& settings);

// Like read_variant, but a setting may be a range NAME=FIRST:LAST:STEP, increasing or decreasing: one scene
// for each value, or for each combination of values of several ranges, the last range varying fastest. Values
// are exact decimals: 0.1:0.9:0.1 contains 0.3. Throws as read_variant does, and if a range is empty or there
// are more than max_variants scenes.
inline constexpr std::size_t max_variants = 1000;
std::vector<SceneVariant> read_variants(const std::string& text, const std::vector<std::string>& settings,
                                        const SceneRegistry& among = built_in_scenes());

// The same for runs that are recorded: throw std::invalid_argument if make_scene does, or where the time of
// the scene does not begin at 0.
SceneVariant parse_variant(const std::string& text, const SceneRegistry& among = built_in_scenes());
SceneVariant parse_variant(const std::string& text, const std::vector<std::string>& settings,
                           const SceneRegistry& among = built_in_scenes());
std::vector<SceneVariant> parse_variants(const std::string& text, const std::vector<std::string>& settings,
                                         const SceneRegistry& among = built_in_scenes());

// Ends of time intervals: end times a number of steps and the inverse of that do not overflow or underflow.
inline constexpr Range valid_end_times{.low = 1e-290, .high = 1e290};

// Extension of an equation file.
inline constexpr std::string_view equation_file_extension = ".toml";

// "FILE.toml" from "FILE.toml" or "FILE.toml:NAME=VALUE,..."; nullopt: the text names no equation file.
inline std::optional<std::string> equation_file_of_label(const std::string& text) {
  const auto end = text.find(std::string(equation_file_extension) + ':');
  if (end != std::string::npos) return text.substr(0, end + equation_file_extension.size());
  return text.ends_with(equation_file_extension) ? std::optional(text) : std::nullopt;
}

}  // namespace fde::bench
