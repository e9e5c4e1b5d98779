// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/variable_step_history.hpp"

#include <algorithm>

#include "fdebench/schemes/history/weights/exponential_sum.hpp"
#include "fdebench/schemes/history/weights/kernel_moments.hpp"
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

VariableStepExponentialHistory::VariableStepExponentialHistory(const WeightTables& tables,
                                                               const StepPlan& steps, double tolerance) {
  for (const auto& of_sum : tables) {
    auto& tracks = tracks_.emplace_back();
    for (std::size_t i = 0; i < of_sum.size(); ++i) {
      if (integral_order(of_sum[i]) == 0.0) continue;  // L1 of order 1 has no memory term
      const auto table = std::ranges::find(tables_, of_sum[i]);
      const auto kernel = kernel_of(of_sum[i], steps, tolerance);
      tracks.push_back({static_cast<Eigen::Index>(i), static_cast<std::size_t>(table - tables_.begin()),
                        kernel, kernels_[kernel].add_function(), acts_on_running_sums(of_sum[i])});
      if (table == tables_.end()) tables_.push_back(of_sum[i]);
    }
  }
  for (auto& kernel : kernels_) kernel.begin();
  candidate_.steps.resize(kernels_.size());
  candidate_.to_sums.resize(std::ssize(tables_));
  factors_ = StepFactors(tables_);
}

std::size_t VariableStepExponentialHistory::kernel_of(const WeightTable& table, const StepPlan& steps,
                                                      double tolerance) {
  const long double exponent = kernel_exponent(table);
  const auto found = std::ranges::find_if(
      kernels_, [&](const KernelIntegrals& integrals) { return integrals.kernel().exponent == exponent; });
  const auto index = static_cast<std::size_t>(found - kernels_.begin());
  if (found == kernels_.end()) {
    kernels_.emplace_back(ExponentialKernel(exponent, steps.min_step, steps.end, tolerance));
  }
  return index;
}

void VariableStepExponentialHistory::push(double t, In sample) {
  if (newest_.size() > 0) advance(t, sample);
  newest_ = sample;
  time_ = t;
  candidate_.time.reset();
}

Polynomial VariableStepExponentialHistory::integrand(const ComponentSum& track, double before, double after,
                                                     double length) const {
  const auto [begin, end] = tables_[track.table].family->endpoint_values(before, after, length);
  if (!track.running_sums) return {begin, end - begin, 0.0};
  return {track.integral[0], length * begin, length * (end - begin)};
}

const VariableStepExponentialHistory::StepCache& VariableStepExponentialHistory::candidate(double t) const {
  if (candidate_.time == t) return candidate_;
  const double length = t - time_;
  candidate_.time = t;
  const Vec& factors = factors_.at(length);
  for (std::size_t k = 0; k < kernels_.size(); ++k) {
    const double power = factors_.power(static_cast<double>(kernels_[k].kernel().exponent));
    kernels_[k].prepare(length, power, candidate_.steps[k]);
  }
  for (std::size_t i = 0; i < tables_.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    candidate_.to_sums[row] = tables_[i].family->acts_on_increments ? factors[row] : 1.0 / factors[row];
  }
  return candidate_;
}

// Integrates over the step from the newest sample to this one.
void VariableStepExponentialHistory::advance(double t, In sample) {
  const auto& steps = candidate(t).steps;
  const double length = t - time_;
  for (auto& tracks : tracks_) {
    for (auto& track : tracks) {
      const double before = newest_[track.component], after = sample[track.component];
      kernels_[track.kernel].polynomial(track.function) = length * integrand(track, before, after, length);
      if (!track.running_sums) continue;
      const auto [begin, end] = tables_[track.table].family->endpoint_values(before, after, length);
      track.integral.add(0, length * (begin + end) / 2.0);
    }
  }
  for (std::size_t k = 0; k < kernels_.size(); ++k) kernels_[k].advance(steps[k]);
}

void VariableStepExponentialHistory::convolve(double t, std::size_t sum, Out result) const {
  const auto& at = candidate(t);
  const double length = t - time_;
  result.setZero();
  for (const auto& track : tracks_[sum]) {
    const Polynomial newest = integrand(track, newest_[track.component], 0.0, length);
    const double integral = kernels_[track.kernel].integral(at.steps[track.kernel], track.function, newest);
    result[track.component] = integral * at.to_sums[static_cast<Eigen::Index>(track.table)];
  }
}

std::size_t VariableStepExponentialHistory::bytes() const {
  auto bytes = sizeof(double) * static_cast<std::size_t>(newest_.size());
  for (const auto& kernel : kernels_) bytes += kernel.bytes();
  return bytes;
}

void VariableStepExponentialHistory::state(Archive& archive) {
  archive(time_, kernels_);
  archive.resizable(newest_);
  for (auto& tracks : tracks_) {
    for (auto& track : tracks) archive(track.integral);
  }
  candidate_.time.reset();
}

}  // namespace fde
