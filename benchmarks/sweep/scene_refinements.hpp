// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <variant>
#include <vector>

#include "fdebench/benchmarks/sweep/sweep.hpp"

namespace fde::bench {

// The settings of a scheme's runs on a problem, one element per grading: one, or two for a scheme of
// sweep.graded on a problem whose solution is not smooth at 0. A sweep without graded and optimal grids needs
// no problem.
std::vector<RunSettings> settings_of(const Sweep& sweep, const Scheme& scheme, const Problem* problem);

// The runs of one scheme (with one grading) or program on a scene.
struct RefinementSeries {
  std::variant<const Scheme*, const ExternalProgram*> solver;
  RunKey key;              // of the current run
  RunSettings settings{};  // of the current run; a program's key has fewer settings
  std::vector<StepsOrTolerance> listed{};
  bool takes_many_steps = false;  // the scheme accepts the problem, perhaps not on few steps
  bool ended = false;             // there is no further run
  bool is_due = false;            // it has a current run
};

// All series of a scene: which run is the next of each, for a sweep and for its forecast.
class SceneRefinements {
 public:
  SceneRefinements(const Sweep& sweep, const SceneSettings& scene, const Problem* problem);

  // Makes the next runs that the plan wants now the current ones. Returns whether there is any.
  bool choose_next(const SweepPlan& plan);

  // Adds the current run of a series, measured or forecast.
  void add(std::size_t i, RefinementRun run);

  [[nodiscard]] bool has_runs(std::size_t i) const { return !refinements_[i].runs.empty(); }

  std::vector<RefinementSeries> series{};

 private:
  void add(RefinementSeries of, const Capabilities& capabilities, const SweepPlan& plan);
  std::vector<std::optional<StepsOrTolerance>> next_runs(const SweepPlan& plan);

  std::vector<Refinement> refinements_{};  // one entry for each of `series`
  ForecastMemo memo_{};
};

}  // namespace fde::bench
