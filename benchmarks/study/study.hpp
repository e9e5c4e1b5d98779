// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "fdebench/benchmarks/equation_files/equation_text.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/benchmarks/study/study_settings.hpp"
#include "fdebench/benchmarks/sweep/sweep.hpp"

namespace fde::bench {

// Variants of one scene that are run with the same settings.
struct StudyFamily {
  TextPosition position{};
  std::vector<SceneVariant> scenes{};
  StudySettings settings{};
};

// The contents of a study file: docs/studies.md.
struct Study {
  std::string file{}, title{}, checksum{};
  std::vector<StudyFamily> families{};
};

inline constexpr std::size_t max_study_scenes = 100'000;

// Throws std::invalid_argument naming file, line and column, the key and what is allowed: if the file is no
// study, a setting is not allowed, or one of its scenes cannot be made. The id of an equation file is its
// path from the current folder if it is below it, otherwise its absolute path.
Study read_study(const std::filesystem::path& file, const SceneRegistry& known);

// One sweep for all families with the same settings, in the order of the file. Results do without the
// solutions of scenes. With `examine` no run is timed, with `undisturbed` disturbed times are repeated.
// Throws std::invalid_argument naming file, line and column, the key, its value and what is allowed, and
// Refusal naming these two.
std::vector<Sweep> sweeps_of(const Study& study, bool examine = false, bool undisturbed = false);

// The text of a study file in `folder` that lists the scenes as points, and the settings in each family.
std::string text_of(const Study& study, const std::filesystem::path& folder);

}  // namespace fde::bench
