// SPDX-License-Identifier: MIT
#include "fdebench/reference/linear/linear_solution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>

#include "fdebench/reference/linear/transfer_functions/characteristic_zeros.hpp"
#include "fdebench/reference/linear/transfer_functions/linear_response.hpp"
#include "fdebench/reference/special_functions/laplace/contour.hpp"

namespace fde::reference {
namespace {

class LinearSolution {
 public:
  explicit LinearSolution(LinearTransform transform)
      : transform_(std::move(transform)), rounded_(transform_), zeros_(find_zeros(transform_)) {}

  [[nodiscard]] std::optional<std::vector<BoundedDouble>> quick(double t) const;
  [[nodiscard]] std::vector<Bounded<BigReal>> precise(double t, int digits) const;

 private:
  [[nodiscard]] std::size_t size() const { return transform_.groups.front().numerators.size(); }
  [[nodiscard]] LinearValues<long double> in_long_double(double t) const;
  [[nodiscard]] std::vector<BoundedSum<BigReal>> in_digits(double t, int digits) const;
  [[nodiscard]] const NodePowers<long double>& powers_at(const Contour<long double>& contour) const;
  // What in_digits() needs at all times, with the Precision in force.
  struct InDigits {
    RoundedTransform<BigReal> transform;
    std::vector<Zero<BigReal>> zeros;
    NodePowers<BigReal> powers;  // at the nodes of contour_for(digits)
  };
  [[nodiscard]] const InDigits& with_digits(int digits) const;
  [[nodiscard]] int phase_digits(double t) const;
  void require_resolvable_clusters(double t) const;

