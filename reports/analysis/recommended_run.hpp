// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/measures/error_kind.hpp"
#include "fdebench/benchmarks/measures/timing_conditions.hpp"
#include "fdebench/benchmarks/search/error_model.hpp"
#include "fdebench/reports/analysis/runs.hpp"

namespace fde::bench {

// A run with its error and time, measured or predicted.
struct RecommendedRun {
  std::vector<std::string> schemes{};  // the scheme that ran, then those with equal bits on this scene
  RunSettings setup{};
  int steps = 0;
  double error = 0.0;
  std::optional<double> predicted_error{};  // from the errors with other numbers of steps
  MedianInterval time{};
  double setup_seconds = 0.0;    // by which the first run of a process takes longer
  bool first_run = false;        // `time` is that of the first run, otherwise of a later one
  std::optional<double> rate{};  // observed
  std::size_t session = 0;       // index into Results::sessions, for recorded runs
  bool external = false;         // run of an external program
  bool wall_clock = false;       // `time` is of a whole process

  [[nodiscard]] double first_run_seconds() const { return time.median + (first_run ? 0.0 : setup_seconds); }
  [[nodiscard]] double later_run_seconds() const { return time.median - (first_run ? setup_seconds : 0.0); }
  [[nodiscard]] double seconds_per_step() const { return later_run_seconds() / steps; }
};

// The option with predicted_error and rate from the coarser runs of its line.
RecommendedRun with_prediction(RecommendedRun option, const Runs& runs, const SceneSettings& scene,
                               const ErrorKind& kind);

// The best results if no run is within an accuracy.
struct Shortfall {
  RecommendedRun best{};                     // the smallest error; `time` is 0 if it is not timed
  std::optional<Prediction> steps_needed{};  // predicted for `line`, the line that needs the fewest
  RecommendedRun line{};
  std::size_t untimed = 0;              // runs within the accuracy that are not timed yet
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

// "N = 64, error 1.2e-7, 12.3 µs (12.1 ... 12.6)", with clock_note() and without the name of the scheme;
// `error` is the word for the error.
std::string run_text(const RecommendedRun& option, std::string_view error = "error");

// "l1, graded:2 would need about N = 35 000 (33 000 ... 37 000), by its errors so far".
std::string needed_text(const std::string& name, const Prediction& steps);

}  // namespace fde::bench
