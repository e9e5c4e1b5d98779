#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scenes/registry.hpp"
#include "scenes/scene_settings.hpp"

namespace fde {

// A scene with some parameters, or its end, replaced. In results and on the command line:
// "pendulum:alpha=1.9,beta=0.1,until=100", "multi_term:alpha=1.2,1.6,c=0".
struct SceneVariant {
  const SceneMaker* maker;  // of a registry that lives as long
  ParameterValues values{};
  std::optional<double> until{};  // the end of the time interval

  [[nodiscard]] SceneSettings key() const;
  [[nodiscard]] std::string label() const { return label_of(key()); }
};

// The scene made from its defaults with some values replaced. Throws std::invalid_argument where it has no
// problem to solve.
Scene make_scene(const SceneMaker& maker, const ParameterValues& values = {});

// The same for what is known about it, which does not depend on the form of its problem, nor on whether that
// form can be solved.
Scene make_known_scene(const SceneMaker& maker, const ParameterValues& values = {});

// make_scene, up to the end that the variant gives. Throws std::invalid_argument where the scene is posed at
// both ends and has another.
Scene make_scene(const SceneVariant& variant);

// "pendulum" or "pendulum:alpha=1.9,beta=0.1", "pendulum:beta=0.1,until=100" with another end; further
// settings NAME=VALUE, each name once. Throws std::invalid_argument naming what is wrong and what is allowed.
SceneVariant read_variant(const std::string& text, const std::vector<std::string>& settings,
                          const Scenes& among = scenes());

// The same of a scene that need not be known, as that of a file that is not at hand: its values are numbers.
// No checksum.
SceneSettings read_settings(const std::string& text, const std::vector<std::string>& settings);

// A scene for each value of a range NAME=FIRST:LAST:STEP among the settings, which may be decreasing; for
// each choice of values where there are several ranges, the last of which runs fastest. Values are decimals:
// 0.1:0.9:0.1 has 0.3. Throws as read_variant does, and where a range has no value or there are more than
// most_variants.
inline constexpr std::size_t most_variants = 1000;
std::vector<SceneVariant> read_variants(const std::string& text, const std::vector<std::string>& settings,
                                        const Scenes& among = scenes());

// The same, with a problem to solve.
SceneVariant parse_variant(const std::string& text, const Scenes& among = scenes());
SceneVariant parse_variant(const std::string& text, const std::vector<std::string>& settings,
                           const Scenes& among = scenes());
std::vector<SceneVariant> parse_variants(const std::string& text, const std::vector<std::string>& settings,
                                         const Scenes& among = scenes());

// Ends of time intervals: their products with a number of steps, and the inverses of these, are doubles.
inline constexpr Range any_end{.low = 1e-290, .high = 1e290};

}  // namespace fde
