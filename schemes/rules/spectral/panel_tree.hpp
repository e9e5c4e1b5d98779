// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <limits>
#include <memory>
#include <vector>

#include "fdebench/schemes/rules/spectral/panel_rule.hpp"

namespace fde {

// A time interval between two breaking points of a right-hand side. Its panels grow from its start, up to its
// end or a switch.
struct Segment {
  double start, length;
  double first = 0.0;                                     // first time after the jump at its start
  double last = std::numeric_limits<double>::infinity();  // last time before the jump at its end
  double end = start + length;                            // of its panels, where the next segment begins
  double end_place = 1.0;                                 // the same in units of the length
};

// A part of a segment: a panel, or a block of panels. Its position is in units of the segment's length and a
// result of halving, so it is exact.
struct TimeBlock {
  const Segment* segment;
  double from, width;

  [[nodiscard]] double time(double place) const {  // place in [-1, 1]
    return segment->start + segment->length * (from + width * (1.0 + place) / 2.0);
  }
  // The place of a time, up to rounding: 2 (t - start) / length - 1.
  [[nodiscard]] double place(double t) const {
    return 2.0 * ((t - segment->start) / segment->length - from) / width - 1.0;
  }
  // The time since its start, exact in the first block of a segment.
  [[nodiscard]] double elapsed(double t) const { return (t - segment->start) - segment->length * from; }
  [[nodiscard]] double length() const { return segment->length * width; }
  [[nodiscard]] TimeBlock older() const { return {segment, from, width / 2.0}; }
  [[nodiscard]] TimeBlock newer() const { return {segment, from + width / 2.0, width / 2.0}; }
};

// A node of the tree of the history: the x_k (IntegratedRows) on a block as Legendre coefficients, one column
// a function. They are exact on a panel. On a block of panels they suffice for integrals at a distance of at
// least its width.
struct MemoryBlock {
  TimeBlock block;
  Matrix coefficients;
  Vec units;                                      // PanelKernels::units of its length
  Matrix values{};                                // the rows at the points of a panel
  Matrix slopes{};                                // on first panels, PanelSolver::algebraic_slopes
  std::unique_ptr<MemoryBlock> older{}, newer{};  // both halves, or none: a panel

  [[nodiscard]] bool is_panel() const { return !older; }
};

// The memory term: fractional integrals over earlier blocks at the points of a later block, by the fast
// multipole method in one dimension. A block is integrated as a whole at a distance of at least its own
// width. The contributions from a distance of at least the later block's width are smooth on that block, and
// their values at its points represent them. Among N equal panels each block interacts with a few others: N
// panels cost O(N).
class MemorySum {
 public:
  MemorySum(const PanelRule& rule, const IntegratedRows& integrated_rows);

  [[nodiscard]] const PanelKernels& kernels() const { return kernels_; }
  [[nodiscard]] std::size_t bytes() const { return kernels_.bytes(); }

  using Sources = std::vector<const MemoryBlock*>;

  // Adds to `smooth` the contributions of a source that are smooth on the block, and to `near` the source, or
  // its parts, with other contributions. smooth: one row a point, one column a row of the problem.
  void split_near_and_far(const MemoryBlock& source, const TimeBlock& block, Matrix& smooth, Sources& near);

  // Adds to sums all contributions of a source at the points of a panel, in the same shape.
  void add(const MemoryBlock& source, const TimeBlock& panel, Matrix& sums);

  // The same at one time t after the start of the source; sums: one entry a row.
  void add_at(const MemoryBlock& source, double t, Out sums) const;

 private:
  void add_whole(const MemoryBlock& source, const TimeBlock& block, const RelativePosition& position,
                 Matrix& sums);

  const IntegratedRows& integrated_rows_;
  PanelKernels kernels_;
};

// The solution on all panels: the tree of the history, and with it dense output of the rows.
class PanelSolution {
 public:
  PanelSolution(const Problem& problem, Eigen::Index points)
      : rule(panel_rule(points)), integrated_rows(problem), memory(rule, integrated_rows) {}
  PanelSolution& operator=(PanelSolution&&) = delete;

  const PanelRule& rule;
  const IntegratedRows integrated_rows;
  MemorySum memory;
  std::deque<Segment> segments{};
  // One tree a segment, or its parts if the segment ended early.
  std::vector<std::unique_ptr<MemoryBlock>> trees{};
  std::vector<const MemoryBlock*> panels{};  // in the order of time

  // y at t. Precondition: the panels cover t. On the first panel of a segment, where the rows are not
  // smooth, they are computed from the integrals, and the algebraic rows from these; on the others from the
  // values at the points.
  [[nodiscard]] Vec at(double t) const;

  [[nodiscard]] std::size_t bytes() const;

 private:
  [[nodiscard]] Vec rows_at(double t) const;
  [[nodiscard]] Vec interpolated(const MemoryBlock& panel, double t) const;
  [[nodiscard]] Vec from_integrals(const MemoryBlock& panel, double t) const;
};

}  // namespace fde
