// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/variable_step_direct.hpp"

#include <algorithm>

#include "fdebench/schemes/history/weights/interval_weights.hpp"
#include "fdebench/schemes/problem/archive.hpp"

namespace fde {

VariableStepDirectHistory::VariableStepDirectHistory(const WeightTables& tables, const StepPlan& steps)
    : samples_(0, static_cast<Eigen::Index>(tables.front().size())) {
  auto& integrals = candidate_.integrals;
  for (const auto& of_sum : tables) {
    auto& tracks = tracks_.emplace_back();
    for (std::size_t i = 0; i < of_sum.size(); ++i) {
      const double order = integral_order(of_sum[i]);
      if (order == 0.0) continue;  // L1 of order 1 has no memory term
      auto found = std::ranges::find(integrals, order, &Integral::order);
      if (found == integrals.end()) found = integrals.insert(found, {order, {}, {}});
      tracks.push_back(
          {static_cast<Eigen::Index>(i), of_sum[i], static_cast<std::size_t>(found - integrals.begin())});
    }
  }
  constexpr Eigen::Index first = 64;
  reserve(steps.step_count ? *steps.step_count : first);
}

void VariableStepDirectHistory::reserve(Eigen::Index steps) {
  const auto rows = samples_.rows();
  samples_.conservativeResize(steps + 1, Eigen::NoChange);
  samples_.bottomRows(steps + 1 - rows).setZero();
  for (auto& integral : candidate_.integrals) {
    integral.left.resize(steps);
    integral.right.resize(steps);
  }
}

void VariableStepDirectHistory::push(double t, In sample) {
  const auto row = static_cast<Eigen::Index>(times_.size());
  if (row + 1 == samples_.rows()) reserve(2 * row);
  samples_.row(row) = sample;
  times_.push_back(t);
  candidate_.time.reset();
}

double VariableStepDirectHistory::end_of_step(std::size_t j, double t) const {
  return j + 1 < times_.size() ? times_[j + 1] : t;
}

const VariableStepDirectHistory::StepCache& VariableStepDirectHistory::candidate(double t) const {
  if (candidate_.time == t) return candidate_;
  candidate_.time = t;
  for (auto& [order, left, right] : candidate_.integrals) {
    for (std::size_t j = 0; j < times_.size(); ++j) {
      const double end = end_of_step(j, t);
      const auto weights = interval_weights(order, t - end, end - times_[j]);
      left[static_cast<Eigen::Index>(j)] = weights.left;
      right[static_cast<Eigen::Index>(j)] = weights.right;
    }
  }
  return candidate_;
}

void VariableStepDirectHistory::convolve(double t, std::size_t sum, Out result) const {
  const auto& integrals = candidate(t).integrals;
  result.setZero();
  const double newest = t - times_.back();
  const WeightTable* scaled = nullptr;
  double scale = 1.0;  // of the table `scaled`
  for (const auto& [component, table, integral] : tracks_[sum]) {
    if (scaled == nullptr || table != *scaled) {
      scaled = &table;
      scale = integral_to_sum_factor(table, newest);
    }
    const auto& [order, left, right] = integrals[integral];
    double total = 0.0;
    for (std::size_t j = 0; j < times_.size(); ++j) {  // the row of the sample at t is still 0
      const auto row = static_cast<Eigen::Index>(j);
      const double length = end_of_step(j, t) - times_[j];
      const auto [begin, end] =
          table.family->endpoint_values(samples_(row, component), samples_(row + 1, component), length);
      total += left[row] * begin + right[row] * end;
    }
    result[component] = total * scale;
  }
}

std::size_t VariableStepDirectHistory::bytes() const {
  Eigen::Index doubles = samples_.size();
  for (const auto& integral : candidate_.integrals) doubles += 2 * integral.left.size();
  return sizeof(double) * static_cast<std::size_t>(doubles);
}

void VariableStepDirectHistory::state(Archive& archive) {
  archive.resizable(times_);
  const auto rows = std::ssize(times_);
  while (samples_.rows() <= rows) reserve(2 * samples_.rows());
  for (Eigen::Index i = 0; i < samples_.cols(); ++i) archive.values(samples_.col(i).data(), rows);
  candidate_.time.reset();
}

}  // namespace fde
