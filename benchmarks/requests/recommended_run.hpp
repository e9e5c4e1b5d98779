// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/measures/by_quantity.hpp"
#include "fdebench/benchmarks/measures/timing_conditions.hpp"
#include "fdebench/benchmarks/records/run_settings.hpp"
#include "fdebench/benchmarks/scenes/parameters.hpp"
#include "fdebench/benchmarks/search/error_model.hpp"

namespace fde::bench {

// A run with its error and time, measured or predicted.
struct RecommendedRun {
  std::vector<std::string> schemes{};  // the scheme that ran, then those with equal bits on this scene
  RunSettings settings{};
  int steps = 0;
  double error = 0.0;
  std::optional<double> predicted_error{};  // from the errors with other numbers of steps
  MedianInterval time{};
  double setup_seconds = 0.0;    // by which the first run of a process takes longer
  bool first_run = false;        // `time` is that of the first run, otherwise of a later one
  std::optional<double> rate{};  // observed
  std::size_t session = 0;       // index into Results::sessions, for recorded runs
  bool external = false;         // of another program, or of a scheme of the caller
  bool wall_clock = false;       // `time` is of a whole process
  QuantityValues measured{};     // by the measures of the caller

  [[nodiscard]] double first_run_seconds() const { return time.median + (first_run ? 0.0 : setup_seconds); }
  [[nodiscard]] double later_run_seconds() const { return time.median - (first_run ? setup_seconds : 0.0); }
  [[nodiscard]] double seconds_per_step() const { return later_run_seconds() / steps; }
};

// The options of `fdebench solve`, after --scheme, that repeat a run of ours with `steps` steps.
std::string options_of(const RunSettings& settings, int steps);
// The same; empty where no command repeats it.
std::string options_of(const RecommendedRun& option);

// The command that repeats the run; empty for other programs, schemes of the caller and problems of the
// caller.
std::string command_of(const SceneSettings& scene, const RecommendedRun& option);

// "l1 = commensurate_l1, graded:2".
std::string name_of(const RecommendedRun& option);

// "N = 64, error 1.2e-7, 12.3 µs (12.1 ... 12.6)", with clock_note() and without the name of the scheme;
// `error` is the word for the error.
std::string run_text(const RecommendedRun& option, std::string_view error = "error");

// "l1, graded:2 would need about N = 35 000 (33 000 ... 37 000), by its errors so far".
std::string needed_text(const std::string& name, const Prediction& steps);

}  // namespace fde::bench
