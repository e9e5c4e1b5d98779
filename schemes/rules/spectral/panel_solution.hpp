// SPDX-License-Identifier: MIT
#pragma once

#include <deque>

#include "fdebench/schemes/rules/spectral/panel_tree.hpp"

namespace fde {

// The solution on all panels: the tree of the history, and with it dense output of the rows.
class PanelSolution {
 public:
  PanelSolution(const Problem& problem, Eigen::Index points)
      : rule(panel_rule(points)), integrated_rows(problem), memory(rule, integrated_rows) {}
  PanelSolution(const PanelSolution&) = delete;
  PanelSolution& operator=(const PanelSolution&) = delete;

  const PanelRule& rule;
  const IntegratedRows integrated_rows;
  MemorySum memory;
  std::deque<Segment> segments{};
  // One tree a segment, or its parts if the segment ended early.
  std::vector<std::unique_ptr<MemoryBlock>> trees{};
  std::vector<const MemoryBlock*> panels{};  // in the order of time

  // y at t. Precondition: the panels cover t. On the first panel of a segment, where the rows are not
  // smooth, they are computed from the integrals; on the others from the values at the points.
  [[nodiscard]] Vec at(double t) const;

  [[nodiscard]] std::size_t bytes() const;

 private:
  [[nodiscard]] Vec rows_at(double t) const;
  [[nodiscard]] Vec from_integrals(const MemoryBlock& panel, double t) const;
};

}  // namespace fde
