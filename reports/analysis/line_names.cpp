// SPDX-License-Identifier: MIT
#include "fdebench/reports/analysis/line_names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace fde::bench {
namespace {

std::array<std::string, 4> means_of(const RunSettings& settings, bool one_grading = false) {
  const auto grid = one_grading ? "graded" : grid_text(settings.grading);
  return {std::string(name(settings.history)), settings.grading == 1.0 ? "" : grid,
          fmt::format("tolerance {:g}", settings.newton_tolerance),
          std::isfinite(settings.budget) ? fmt::format("budget {:g} s", settings.budget) : "no budget"};
}

// The selected settings, joined by commas.
std::string differing_settings(const RunSettings& settings, const std::array<bool, 4>& which,
                               bool one_grading) {
  const auto means = means_of(settings, one_grading);
  std::vector<std::string> words;
  for (std::size_t i = 0; i < means.size(); ++i) {
    if (which[i] && !means[i].empty()) words.push_back(means[i]);
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

// Whether the grading of some scheme differs between scenes, and of no scheme within a scene.
bool differ_by_scene_only(const Runs& runs) {
  std::map<std::pair<SceneSettings, std::string>, double> gradings;
  std::map<std::string, double> of_schemes;
  bool differ = false;
  for (const auto* some : {&runs.finished, &runs.failed}) {
    for (const Record& run : *some) {
      const double grading = run.key.settings.grading;
      if (grading == 1.0) continue;
      const auto [first, is_new] = gradings.try_emplace({run.key.scene, run.key.scheme}, grading);
      if (first->second != grading) return false;
      differ = differ || of_schemes.try_emplace(run.key.scheme, grading).first->second != grading;
    }
  }
  return differ;
}

}  // namespace

LineNames::LineNames(const Runs& runs) {
  const Record* first = nullptr;
  for (const auto* some : {&runs.finished, &runs.failed}) {
    for (const Record& run : *some) {
      if (run.key.external) {
        external_.insert(run.key.scheme);
        continue;
      }
      if (first == nullptr) first = &run;
      const auto means = means_of(run.key.settings), others = means_of(first->key.settings);
      for (std::size_t i = 0; i < means.size(); ++i) differ_[i] = differ_[i] || means[i] != others[i];
    }
  }
}

std::string LineNames::name(const std::string& scheme, const RunSettings& settings) const {
  constexpr std::array grid_alone{false, true, false, false};
  const auto means =
      differing_settings(settings, external_.contains(scheme) ? grid_alone : differ_, one_grading_);
  return means.empty() ? scheme : fmt::format("{}, {}", scheme, means);
}

LineNames LineNames::of_several_scenes(const Runs& runs) {
  LineNames names(runs);
  names.one_grading_ = differ_by_scene_only(runs);
  return names;
}

std::string LineNames::grid(const RunSettings& settings) const {
  return one_grading_ && settings.grading != 1.0 ? grid_text(settings.grading) : "";
}

}  // namespace fde::bench
