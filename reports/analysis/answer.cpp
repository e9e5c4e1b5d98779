#include "analysis/answer.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace fde {
namespace {

constexpr std::size_t most_fitted = 5;

// nullopt: the run lacks an error or a time, so it answers nothing.
std::optional<Choice> choice_of(const MeasuredRun& run) {
  const auto error = run["error_end"], seconds = run["time_minimum"];
  if (!error || !seconds) return std::nullopt;
  return Choice{.scheme = run.key.scheme,
                .setup = run.key.setup,
                .steps = run.steps,
                .error = *error,
                .seconds = *seconds,
                .session = run.session};
}

bool is_cheaper(const Choice& a, const Choice& b) {
  return std::tie(a.seconds, a.error) < std::tie(b.seconds, b.error);
}

std::optional<Choice> cheapest_of(RunSpan line, double error) {
  std::optional<Choice> best;
  for (const MeasuredRun& run : line) {
    const auto choice = choice_of(run);
    if (choice && choice->error <= error && (!best || is_cheaper(*choice, *best))) best = choice;
  }
  return best;
}

RunSpan finest(RunSpan line) { return line.last(std::min(line.size(), most_fitted)); }

NormRate norm_rate(RunSpan runs, std::string_view error, std::string_view expected) {
  return {.expected = runs.back()[expected], .fit = observed_rate(runs, error)};
}

std::optional<Extrapolation> extrapolate(RunSpan line, double error) {
  const MeasuredRun& finest = line.back();
  const NormRate end = rate_of(line).end;
  const auto reached = finest["error_end"];
  if (end.fit.points == 0 || end.fit.slope <= 0.0 || !reached) return std::nullopt;
  const double rate = std::min(end.fit.slope, end.expected.value_or(end.fit.slope));
  return Extrapolation{.scheme = finest.key.scheme,
                       .rate = rate,
                       .steps = std::ceil(finest.steps * std::pow(*reached / error, 1.0 / rate))};
}

}  // namespace

std::vector<Choice> cheapest(const Runs& runs, const SceneSettings& scene, double error) {
  std::vector<Choice> ranked;
  for (const RunSpan line : by_line(of_scene(runs.finished, scene))) {
    if (const auto best = cheapest_of(line, error)) ranked.push_back(*best);
  }
  std::ranges::stable_sort(ranked, is_cheaper);
  return ranked;
}

std::optional<Shortfall> shortfall(const Runs& runs, const SceneSettings& scene, double error) {
  const RunSpan of_this = of_scene(runs.finished, scene);
  std::optional<Choice> best;
  for (const MeasuredRun& run : of_this) {
    const auto choice = choice_of(run);
    if (choice && (!best || choice->error < best->error)) best = choice;
  }
  if (!best) return std::nullopt;
  Shortfall found{.best = *best};
  for (const RunSpan line : by_line(of_this)) {
    const auto needed = extrapolate(line, error);
    if (needed && (!found.needed || needed->steps < found.needed->steps)) found.needed = needed;
  }
  return found;
}

std::optional<double> NormRate::deviation() const {
  if (!expected || fit.points == 0) return std::nullopt;
  return fit.slope - *expected;
}

Fit observed_rate(RunSpan line, std::string_view quantity) {
  std::vector<ErrorAt> points;
  for (const MeasuredRun& run : finest(line)) {
    const auto value = run[quantity];
    if (value && run.h > 0.0) points.push_back({run.h, *value});
  }
  return fit_rate(points);
}

RateRow rate_of(RunSpan line) {
  const RunSpan fitted = finest(line);
  const RunKey& key = fitted.back().key;
  return {.scene = key.scene,
          .scheme = key.scheme,
          .setup = key.setup,
          .coarsest = fitted.front().steps,
          .finest = fitted.back().steps,
          .end = norm_rate(fitted, "error_end", "expected_rate_end"),
          .maximum = norm_rate(fitted, "error_maximum", "expected_rate_maximum")};
}

std::vector<RateRow> rates(const Runs& runs) {
  std::vector<RateRow> rows;
  for (const RunSpan line : by_line(runs.finished)) rows.push_back(rate_of(line));
  return rows;
}

}  // namespace fde
