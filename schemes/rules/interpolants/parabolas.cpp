// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/interpolants/parabolas.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fdebench/schemes/history/weights/kernel_moments.hpp"

namespace fde {
namespace {

// The step plan for evaluation at times t* inside the steps: the shortest distance is offset times the first
// step.
StepPlan plan_with_offset(const Grid& grid, double offset) {
  StepPlan plan = step_plan(grid);
  if (!plan.uniform) plan.min_step *= offset;
  return plan;
}

// The families for this grid: with variable steps the memory sum is evaluated at t*; with equal steps t* is
// part of the weights.
const WeightFamily& lines_of(const Grid& grid) {
  return grid.uniform() ? families::l2_1_sigma : families::l1;
}
const WeightFamily& bends_of(const Grid& grid) {
  return grid.uniform() ? families::l2_1_sigma_second_difference : families::l1_second_difference;
}

}  // namespace

BackwardParabolas::BackwardParabolas(const Problem& problem, const Grid& grid, const Options& options)
    : grid_(grid),
      lines_(weight_tables(problem, families::l1), step_plan(grid), options),
      second_differences_(weight_tables(problem, families::l1_second_difference), step_plan(grid), options),
      factors_(weight_tables(problem, families::l1)),
      second_difference_ratio_(problem.size()),
      increment_(Vec::Zero(problem.size())),
      bend_(Vec::Zero(problem.size())) {
  for (Eigen::Index i = 0; i < second_difference_ratio_.size(); ++i) {
    const double g = problem.component(i).order;
    second_difference_ratio_[i] = g / (2.0 - g);
  }
  lines_.push(0.0, increment_);
  second_differences_.push(0.0, bend_);
}

void BackwardParabolas::derivative(int n, Out known, Out newest) {
  lines_.derivative(grid_.time(n), known);
  second_differences_.derivative(grid_.time(n), bend_);
  known += bend_;
  newest = factors_.at(grid_.step(n)).cwiseInverse();
  if (n == 1) return;
  const double ratio = grid_.step(n) / grid_.step(n - 1), share = ratio / (1.0 + ratio);
  known -= share * ratio * newest.cwiseProduct(second_difference_ratio_).cwiseProduct(increment_);
  newest += share * newest.cwiseProduct(second_difference_ratio_);
}

void BackwardParabolas::push(int n, In increment) {
  const double t = grid_.time(n);
  lines_.push(t, increment);
  if (n == 1) {
    bend_.setZero();
  } else {
    const double ratio = grid_.step(n) / grid_.step(n - 1);
    bend_ = ratio / (1.0 + ratio) * (increment - ratio * increment_);
  }
  second_differences_.push(t, bend_);
  increment_ = increment;
}

ForwardParabolas::ForwardParabolas(const Problem& problem, const Grid& grid, const Options& options)
    : grid_(grid), increment_(Vec::Zero(problem.size())), bend_(Vec::Zero(problem.size())) {
  std::vector<std::pair<double, std::vector<Eigen::Index>>> rows_of_order;
  for (std::size_t i = 0; i < problem.components.size(); ++i) {
    const double order = problem.components[i].order;
    auto found = std::ranges::find(rows_of_order, order, [](const auto& pair) { return pair.first; });
    if (found == rows_of_order.end()) found = rows_of_order.insert(found, {order, {}});
    found->second.push_back(static_cast<Eigen::Index>(i));
  }
  for (const auto& [order, rows] : rows_of_order) {
    const double offset = 1.0 - 0.5 * order;
    const StepPlan plan = plan_with_offset(grid, offset);
    const std::vector<WeightTable> of_lines(rows.size(), {&lines_of(grid), order}),
        of_bends(rows.size(), {&bends_of(grid), order});
    groups_.push_back({order, offset, std::pow(offset, 1.0 - order), rows,
                       SlopeHistory(of_lines, plan, options), SlopeHistory(of_bends, plan, options),
                       StepFactors({WeightTable{&families::l1, order}}), 0.0, Vec::Zero(std::ssize(rows))});
    auto& group = groups_.back();
    if (grid.uniform() && grid.steps > 1) group.bend_factor = last_second_difference_weight(group, 2);
    group.lines.push(0.0, group.buffer);
    group.bends.push(0.0, group.buffer);
  }
}

Vec ForwardParabolas::offsets() const {
  Vec offsets(increment_.size());
  for (const auto& group : groups_) offsets(group.rows).setConstant(group.offset);
  return offsets;
}

std::size_t ForwardParabolas::bytes() const {
  std::size_t bytes = 0;
  for (const auto& group : groups_) bytes += group.lines.bytes() + group.bends.bytes();
  return bytes;
}

double ForwardParabolas::last_second_difference_weight(const Group& group, int n) const {
  if (group.order == 1.0) return 0.0;  // no memory
  const double before = grid_.step(n - 1);
  const auto [left, right] = interval_weights(1.0 - group.order, group.offset * grid_.step(n), before);
  return (right - left) / before;
}

void ForwardParabolas::derivative(int n, Out known, Out newest) {
  const double length = grid_.step(n);
  const double ratio = n == 1 ? 0.0 : grid_.step(n - 1) / length, share = ratio / (1.0 + ratio);
  for (auto& group : groups_) {
    const double at = grid_.time(n) - (1.0 - group.offset) * length;
    group.lines.derivative(at, group.buffer);
    known(group.rows) = group.buffer;
    group.bends.derivative(at, group.buffer);
    double bend = 0.0;
    if (n > 1) bend = grid_.uniform() ? group.bend_factor : last_second_difference_weight(group, n);
    known(group.rows) += group.buffer - bend * share * increment_(group.rows);
    newest(group.rows).setConstant(group.line / group.factors.at(length)[0] + bend * share * ratio);
  }
}

void ForwardParabolas::push(int n, In increment) {
  if (n > 1) {
    const double ratio = grid_.step(n - 1) / grid_.step(n);
    bend_ = ratio / (1.0 + ratio) * (ratio * increment - increment_);
  }
  for (auto& group : groups_) {
    group.buffer = increment(group.rows);
    group.lines.push(grid_.time(n), group.buffer);
    if (n == 1) continue;
    group.buffer = bend_(group.rows);
    group.bends.push(grid_.time(n - 1), group.buffer);
  }
  increment_ = increment;
}

void ForwardParabolas::state(Archive& archive) {
  for (auto& group : groups_) archive(group.lines, group.bends);
  archive(increment_);
}

}  // namespace fde
