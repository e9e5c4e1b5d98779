// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/search/estimated_reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/measures/error_kind.hpp"
#include "fdebench/benchmarks/observers/comparison_steps.hpp"
#include "fdebench/benchmarks/records/run_settings.hpp"
#include "fdebench/benchmarks/references/reference_of.hpp"
#include "fdebench/benchmarks/search/configurations.hpp"
#include "fdebench/benchmarks/search/interpolated_run.hpp"
#include "fdebench/reference/nonlinear/march/march_limits.hpp"

namespace fde::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int most_compared = 2048;

// The difference of two runs at the grid times of the second.
struct Difference {
  double largest = infinity;
  double rounding = 0.0;  // rounding errors, which more steps do not reduce
  Vec divisors{};         // one entry a column of the scene, at the end time
};

Difference difference_of(const InterpolatedRun& first, const InterpolatedRun& second,
                         const AccuracyTarget& target) {
  if (!first.finished() || !second.finished()) return {};
  const auto times = comparison_times(second.grid(), most_compared);
  const Rows values = first.at(times);
  const Rows by = divisors(target.kind.scale, times, values);
  const Rows apart = (second.at(times) - values).cwiseAbs().cwiseQuotient(by)(target.columns, Eigen::all);
  constexpr double last_part = 0.9;
  const auto begin = target.kind.norm == Norm::end
                         ? std::ranges::lower_bound(times, last_part * times.back()) - times.begin()
                         : 0;
  const Rows sizes = values.cwiseAbs().cwiseQuotient(by)(target.columns, Eigen::all);
  constexpr double rounding = 4e-15;
  Difference found{.rounding = rounding * sizes.maxCoeff(), .divisors = by.rightCols(1)};
  found.largest = std::max(found.rounding, apart.rightCols(apart.cols() - begin).maxCoeff());
  return found;
}

std::string name_of(const Configuration& configuration, int steps) {
  const auto grid = configuration.grading == 1.0 ? "" : ", " + grid_text(configuration.grading);
  return fmt::format("{}{} with N = {}", configuration.scheme->id, grid, steps);
}

// Searches for two configurations whose results agree.
class Estimator {
 public:
  Estimator(const Scene& scene, const AccuracyTarget& target, double seconds, const SearchProgress& progress)
      : scene_(scene), target_(target), seconds_(seconds), progress_(progress) {}

  SearchReference run(std::string no_reference_reason) {
    estimate_.no_reference_reason = std::move(no_reference_reason);
    choose_configurations();
    refine();
    return {reference(), estimate_};
  }

 private:
  [[nodiscard]] double elapsed() const {
    return std::chrono::duration<double>(Clock::now() - start_).count();
  }

  [[nodiscard]] std::shared_ptr<const InterpolatedRun> solve(const Configuration& configuration,
                                                             int steps) const {
    progress_(fmt::format("no reference: {}", name_of(configuration, steps)),
              std::min(1.0, elapsed() / seconds_));
    return std::make_shared<const InterpolatedRun>(scene_, configuration, steps,
                                                   std::max(0.1, seconds_ - elapsed()));
  }

  // A configuration, and the change of its result from N to N/2 steps.
  struct ConfigurationChange {
    Configuration configuration{};
    double moves = infinity;
  };

  [[nodiscard]] std::vector<ConfigurationChange> configurations_with(int steps) const {
    std::vector<ConfigurationChange> all;
    for (const Scheme& scheme : schemes()) {
      const auto fits = [&](double grading) {
        return !unsupported_reason(scheme, scene_.problem, Grid{scene_.problem.end, steps, grading});
      };
      if (!fits(1.0)) continue;
      for (const double grading : gradings_of(scheme, scene_, target_.kind.norm)) {
        if (elapsed() > seconds_ || !fits(grading)) continue;
        const Configuration configuration{&scheme, grading};
        const double moves =
            difference_of(*solve(configuration, steps), *solve(configuration, steps / 2), target_).largest;
        if (std::isfinite(moves)) all.push_back({configuration, moves});
      }
    }
    std::ranges::stable_sort(all, {}, &ConfigurationChange::moves);
    return all;
  }

  void choose_configurations() {
    constexpr int fewest = 256, most = 16384;
    constexpr double far = 1e3;  // a result that changes this much more indicates instability
    for (int steps = fewest; steps <= most; steps *= 4) {
      const auto all = configurations_with(steps);
      if (all.empty()) continue;
      const auto& first = *all.front().configuration.scheme;
      const auto other = [&](const ConfigurationChange& of) { return of.configuration.scheme != &first; };
      const auto other_kind = [&](const ConfigurationChange& of) {
        return of.configuration.scheme->capabilities.implicit != first.capabilities.implicit &&
               of.moves < far * all.front().moves;
      };
      // Equal gradings avoid interpolation, which is inaccurate for a solution ~ t^g near 0.
      const auto at_the_same_times = [&](const ConfigurationChange& of) {
        return other_kind(of) && target_.kind.norm == Norm::maximum &&
               of.configuration.grading == all.front().configuration.grading;
      };
      auto second = std::ranges::find_if(all, at_the_same_times);
      if (second == all.end()) second = std::ranges::find_if(all, other_kind);
      if (second == all.end()) second = std::ranges::find_if(all, other);
      if (second == all.end()) continue;
      estimate_.first = all.front().configuration;
      estimate_.second = second->configuration;
      steps_ = steps_resolving_jumps(2 * steps);
      return;
    }
    throw no_estimate("no two schemes come to their end");
  }

