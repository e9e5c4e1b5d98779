#include "sweep/experiment.hpp"

#include <chrono>
#include <iterator>
#include <optional>
#include <utility>

#include "measures/judge.hpp"
#include "measures/rounding.hpp"
#include "observers/drift.hpp"
#include "observers/energy_balance.hpp"
#include "observers/watched_steps.hpp"

namespace fde {

namespace {

Grid grid_of(const Scene& scene, const Setup& setup) {
  return {.end = scene.problem.end, .steps = std::get<int>(setup.resolution), .grading = setup.grading};
}

// What hears every step of a run.
class Observers {
 public:
  Observers(const Scene& scene, const Grid& grid) : scene_(scene), grid_(grid) {
    if (scene.energy.power) energy_.emplace(scene.energy);
    if (scene.constraint) drift_.emplace(scene, grid);
  }

  [[nodiscard]] bool empty() const { return !energy_ && !drift_; }

  void observe(int n, In y) {
    const Vec columns = columns_at(scene_.outputs, grid_.time(n), y);
    if (energy_) energy_->observe(grid_.time(n), columns);
    if (drift_) drift_->observe(n, columns);
  }

  void tell(Observed& observed) const {
    if (energy_) observed.energy_residual = energy_->residual();
    if (!drift_) return;
    observed.internal_drift = drift_->internal();
    observed.independent_drift = drift_->independent();
  }

 private:
  const Scene& scene_;
  Grid grid_;
  std::optional<EnergyObserver> energy_{};
  std::optional<DriftObserver> drift_{};
};

// The columns at the same times, computed in other units; none where that run does not finish.
Rows rounded_otherwise(const Scene& scene, const Scheme& scheme, const Grid& grid, const Options& options) {
  constexpr double unit = 0.7;
  auto path = scheme.solve(in_units_of(unit, scene.problem), grid, options);
  if (path.ending != Ending::finished) return {};
  path.y *= unit;
  return columns_of(scene.outputs, path);
}

void tell_rates(const Scene& scene, const Scheme& scheme, double grading, Observed& observed) {
  const auto rate = [&](Norm norm) {
    return scheme.expected_rate(scene.problem, scene.smoothness, grading, norm);
  };
  observed.expected_rate_end = rate(Norm::end);
  observed.expected_rate_maximum = rate(Norm::maximum);
}

Judgement solve_and_judge(const Scene& scene, WatchedReference& reference, const Scheme& scheme,
                          const Setup& setup) {
  const Grid grid = grid_of(scene, setup);
  if (auto reason = refusal(scheme, scene.problem, grid)) return {{Ending::refused, std::move(*reason)}};
  Options options = setup.options();
  options.keep = watched_steps(grid.steps);
  Options observing = options;
  Observers observers(scene, grid);
  if (!observers.empty()) observing.watch = [&](int n, In y) { observers.observe(n, y); };
  const auto path = scheme.solve(scene.problem, grid, observing);
  if (path.ending != Ending::finished) return judge(scene, path, reference);
  Observed observed{.steps = options.keep, .rounded = rounded_otherwise(scene, scheme, grid, options)};
  observers.tell(observed);
  tell_rates(scene, scheme, grid.grading, observed);
  return judge(scene, path, reference, observed);
}

// A row without its number.
Record row_of(const SceneSettings& name, const Scene& scene, const Scheme& scheme, const Setup& setup) {
  const int steps = std::get<int>(setup.resolution);
  return {.key = {.scene = name, .scheme = std::string(scheme.id), .setup = setup},
          .steps = steps,
          .h = scene.problem.end / steps};
}

Record with_value(Record row, const Measured& measured) {
  row.quantity = measured.id;
  row.value = measured.value;
  row.unit = measured.unit;
  return row;
}

std::vector<Record> records_of(const Record& row, Judgement judgement) {
  std::vector<Record> rows;
  for (const auto& measured : judgement.measured) rows.push_back(with_value(row, measured));
  rows.push_back(with_value(row, {"ending", "t", judgement.until}));
  rows.back().ending = std::move(judgement.ending);
  return rows;
}

// `repeats` solves, more where short ones do not add up to something a clock can tell, fewer where they are
// long.
constexpr double least_seconds = 0.02, enough_seconds = 10.0;

std::vector<double> solve_repeatedly(const Scheme& scheme, const Problem& problem, const Grid& grid,
                                     Options options, int repeats) {
  options.keep = {grid.steps};
  std::vector<double> seconds;
  double total = 0.0;
  while (total < least_seconds || (std::ssize(seconds) < repeats && total < enough_seconds)) {
    const auto start = std::chrono::steady_clock::now();
    const auto path = scheme.solve(problem, grid, options);
    seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    total += seconds.back();
  }
  return seconds;
}

}  // namespace

std::vector<Record> examine(const SceneSettings& name, const Scene& scene, WatchedReference& reference,
                            const Scheme& scheme, const Setup& setup) {
  return records_of(row_of(name, scene, scheme, setup), solve_and_judge(scene, reference, scheme, setup));
}

std::vector<Record> time_solves(const SceneSettings& name, const Scene& scene, const Scheme& scheme,
                                const Setup& setup, int repeats) {
  const auto seconds =
      solve_repeatedly(scheme, scene.problem, grid_of(scene, setup), setup.options(), repeats);
  std::vector<Record> rows;
  for (const auto& measure : time_measures()) {
    rows.push_back(with_value(row_of(name, scene, scheme, setup), {measure.id, "s", measure.value(seconds)}));
  }
  return rows;
}

}  // namespace fde
