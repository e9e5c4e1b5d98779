// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/equation_files/equation_text.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"

namespace fde::bench {

// A key of a study file for the settings of its runs, and the option of `run` that takes the same values.
struct StudyKey {
  std::string_view key, option;
  bool is_text = false, is_list = false;
};
inline constexpr std::array study_keys{StudyKey{"schemes", "--scheme", true, true},
                                       StudyKey{"external", "--external", true, true},
                                       StudyKey{"steps", "--steps", false, true},
                                       StudyKey{"accuracies", "--accuracy", false, true},
                                       StudyKey{"grid", "--grid", true},
                                       StudyKey{"history", "--history", true},
                                       StudyKey{"tolerance", "--tolerance"},
                                       StudyKey{"budget", "--budget"},
                                       StudyKey{"repeat", "--repeat"}};

// A setting as the texts that the option takes, not yet parsed, and its place in the file.
struct StudySetting {
  std::vector<std::string> texts{};
  TextPosition position{};
};
using StudySettings = std::map<std::string, StudySetting>;  // by key

// Variants of one scene that are run with the same settings.
struct StudyFamily {
  TextPosition position{};
  std::vector<SceneVariant> scenes{};
  StudySettings settings{};  // of the file and of the family
};

// The contents of a study file: docs/studies.md.
struct Study {
  std::string file{}, title{}, checksum{};
  std::vector<StudyFamily> families{};
};

inline constexpr std::size_t max_study_scenes = 100'000;

// Throws std::invalid_argument naming file, line and column, the key and what is allowed: if the file is no
// study, or one of its scenes cannot be made. The settings are not checked. The id of an equation file is its
// path from the current folder if it is below it, otherwise its absolute path.
Study read_study(const std::filesystem::path& file, const SceneRegistry& known);

// The text of a study file in `folder` that lists the scenes as points, and the settings in each family.
std::string text_of(const Study& study, const std::filesystem::path& folder);

}  // namespace fde::bench
