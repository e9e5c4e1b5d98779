#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/runs.hpp"
#include "measures/error_kind.hpp"
#include "measures/time_spread.hpp"
#include "search/error_model.hpp"

namespace fde {

// A run that was made, compared with the reference and timed.
struct Option {
  std::vector<std::string> schemes{};  // the one that ran; behind it those that are the same algorithm here
  Setup setup{};
  int steps = 0;
  double error = 0.0;
  std::optional<double> predicted_error{};  // by the errors with other numbers of steps
  TimeSpread time{};
  double once_seconds = 0.0;     // that the first solve of a program takes more, for start weights
  std::optional<double> rate{};  // observed
  std::size_t session = 0;       // of results; index into Results::sessions
  bool external = false;         // of another program
  bool wall_clock = false;       // its time is of a whole process

  [[nodiscard]] double step_seconds() const { return time.median / steps; }
};

// The same with its predicted error and its rate, by the coarser runs of its line.
Option with_prediction(Option option, const Runs& runs, const SceneSettings& scene, const ErrorKind& kind);

// What there is to say where no run is within an accuracy.
struct Shortfall {
  Option best{};                           // the smallest error; without a time where it is not timed
  std::optional<Expected> steps_needed{};  // by the errors of `line`, the line that needs the fewest
  Option line{};
  std::size_t untimed = 0;  // runs that are within the accuracy and not timed yet
};

// How the errors of a line go on with more steps, by those so far.
struct ErrorForecast {
  int finest = 0;  // number of steps so far
  Option line{};   // its finest run
  ErrorModel errors;
};

// Lines that are one algorithm on their scene: the longest of them, under all their names.
struct NamedLine {
  RunSpan runs;
  std::vector<std::string> names;
};

// The lines of one scene, among which an answer is looked for. The runs must live as long.
class SceneLines {
 public:
  SceneLines(const Runs& runs, const SceneSettings& scene);

  // Of each line the quickest run within the accuracy that does better than y = 0 or y = y(0), the quickest
  // line first; equal times: the more accurate first.
  [[nodiscard]] std::vector<Option> within(const ErrorKind& kind, double accuracy) const;

  // Of the lines with enough runs.
  [[nodiscard]] std::vector<ErrorForecast> forecasts(const ErrorKind& kind) const;

  // Names the steps needed by these forecasts. nullopt: the scene has no run with this kind of error.
  [[nodiscard]] std::optional<Shortfall> shortfall(const ErrorKind& kind, double accuracy,
                                                   std::span<const ErrorForecast> forecasts) const;

 private:
  RunSpan runs_;
  std::vector<NamedLine> lines_;
};

// With what the error is called: "N = 64, error 1.2e-7, 12.3 µs (12.1 ... 12.6)", without the name of its
// scheme, with the clock_note.
std::string run_text(const Option& option, std::string_view error = "error");

// "l1, graded:2 would need about N = 35 000 (33 000 ... 37 000), by its errors so far".
std::string needed_text(const std::string& name, const Expected& steps);

}  // namespace fde
