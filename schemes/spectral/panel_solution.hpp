#pragma once

#include <deque>

#include "spectral/panel_tree.hpp"

namespace fde {

// What a run of panels leaves: the tree of the past, and with it the rows at any time.
class PanelSolution {
 public:
  PanelSolution(const Problem& problem, Eigen::Index points)
      : rule(panel_rule(points)), driven(problem), past(rule, driven) {}
  PanelSolution(const PanelSolution&) = delete;
  PanelSolution& operator=(const PanelSolution&) = delete;

  const PanelRule& rule;
  const DrivenRows driven;
  PastSum past;
  std::deque<Segment> segments{};
  std::vector<std::unique_ptr<PastBlock>> trees{};  // one a segment; where that ended early, parts
  std::vector<const PastBlock*> panels{};           // in the order of time

  // The rows at a time that the panels cover. On the first panel of a segment, where they are not smooth,
  // from the integrals; on the others from the values at the places.
  [[nodiscard]] Vec at(double t) const;

  [[nodiscard]] std::size_t bytes() const;

 private:
  [[nodiscard]] Vec by_integrals(const PastBlock& panel, double t) const;
};

}  // namespace fde