  // The steps, doubled until the coarser run has some between any two jumps of the right-hand side: both runs
  // would miss a shorter feature alike, and agree.
  [[nodiscard]] int steps_resolving_jumps(int steps) const {
    constexpr int between = 8, most = 1 << 20;
    double shortest = scene_.problem.end, before = 0.0;
    for (const double t : scene_.problem.jump_times)
      shortest = std::min(shortest, t - std::exchange(before, t));
    for (const auto& limit : scene_.problem.step_limits) shortest = std::min(shortest, limit.to - limit.from);
    while (steps * shortest < between * scene_.problem.end && steps <= most) steps *= 2;
    if (steps > most) throw no_estimate(fmt::format("its right-hand side jumps within {:g}", shortest));
    return steps;
  }

  void refine() {
    constexpr double next_takes = 2.5;  // time of the next pair of runs over the time of this pair
    constexpr double most_values = 2e7;
    double before = infinity, ratio = 0.0;
    for (int steps = steps_;; steps *= 2) {
      const double begin = elapsed();
      estimate_.first_steps = steps;
      estimate_.second_steps = steps / 2;
      first_ = solve(estimate_.first, steps);
      between_ = difference_of(*first_, *solve(estimate_.second, steps / 2), target_);
      estimate_.difference = between_.largest;
      const double fallen = convergence_ratio(before);
      estimate_.factor = estimate_factor(std::min(ratio, fallen));
      if (estimate_.error() <= largest_estimate_fraction * target_.accuracy) return;
      before = between_.largest;
      ratio = fallen;
      const double next = next_takes * (elapsed() - begin);
      const double values = 2.0 * steps * static_cast<double>(scene_.outputs.names.size());
      if (elapsed() + next > seconds_ || values > most_values) throw no_estimate(disagreement());
    }
  }

  // Ratio of the previous difference to this one; 0 if there is no previous one, infinity at rounding level.
  [[nodiscard]] double convergence_ratio(double before) const {
    if (between_.largest <= between_.rounding) return infinity;
    return std::isfinite(before) ? before / between_.largest : 0.0;
  }

  [[nodiscard]] std::string disagreement() const {
    const auto runs = fmt::format("{} and {}", name_of(estimate_.first, estimate_.first_steps),
                                  name_of(estimate_.second, estimate_.second_steps));
    if (std::isinf(between_.largest)) return runs + " do not both come to their end";
    const auto differ = fmt::format("{} differ by {:.1e}", runs, between_.largest);
    if (std::isinf(estimate_.factor)) return differ + ", which has not fallen twice with more steps";
    return fmt::format("{}, so the first is off by about {:.1e}, and that is not below {:g} of {:.1e}",
                       differ, estimate_.error(), largest_estimate_fraction, target_.accuracy);
  }

  [[nodiscard]] std::runtime_error no_estimate(const std::string& why) const {
    return std::runtime_error(
        fmt::format("there is no reference ({}), and no estimate: {}", estimate_.no_reference_reason, why));
  }

  [[nodiscard]] reference::Reference reference() const {
    const Vec bound = estimate_.error() * between_.divisors.unaryExpr([](double by) {
      return std::isfinite(by) ? by : 0.0;  // an infinite divisor excludes the value
    });
    return {[run = first_, bound](double t) -> reference::ReferenceValue { return {run->at(t), bound}; }};
  }

  const Scene& scene_;
  const AccuracyTarget& target_;
  double seconds_;
  const SearchProgress& progress_;
  Clock::time_point start_ = Clock::now();
  int steps_ = 0;
  std::shared_ptr<const InterpolatedRun> first_{};
  Difference between_{};
  ErrorEstimate estimate_{};
};

}  // namespace

double estimate_factor(double ratio) {
  constexpr double safety = 4.0;
  return ratio > 1.0 ? safety * std::max(1.0, 1.0 / (ratio - 1.0)) : infinity;
}

SearchReference estimated_reference(const Scene& scene, const AccuracyTarget& target,
                                    const std::string& no_reference_reason, double seconds,
                                    const SearchProgress& progress) {
  return Estimator(scene, target, seconds, progress).run(no_reference_reason);
}

SearchReference reference_or_estimate(const Scene& scene, const AccuracyTarget& target, double seconds,
                                      const SearchProgress& progress) {
  try {
    reference::Reference known = reference_of(scene);
    [[maybe_unused]] const auto at_end = known.at(scene.problem.end);
    return {.reference = std::move(known)};
  } catch (const reference::Singularity&) {
    throw;
  } catch (const std::runtime_error& missing) {
    return estimated_reference(scene, target, missing.what(), seconds, progress);
  }
}

}  // namespace fde::bench
