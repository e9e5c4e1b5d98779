// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "fdebench/benchmarks/study/study.hpp"
#include "support/temporary_folder.hpp"

namespace fde::bench {

inline Study study_of(const std::string& text, const SceneRegistry& known = built_in_scenes()) {
  const TemporaryFolder folder;
  folder.write("study.toml", text);
  return read_study(folder.path() / "study.toml", known);
}

// The settings of the scenes of all families, as results have them: "gamma=0.1,lambda=2".
inline std::vector<std::string> points_of(const Study& study) {
  std::vector<std::string> points;
  for (const auto& family : study.families)
    for (const auto& scene : family.scenes) points.push_back(settings_text(scene.key()));
  return points;
}

inline std::vector<std::string> points_of(const std::string& text) { return points_of(study_of(text)); }

}  // namespace fde::bench
