#pragma once

#include <limits>
#include <memory>
#include <vector>

#include "spectral/panel_kernels.hpp"

namespace fde {

// A stretch of time between two jumps of a right-hand side: its panels grow from its start by themselves.
struct Segment {
  double start, length;
  double first = 0.0;                                     // after its right-hand side has jumped
  double last = std::numeric_limits<double>::infinity();  // before it jumps
};

// A part of a segment: a panel, or a block of panels. Its place is in units of the segment's length and made
// by halving, so it is exact.
struct TimeBlock {
  const Segment* segment;
  double from, width;

  [[nodiscard]] double time(double place) const {  // place in [-1, 1]
    return segment->start + segment->length * (from + width * (1.0 + place) / 2.0);
  }
  // The place of a time, as it is rounded: 2 (t - start) / length - 1.
  [[nodiscard]] double place(double t) const {
    return 2.0 * ((t - segment->start) / segment->length - from) / width - 1.0;
  }
  // The time since its start, exact in the first of a segment.
  [[nodiscard]] double since(double t) const { return (t - segment->start) - segment->length * from; }
  [[nodiscard]] double length() const { return segment->length * width; }
  [[nodiscard]] TimeBlock older() const { return {segment, from, width / 2.0}; }
  [[nodiscard]] TimeBlock newer() const { return {segment, from + width / 2.0, width / 2.0}; }
};

// The past as a tree: the drives on a block as Legendre coefficients, one column a drive; exact on a panel,
// and for a block of panels as much of them as is seen from a distance of its width.
struct PastBlock {
  TimeBlock block;
  Matrix coefficients;
  Vec units;                                    // PanelKernels::units of its length
  Matrix values{};                              // of the rows at the places of a panel
  std::unique_ptr<PastBlock> older{}, newer{};  // both, or none: it is a panel

  [[nodiscard]] bool panel() const { return !older; }
};

// What blocks of the past add to the rows of a later block, by the rule of the fast multipole method in one
// dimension: a block is seen as a whole from a distance of its own width, and what comes from a distance of
// the later block's width is smooth there, so that its values at the places are all of it. Blocks of a row of
// N equal panels have a few others each: N panels cost O(N).
class PastSum {
 public:
  PastSum(const PanelRule& rule, const DrivenRows& driven);

  [[nodiscard]] const PanelKernels& kernels() const { return kernels_; }
  [[nodiscard]] std::size_t bytes() const { return kernels_.bytes(); }

  using Sources = std::vector<const PastBlock*>;

  // What the sources add that is smooth on the block joins `smooth`, the others and their parts `near`.
  // Both have one row a place, one column a row of the problem.
  void sort(const PastBlock& source, const TimeBlock& block, Matrix& smooth, Sources& near);

  // Adds all of a source at the places of a panel.
  void add(const PastBlock& source, const TimeBlock& panel, Matrix& sums);

  // Adds it at a time after its start.
  void add_at(const PastBlock& source, double t, Out sums) const;

 private:
  void add_seen(const PastBlock& source, const TimeBlock& block, const Lie& lie, Matrix& sums);

  const DrivenRows& driven_;
  PanelKernels kernels_;
};

}  // namespace fde
