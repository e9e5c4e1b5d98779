#include "measures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace fde {
namespace {

bool always(const Observation& /*run*/) { return true; }
bool known(const Observation& run) { return run.truth.cols() > 0; }
bool implicit(const Observation& run) { return run.scheme.needs.implicit; }

template <Norm norm>
double expected_rate(const Observation& run) {
  return run.scheme.expected_rate(run.scene.problem, run.scene.smoothness, run.path.grid.grading, norm);
}

double median(const std::vector<double>& seconds) {
  auto values = seconds;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return values.size() % 2 == 1 ? *middle : 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

constexpr std::array all{
    Measure{"error_end", "", known, error_end},
    Measure{"error_maximum", "", known, error_maximum},
    Measure{"mescd", "digits", known, mescd},
    Measure{"reference_bound", "", known, [](const Observation& run) { return run.truth_bound; }},
    Measure{"energy_residual", "", [](const Observation& run) { return run.energy_residual.has_value(); },
            [](const Observation& run) { return *run.energy_residual; }},
    Measure{"rhs_calls", "", always,
            [](const Observation& run) { return static_cast<double>(run.path.cost.rhs_calls); }},
    Measure{"newton_iterations", "", implicit,
            [](const Observation& run) { return static_cast<double>(run.path.cost.newton_iterations); }},
    Measure{"history_bytes", "B", always,
            [](const Observation& run) { return static_cast<double>(run.path.cost.history_bytes); }},
    Measure{"states", "", always,
            [](const Observation& run) { return static_cast<double>(run.path.cost.states); }},
    Measure{"expected_rate_end", "", always, expected_rate<Norm::end>},
    Measure{"expected_rate_maximum", "", always, expected_rate<Norm::maximum>},
};

constexpr std::array all_of_time{
    TimeMeasure{"time_minimum", [](const std::vector<double>& seconds) { return std::ranges::min(seconds); }},
    TimeMeasure{"time_median", median},
};

}  // namespace

std::span<const Measure> measures() { return all; }
std::span<const TimeMeasure> time_measures() { return all_of_time; }

std::vector<int> watched_steps(int steps) {
  constexpr int most = 8192, first = 16;
  std::vector<int> watched(static_cast<std::size_t>(std::min(steps, most)) + 1);
  std::iota(watched.begin(), watched.end(), 0);
  if (steps <= most) return watched;
  for (auto& n : watched) n = static_cast<int>(std::int64_t{n} * steps / most);
  for (int n = 0; n <= first; ++n) watched.push_back(n);
  std::ranges::sort(watched);
  watched.erase(std::unique(watched.begin(), watched.end()), watched.end());
  return watched;
}

double error_end(const Observation& run) {
  return (run.values.rightCols(1) - run.truth.rightCols(1)).cwiseAbs().maxCoeff();
}

double error_maximum(const Observation& run) { return (run.values - run.truth).cwiseAbs().maxCoeff(); }

double mescd(const Observation& run) {
  const auto error = (run.values.rightCols(1) - run.truth.rightCols(1)).array().abs();
  const double relative = (error / (1.0 + run.truth.rightCols(1).array().abs())).maxCoeff();
  return -std::log10(std::max(relative, 1e-17));
}

}  // namespace fde
