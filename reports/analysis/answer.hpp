#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/runs.hpp"
#include "observers/rate.hpp"

namespace fde {

// A measured run, offered as an answer.
struct Choice {
  std::string scheme;
  Setup setup;
  int steps = 0;
  double error = 0.0;    // measured, at the end
  double seconds = 0.0;  // least time of its repeats
  std::size_t session = 0;
};

// The cheapest run of each line whose error at the end is at most `error`, the fastest first;
// equal times: the more accurate first. Measured runs only, nothing is interpolated. Empty: none reaches it.
std::vector<Choice> cheapest(const Runs& runs, const SceneSettings& scene, double error);

// How many steps a scheme would need if its error went on falling at its observed rate, or at its theoretical
// one where that is less.
struct Extrapolation {
  std::string scheme;
  double rate = 0.0;
  double steps = 0.0;  // whole, but possibly beyond any int
};

// What there is to say where no run reaches an error.
struct Shortfall {
  Choice best;  // the smallest error measured
  std::optional<Extrapolation>
      needed{};  // of the line that needs the fewest steps; nullopt: no line has a rate
};

// nullopt: the scene has no finished run.
std::optional<Shortfall> shortfall(const Runs& runs, const SceneSettings& scene, double error);

// Theoretical and observed rate of one line in one norm. fit.points = 0: too few errors above rounding.
struct NormRate {
  std::optional<double> expected{};
  Fit fit{};

  // observed - expected, where both are known.
  [[nodiscard]] std::optional<double> deviation() const;
};

// The rates of one line, observed over its finest step counts, five at most.
struct RateRow {
  SceneSettings scene;
  std::string scheme;
  Setup setup;
  int coarsest = 0, finest = 0;  // steps
  NormRate end{}, maximum{};
};

RateRow rate_of(RunSpan line);

// How fast a quantity falls with the step, over the same step counts.
Fit observed_rate(RunSpan line, std::string_view quantity);

// A row for each line, in the order of the runs.
std::vector<RateRow> rates(const Runs& runs);

// Choice and extrapolation in words, without the name of the choice's scheme.
std::string describe(const Choice& choice);
std::string describe(const Extrapolation& needed);

// The answer for one scene as lines of text: the schemes that reach the error, the cheapest first, or what
// there is to say where none does.
std::string advice(const Results& results, const SceneSettings& scene, double error);

}  // namespace fde
