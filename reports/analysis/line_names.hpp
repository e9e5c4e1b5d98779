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

  // "l1", or "l1, direct, graded:2".
  [[nodiscard]] std::string name(const std::string& scheme, const Setup& setup) const;

 private:
  std::array<bool, 4> differ_{};
  std::set<std::string, std::less<>> external_{};  // names of other programs
};

}  // namespace fde
