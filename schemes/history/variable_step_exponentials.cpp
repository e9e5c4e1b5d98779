// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/variable_step_exponentials.hpp"

#include <algorithm>

#include "fdebench/schemes/history/weights/interval_weights.hpp"
#include "fdebench/schemes/history/weights/weight_transform.hpp"

namespace fde {

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
