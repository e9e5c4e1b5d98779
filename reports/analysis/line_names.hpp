// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <set>
#include <string>

#include "fdebench/reports/analysis/runs.hpp"

namespace fde::bench {

// Names of lines: the scheme, and those settings (history, grid, tolerance, budget) that differ between runs
// of our schemes. A uniform grid is not mentioned. For external programs only the requested grid is known.
class LineNames {
 public:
  explicit LineNames(const Runs& runs);

  // For several scenes whose gradings depend on their orders: if the grading of a scheme differs between
  // scenes but not within a scene, all are named "l1, graded", and grid() gives the grading.
  static LineNames of_several_scenes(const Runs& runs);

  // "l1", or "l1, direct, graded:2".
  [[nodiscard]] std::string name(const std::string& scheme, const RunSettings& settings) const;
  // "graded:2" if name() omits the grading, otherwise empty.
  [[nodiscard]] std::string grid(const RunSettings& settings) const;

 private:
  std::array<bool, 4> differ_{};                   // history, grid, tolerance, budget
  bool one_grading_ = false;                       // per scheme and scene
  std::set<std::string, std::less<>> external_{};  // names of external programs
};

}  // namespace fde::bench