  LinearTransform transform_;
  RoundedTransform<long double> rounded_;
  std::vector<Zero<long double>> zeros_;
  mutable std::mutex lock_{};
  mutable std::map<const Contour<long double>*, NodePowers<long double>> powers_{};  // guarded by lock_
  mutable std::map<std::pair<int, unsigned>, InDigits> in_digits_{};  // guarded by the lock of Precision
};

[[noreturn]] void throw_oscillates_too_fast(double t) {
  throw std::runtime_error(fmt::format("the exact solution turns too often to be known at t = {}", t));
}

template <class Real>
LinearValues<Real> zero_values(std::size_t outputs) {
  return {std::vector<BoundedSum<Real>>(outputs), std::vector<Complex<Real>>(outputs, Complex<Real>(0))};
}

// The terms of the conjugate nodes cancel the imaginary part.
template <class Real>
void drop_imaginary_parts(std::vector<BoundedSum<Real>>& sums) {
  for (auto& sum : sums) sum.value = Complex<Real>(real_part<Real>(sum.value));
}

LinearValues<long double> LinearSolution::in_long_double(double t) const {
  auto values = zero_values<long double>(size());
  const auto since_start = from_shortest_decimal<long double>(t);
  for (const auto& group : rounded_.groups) {
    const long double time = since_start - group.start_time;
    if (time == 0.0L) rounded_.add_start_values(group, values.sums);
    if (time <= 0.0L) continue;
    auto part = zero_values<long double>(size());
    std::vector<Complex<long double>> log_poles;
    for (const auto& zero : zeros_) log_poles.push_back(zero.log + std::log(time));
    const auto& contour = contour_away_from(log_poles);
    LinearResponse<long double> response(rounded_, group, time);
    response.add_to(part, zeros_, contour, powers_at(contour));
    response.add_discretisation(part, contour);
    // Cancellation in t - start_time gives an error of the time.
    const long double time_ulps = since_start / time;
    for (std::size_t j = 0; j < size(); ++j) {
      const long double rate = std::abs(part.rates[j].real());
      part.sums[j].error += epsilon<long double>() * time_ulps * rate;
      values.rates[j] += part.rates[j] * time_ulps;
    }
    for (std::size_t j = 0; j < size(); ++j) values.sums[j].add(part.sums[j]);
  }
  drop_imaginary_parts(values.sums);
  return values;
}

const NodePowers<long double>& LinearSolution::powers_at(const Contour<long double>& contour) const {
  const std::scoped_lock guard(lock_);
  auto& powers = powers_[&contour];
  if (powers.empty()) powers = powers_at_nodes(rounded_, contour);
  return powers;
}

const LinearSolution::InDigits& LinearSolution::with_digits(int digits) const {
  constexpr std::size_t most = 32;
  const std::pair key{digits, BigReal::default_precision()};
  if (const auto found = in_digits_.find(key); found != in_digits_.end()) return found->second;
  if (in_digits_.size() == most) in_digits_.clear();
  RoundedTransform<BigReal> transform(transform_);
  auto zeros = newton_refined(transform.characteristic, zeros_);
  auto powers = powers_at_nodes(transform, contour_for(digits));
  InDigits known{std::move(transform), std::move(zeros), std::move(powers)};
  return in_digits_.emplace(key, std::move(known)).first->second;
}

std::vector<BoundedSum<BigReal>> LinearSolution::in_digits(double t, int digits) const {
  const auto& [transform, zeros, powers] = with_digits(digits);
  auto values = zero_values<BigReal>(size());
  for (const auto& group : transform.groups) {
    const BigReal time = from_shortest_decimal<BigReal>(t) - group.start_time;
    if (time == 0) transform.add_start_values(group, values.sums);
    if (time > 0)
      LinearResponse<BigReal>(transform, group, time).add_to(values, zeros, contour_for(digits), powers);
  }
  drop_imaginary_parts(values.sums);
  return values.sums;
}

// Decimal digits by which the phase of e^(s* t) exceeds one turn.
int LinearSolution::phase_digits(double t) const {
  constexpr double most = 400.0;
  double digits = 0.0;
  for (const auto& zero : zeros_)
    digits = std::max(digits, static_cast<double>(zero.log.real()) / std::numbers::ln10 + std::log10(t));
  return static_cast<int>(std::min(digits, most)) + 1;
}

void LinearSolution::require_resolvable_clusters(double t) const {
  for (const auto& group : rounded_.groups) {
    const long double time = from_shortest_decimal<long double>(t) - group.start_time;
    const auto turns = [&](const Zero<long double>& zero) {
      return is_unresolvable_cluster(zero, std::log(time));
    };
    if (time > 0.0L && std::ranges::any_of(zeros_, turns)) throw_oscillates_too_fast(t);
  }
}

std::vector<Bounded<BigReal>> LinearSolution::precise(double t, int digits) const {
  require_resolvable_clusters(t);
  return increase_digits_by_comparison(digits, phase_digits(t),
                                       [&](int working) { return in_digits(t, working); });
}

std::optional<std::vector<BoundedDouble>> LinearSolution::quick(double t) const {
  const auto [sums, rates] = in_long_double(t);
  std::vector<BoundedDouble> values;
  for (std::size_t j = 0; j < sums.size(); ++j) {
    const auto& sum = sums[j];
    const long double scale = std::max(std::abs(sum.value.real()), std::abs(rates[j].real()));
    const bool settled = std::isfinite(sum.error) && sum.error <= double_tolerance * scale;
    if (!sum.overflows && !settled) return std::nullopt;
    values.push_back(to_double(sum.value, sum.error));
  }
  return values;
}

// Constructed at the first use: a scene that is only solved needs no zeros of its characteristic function.
class LazySolution {
 public:
  explicit LazySolution(std::function<LinearTransform()> transform) : transform_(std::move(transform)) {}
  const LinearSolution& get() {
    std::call_once(once_, [this] { solution_.emplace(transform_()); });
    return *solution_;
  }

 private:
  std::function<LinearTransform()> transform_;
  std::once_flag once_;
  std::optional<LinearSolution> solution_;
};

void require_bounds(const ReferenceValue& known, double t) {
  for (Eigen::Index j = 0; j < known.value.size(); ++j) {
    if (std::isfinite(known.value[j]) && !std::isfinite(known.bound[j])) throw_oscillates_too_fast(t);
  }
}

}  // namespace

Evaluation linear_evaluation(const char* name, std::function<LinearTransform()> transform) {
  const auto solution = std::make_shared<LazySolution>(std::move(transform));
  return {.name = name,
          .quick = [solution](double t) { return solution->get().quick(t); },
          .precise = [solution](double t, int digits) { return solution->get().precise(t, digits); }};
}

Reference linear_reference(const Evaluation& evaluation) {
  Reference reference = as_reference(evaluation);
  reference.evidence = Evidence::laplace_transform;
  reference.at = [at = std::move(reference.at)](double t) {
    ReferenceValue known = at(t);
    require_bounds(known, t);
    return known;
  };
  return reference;
}

Reference linear_reference(const char* name, const std::function<LinearTransform()>& transform) {
  Reference reference = linear_reference(linear_evaluation(name, transform));
  reference.zeros = [transform] { return characteristic_zeros(transform()); };
  return reference;
}

}  // namespace fde::reference
