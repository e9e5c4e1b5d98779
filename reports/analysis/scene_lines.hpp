// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fdebench/benchmarks/measures/error_kind.hpp"
#include "fdebench/benchmarks/requests/recommended_run.hpp"
#include "fdebench/benchmarks/search/error_model.hpp"
#include "fdebench/reports/analysis/runs.hpp"

namespace fde::bench {

// The option with predicted_error and rate from the coarser runs of its line.
RecommendedRun with_prediction(RecommendedRun option, const Runs& runs, const SceneSettings& scene,
                               const ErrorKind& kind);

// The best results if no run is within an accuracy.
struct Shortfall {
  RecommendedRun best{};                     // the smallest error; `time` is 0 if it is not timed
  std::optional<Prediction> steps_needed{};  // predicted for `line`, the line that needs the fewest
  RecommendedRun line{};
  std::size_t untimed = 0;              // runs within the accuracy that are not timed yet
  bool is_no_better = false;            // no better than a constant, within the accuracy
  bool is_rounding = false;             // the smallest error is rounding error
  std::optional<double> known_up_to{};  // otherwise the bound of the reference, where it explains that error
};

// The error model of a line, to extrapolate its errors to more steps.
struct ErrorForecast {
  int finest = 0;         // largest number of steps so far
  RecommendedRun line{};  // the finest run of the line
  ErrorModel errors;
};

// Lines that are the same algorithm on their scene: the runs of the longest line, the names of all.
struct NamedLine {
  RunSpan runs;
  std::vector<std::string> names;
};

// The lines of one scene, the candidates of a recommendation. `runs` must outlive this object.
class SceneLines {
 public:
  SceneLines(const Runs& runs, const SceneSettings& scene);
  // `scene`: all runs of one scene.
  explicit SceneLines(RunSpan scene);

  // The quickest run of each line that is within the accuracy and better than the baselines y = 0 and y =
  // y(0). Sorted by time, then by error.
  [[nodiscard]] std::vector<RecommendedRun> within(const ErrorKind& kind, double accuracy) const;

  // The forecasts of the lines with enough runs.
  [[nodiscard]] std::vector<ErrorForecast> forecasts(const ErrorKind& kind) const;

  // The smallest error, and the steps needed by these forecasts. nullopt if the scene has no run with this
  // kind of error.
  [[nodiscard]] std::optional<Shortfall> shortfall(const ErrorKind& kind, double accuracy,
                                                   std::span<const ErrorForecast> forecasts) const;

 private:
  RunSpan runs_;
  std::vector<NamedLine> lines_;
};

}  // namespace fde::bench
