// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/spectral/panel_tree.hpp"

#include <algorithm>

#include "fdebench/schemes/history/weights/kernel_moments.hpp"

namespace fde {

namespace {

// The position of a source relative to a block, without the rounding error of a time: within a segment, and
// where the block's segment begins at the end of the source's.
RelativePosition position_relative_to(const TimeBlock& source, const TimeBlock& block) {
  if (source.segment == block.segment)
    return {source.width / block.width, (block.from - (source.from + source.width)) / block.width};
  const double gap = (block.segment->start - source.segment->end) +
                     source.segment->length * (source.segment->end_place - (source.from + source.width)) +
                     block.segment->length * block.from;
  return {source.length() / block.length(), gap / block.length()};
}

// Whether the source is integrated as a whole at this distance.
bool is_one(const MemoryBlock& source, const RelativePosition& position) {
  return source.is_panel() || position.gap >= position.width;
}

}  // namespace

MemorySum::MemorySum(const PanelRule& rule, const IntegratedRows& integrated_rows)
    : integrated_rows_(integrated_rows), kernels_(rule, integrated_rows) {}

void MemorySum::split_near_and_far(const MemoryBlock& source, const TimeBlock& block, Matrix& smooth,
                                   Sources& near) {
  const RelativePosition position = position_relative_to(source.block, block);
  const bool far = position.gap >= 1.0, one = is_one(source, position);
  if (far && one) {
    add_whole(source, block, position, smooth);
  } else if (!one && (far || position.width > 1.0)) {
    split_near_and_far(*source.older, block, smooth, near);
    split_near_and_far(*source.newer, block, smooth, near);
  } else {
    near.push_back(&source);
  }
}

void MemorySum::add(const MemoryBlock& source, const TimeBlock& panel, Matrix& sums) {
  const RelativePosition position = position_relative_to(source.block, panel);
  if (is_one(source, position)) return add_whole(source, panel, position, sums);
  add(*source.older, panel, sums);
  add(*source.newer, panel, sums);
}

void MemorySum::add_whole(const MemoryBlock& source, const TimeBlock& block, const RelativePosition& position,
                          Matrix& sums) {
  std::vector<Matrix> once;
  if (source.block.segment != block.segment) once = kernels_.compute_integrals(position);
  const auto& kernels = once.empty() ? kernels_.integrals_on(position) : once;
  for (Eigen::Index i = 0; i < integrated_rows_.row_count(); ++i) {
    const Eigen::Index order = kernels_.order_of(i),
                       drive = integrated_rows_.rows[static_cast<std::size_t>(i)].unknown;
    if (order < 0) continue;
    sums.col(i).noalias() +=
        kernels[static_cast<std::size_t>(order)] * (source.units[order] * source.coefficients.col(drive));
  }
}

void MemorySum::add_at(const MemoryBlock& source, double t, Out sums) const {
  const double length = source.block.length(), gap = t - source.block.time(1.0);
  if (!source.is_panel() && gap < length) {
    add_at(*source.older, t, sums);
    add_at(*source.newer, t, sums);
    return;
  }
  const double since = source.block.elapsed(t);
  const auto moments_of = [&](double order) -> Vec {
    const auto count = source.coefficients.rows();
    if (since <= length) return moments_inside_panel(order, 2.0 * since / length, count);
    return kernel_moments(order, Vec::Constant(1, 2.0 * gap / length), count).row(0).transpose();
  };
  for (Eigen::Index i = 0; i < integrated_rows_.row_count(); ++i) {
    const Eigen::Index order = kernels_.order_of(i),
                       drive = integrated_rows_.rows[static_cast<std::size_t>(i)].unknown;
    if (order < 0) continue;
    const Vec moments = moments_of(kernels_.orders()[static_cast<std::size_t>(order)]);
    sums[i] += source.units[order] * moments.dot(source.coefficients.col(drive));
  }
}

Vec PanelSolution::at(double t) const { return integrated_rows.origin + rows_at(t); }

Vec PanelSolution::rows_at(double t) const {
  const auto found = std::ranges::lower_bound(
      panels, t, {}, [](const MemoryBlock* panel) { return panel->block.time(1.0); });
  const MemoryBlock& panel = found == panels.end() ? *panels.back() : **found;
  return panel.block.from == 0.0 ? from_integrals(panel, t) : interpolated(panel, t);
}

Vec PanelSolution::interpolated(const MemoryBlock& panel, double t) const {
  const double place = panel.block.place(t);
  const Matrix weights = legendre_polynomials(Vec::Constant(1, place), rule.size()) * rule.to_coefficients;
  return (weights * panel.values).transpose();
}

// Algebraic rows are interpolated less their linear dependence on the other rows (algebraic_slopes.hpp).
Vec PanelSolution::from_integrals(const MemoryBlock& panel, double t) const {
  Vec rows = integrated_rows.taylor_part(t);
  for (const auto& tree : trees) {
    if (tree->block.segment->start < panel.block.segment->start) memory.add_at(*tree, t, rows);
  }
  memory.add_at(panel, t, rows);
  if (panel.slopes.size() == 0) return rows;
  const Vec of_points = interpolated(panel, t), followed = of_points + panel.slopes * (rows - of_points);
  for (Eigen::Index i = 0; i < rows.size(); ++i)
    if (memory.kernels().order_of(i) < 0) rows[i] = followed[i];
  return rows;
}

std::size_t PanelSolution::bytes() const {
  // A binary tree has one inner block less than panels.
  const auto numbers = 2 * integrated_rows.unknown_count() + integrated_rows.row_count();
  return memory.bytes() + sizeof(double) * panels.size() * static_cast<std::size_t>(rule.size() * numbers);
}

}  // namespace fde
