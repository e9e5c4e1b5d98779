#pragma once

#include <array>
#include <functional>
#include <set>
#include <string>

#include "analysis/runs.hpp"

namespace fde {

// What lines are called: by their scheme, and by those of their means (history, grid, tolerance, budget) that
// are not the same for all runs of ours. That a grid is uniform is not said. Of the means of other programs
// no more is known than the grid that a sweep asked for.
class LineNames {
 public:
  explicit LineNames(const Runs& runs);

  // Of several scenes, whose gradings follow from their orders: where those of a scheme differ from scene to
  // scene and nowhere within one, "l1, graded" for all of them. grid() has what the name leaves out.
  static LineNames of_several_scenes(const Runs& runs);

  // "l1", or "l1, direct, graded:2".
  [[nodiscard]] std::string name(const std::string& scheme, const Setup& setup) const;
  // "graded:2" where the name does not say it, otherwise nothing.
  [[nodiscard]] std::string grid(const Setup& setup) const;

 private:
  std::array<bool, 4> differ_{};
  bool one_grading_ = false;                       // of a scheme in each scene
  std::set<std::string, std::less<>> external_{};  // names of other programs
};

}  // namespace fde
