// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/requests/own_problem.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "fdebench/benchmarks/references/cache.hpp"
#include "fdebench/benchmarks/text/printable.hpp"

namespace fde::bench {
namespace {

// A reference that is computed once, at the first evaluation.
class LazyReference {
 public:
  explicit LazyReference(Problem problem) : problem_(std::move(problem)) {}
  reference::ReferenceValue at(double t) {
    const std::scoped_lock lock(mutex_);
    if (!known_) known_ = computed_reference(problem_);
    return known_->at(t);
  }

 private:
  Problem problem_;
  std::mutex mutex_{};
  std::optional<reference::Reference> known_{};
};

[[noreturn]] void reject_own(const std::string& name, const std::string& value, const std::string& allowed) {
  throw std::invalid_argument(fmt::format("{} = {}: must be {}", name, value, allowed));
}

void require_positive(const std::string& name, double value) {
  if (!(value > 0.0 && std::isfinite(value))) reject_own(name, fmt::format("{}", value), "a number above 0");
}

void require_increasing(const std::string& name, const std::vector<double>& times) {
  for (const double time : times) require_positive(name, time);
  if (std::ranges::adjacent_find(times, std::greater_equal<>()) != times.end())
    reject_own(name, fmt::format("[{}]", fmt::join(times, ", ")), "increasing");
}

void require_component(const Component& row, std::size_t place) {
  require_order(row.order);
  const auto count = initial_count(row.order);
  const bool finite = std::ranges::all_of(row.initial, [](double value) { return std::isfinite(value); });
  if (row.initial.size() == count && finite) return;
  reject_own(fmt::format("initial[{}]", place), fmt::format("[{}]", fmt::join(row.initial, ", ")),
             fmt::format("{} finite number{} for order {}", count, count > 1 ? "s" : "", row.order));
}

void require_posed(const Problem& problem, const std::vector<std::string>& names) {
  const auto& rows = problem.components;
  for (std::size_t i = 0; i < rows.size(); ++i) require_component(rows[i], i);
  require_positive("end", problem.end);
  if (names.size() != rows.size() || std::set(names.begin(), names.end()).size() != rows.size()) {
    reject_own("names", fmt::format("[{}]", fmt::join(names, ", ")),
               fmt::format("{} different names", rows.size()));
  }
  const auto is_column = [](const std::string& name) {
    return is_printable(name) && split_names(name) == std::vector{name};
  };
  if (!std::ranges::all_of(names, is_column))
    throw std::invalid_argument("names: must be texts that print, without a comma");
  require_increasing("jumps", problem.jump_times);
  require_increasing("delays", problem.delays.lags);
}

// y at t - lags[k] in column k.
Matrix earlier_values(double t, Eigen::Index size, const std::vector<double>& lags, const Past& past) {
  Matrix values(size, std::ssize(lags));
  for (Eigen::Index k = 0; k < values.cols(); ++k) past(t - lags[static_cast<std::size_t>(k)], values.col(k));
  return values;
}

}  // namespace

void require_order(double order) {
  constexpr double largest_order = 2.0;
  if (!(order >= 0.0 && order <= largest_order))
    reject_own("orders", fmt::format("{}", order), "a number in [0, 2]");
}

Scene own_scene(const Problem& problem, const std::vector<std::string>& names) {
  require_posed(problem, names);
  Scene scene{.problem = problem, .outputs = {.names = names}};
  scene.reference.evidence = reference::Evidence::two_methods;
  scene.reference.at = [reference = std::make_shared<LazyReference>(problem)](double t) {
    return reference->at(t);
  };
  return scene;
}

Delays own_delays(const std::vector<double>& lags, const Past& before, const DelayedFunction& f,
                  const DelayedJacobian& jacobian) {
  Delays delays{.lags = lags, .before = before};
  delays.rhs = [lags, f](double t, In y, const Past& past, Out values) {
    f(t, y, earlier_values(t, y.size(), lags, past), values);
  };
  if (jacobian) {
    delays.jacobian = [lags, jacobian](double t, In y, const Past& past, OutMatrix values) {
      jacobian(t, y, earlier_values(t, y.size(), lags, past), values);
    };
  }
  return delays;
}

std::vector<std::string> usual_names(std::size_t count) {
  if (count == 1) return {"y"};
  std::vector<std::string> names;
  for (std::size_t i = 1; i <= count; ++i) names.push_back(fmt::format("y{}", i));
  return names;
}

}  // namespace fde::bench
