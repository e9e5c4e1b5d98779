// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "fdebench/benchmarks/measures/total_variation.hpp"
#include "fdebench/benchmarks/references/memoized_reference.hpp"
#include "fdebench/benchmarks/search/accuracy_target.hpp"
#include "fdebench/benchmarks/search/configuration.hpp"
#include "fdebench/benchmarks/search/refinement.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {

// Runs configurations on a scene and measures their errors against its reference. The scene must outlive
// this object.
class RunEvaluator {
 public:
  RunEvaluator(const Scene& scene, AccuracyTarget target);

  // Compares the run with the reference at about `compared` times, for Norm::end at the end time only. The
  // run stops after `budget` seconds. Throws std::runtime_error if there is no finite reference.
  RefinementRun evaluate(const Configuration& configuration, const StepsOrTolerance& resolution, int compared,
                         double budget);

  // For Norm::maximum and adaptive step size: solves again and compares the run at its own steps too, at the
  // first 16 and at 2048 of them spread evenly, which are dense where the comparison times need not be. Not
  // where events set unknowns.
  void compare_at_own_steps(const Configuration& configuration, RefinementRun& run);

  // Solves again, once or, where that takes less than 5 ms, twice and for at least 0.2 ms, and sets
  // `run.seconds` to the least time of a solve; with AccuracyTarget::first_run plus its setup_seconds.
  void time_again(const Configuration& configuration, RefinementRun& run) const;

  // Solves without a comparison or a budget, for timing.
  void solve_for_timing(const Configuration& configuration, const StepsOrTolerance& resolution) const;

  // Evaluates the reference at this number of equally spaced times; later comparisons reuse the values.
  void precompute_reference(int times);

  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] const AccuracyTarget& target() const { return target_; }

  // Whether the solution equals y(0) at all sampled times, to rounding and the bounds of the reference. The
  // baseline y = y(0) is then correct, so RunError::baseline does not apply.
  bool is_constant();

  // Whether the error is within the accuracy with the bound of the reference, and better than a constant's.
  [[nodiscard]] bool is_accurate(const RefinementRun& run) const;

  // Error bound of the reference on the scale of the target: at the end time, or the largest at times that
  // are independent of any grid.
  double reference_bound();

 private:
  Rows finite_reference(const std::vector<double>& times);
  RunError maximum_error(const Rows& values, const std::vector<double>& times);
  RunError end_error(const Rows& values);
  // The part of the error over a grid that lies between its times, at least.
  double unresolved_variation(const Configuration& configuration, int steps);
  [[nodiscard]] Rows compared_columns(const Rows& columns) const;
  [[nodiscard]] std::vector<double> compared_times(const Configuration& configuration,
                                                   const StepsOrTolerance& resolution, int compared) const;
  [[nodiscard]] Trajectory solve(const Configuration& configuration, const StepsOrTolerance& resolution,
                                 const std::vector<double>& times, double budget) const;

  const Scene& scene_;
  AccuracyTarget target_;
  MemoizedReference reference_;
  struct EndComparison {
    Rows reference, divisors;
    double baseline_error, bound;
  };
  const EndComparison& at_end();
  std::optional<EndComparison> at_end_{};
  // The reference at times that are independent of any grid; its variation is on the scale of the target.
  struct Samples {
    Rows reference, bounds, divisors;
    TotalVariation variation;
  };
  const Samples& samples();
  std::optional<Samples> samples_{};
};

}  // namespace fde::bench
