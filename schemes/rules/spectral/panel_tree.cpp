#include "fdebench/schemes/rules/spectral/panel_tree.hpp"

#include "fdebench/schemes/history/weights/kernel_moments.hpp"

namespace fde {
namespace {

// The position of a source relative to a block, exact within a segment.
RelativePosition lie_of(const TimeBlock& source, const TimeBlock& block) {
  if (source.segment == block.segment)
    return {source.width / block.width, (block.from - (source.from + source.width)) / block.width};
  const double gap = (block.segment->start - (source.segment->start + source.segment->length)) +
                     source.segment->length * (1.0 - (source.from + source.width)) +
                     block.segment->length * block.from;
  return {source.length() / block.length(), gap / block.length()};
}

// Whether the source is integrated as a whole at this distance.
bool is_one(const MemoryBlock& source, const RelativePosition& lie) {
  return source.panel() || lie.gap >= lie.width;
}

}  // namespace

MemorySum::MemorySum(const PanelRule& rule, const IntegratedRows& driven)
    : driven_(driven), kernels_(rule, driven) {}

void MemorySum::sort(const MemoryBlock& source, const TimeBlock& block, Matrix& smooth, Sources& near) {
  const RelativePosition lie = lie_of(source.block, block);
  const bool far = lie.gap >= 1.0, one = is_one(source, lie);
  if (far && one) {
    add_whole(source, block, lie, smooth);
  } else if (!one && (far || lie.width > 1.0)) {
    sort(*source.older, block, smooth, near);
    sort(*source.newer, block, smooth, near);
  } else {
    near.push_back(&source);
  }
}

void MemorySum::add(const MemoryBlock& source, const TimeBlock& panel, Matrix& sums) {
  const RelativePosition lie = lie_of(source.block, panel);
  if (is_one(source, lie)) return add_whole(source, panel, lie, sums);
  add(*source.older, panel, sums);
  add(*source.newer, panel, sums);
}

void MemorySum::add_whole(const MemoryBlock& source, const TimeBlock& block, const RelativePosition& lie,
                          Matrix& sums) {
  std::vector<Matrix> once;
  if (source.block.segment != block.segment) once = kernels_.make(lie);
  const auto& kernels = once.empty() ? kernels_.of(lie) : once;
  for (Eigen::Index i = 0; i < driven_.row_count(); ++i) {
    const Eigen::Index order = kernels_.order_of(i), drive = driven_.rows[static_cast<std::size_t>(i)].drive;
    if (order < 0) continue;
    sums.col(i).noalias() +=
        kernels[static_cast<std::size_t>(order)] * (source.units[order] * source.coefficients.col(drive));
  }
}

void MemorySum::add_at(const MemoryBlock& source, double t, Out sums) const {
  const double length = source.block.length(), gap = t - source.block.time(1.0);
  if (!source.panel() && gap < length) {
    add_at(*source.older, t, sums);
    add_at(*source.newer, t, sums);
    return;
  }
  const double since = source.block.since(t);
  const auto moments_of = [&](double order) -> Vec {
    const auto count = source.coefficients.rows();
    if (since <= length) return moments_inside_panel(order, 2.0 * since / length, count);
    return kernel_moments(order, Vec::Constant(1, 2.0 * gap / length), count).row(0).transpose();
  };
  for (Eigen::Index i = 0; i < driven_.row_count(); ++i) {
    const Eigen::Index order = kernels_.order_of(i), drive = driven_.rows[static_cast<std::size_t>(i)].drive;
    if (order < 0) continue;
    const Vec moments = moments_of(kernels_.orders()[static_cast<std::size_t>(order)]);
    sums[i] += source.units[order] * moments.dot(source.coefficients.col(drive));
  }
}

}  // namespace fde
