#include "measures.hpp"

#include <gsl/gsl_spline.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace fde {
namespace {

bool always(const Observation& /*run*/) { return true; }
bool implicit(const Observation& run) { return run.scheme.needs.implicit; }
// GSL's cubic spline needs three points.
bool has_energy(const Observation& run) { return run.scene.energy && run.path.y.cols() >= 3; }

template <Norm norm>
double expected_rate(const Observation& run) {
  return run.scheme.expected_rate(run.scene.problem, run.scene.smoothness,
                                  run.path.grid.grading, norm);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return values.size() % 2 == 1 ? *middle : 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

constexpr std::array all{
    Measure{"error_end", "", always, error_end},
    Measure{"error_maximum", "", always, error_maximum},
    Measure{"mescd", "digits", always, mescd},
    Measure{"reference_bound", "", always, [](const Observation& run) { return run.truth_bound; }},
    Measure{"energy_residual", "", has_energy, energy_residual},
    Measure{"time_minimum", "s", always,
            [](const Observation& run) { return std::ranges::min(run.seconds); }},
    Measure{"time_median", "s", always, [](const Observation& run) { return median(run.seconds); }},
    Measure{"rhs_calls", "", always,
            [](const Observation& run) { return static_cast<double>(run.path.cost.rhs_calls); }},
    Measure{"newton_iterations", "", implicit,
            [](const Observation& run) { return static_cast<double>(run.path.cost.newton_iterations); }},
    Measure{"newton_tolerance", "", implicit, [](const Observation& run) { return run.options.tolerance; }},
    Measure{"history_bytes", "B", always,
            [](const Observation& run) { return static_cast<double>(run.path.cost.history_bytes); }},
    Measure{"states", "", always,
            [](const Observation& run) { return static_cast<double>(run.path.cost.states); }},
    Measure{"expected_rate_end", "", always, expected_rate<Norm::end>},
    Measure{"expected_rate_maximum", "", always, expected_rate<Norm::maximum>},
};

}  // namespace

std::span<const Measure> measures() { return all; }

double error_end(const Observation& run) {
  return (run.values.rightCols(1) - run.truth.rightCols(1)).cwiseAbs().maxCoeff();
}

double error_maximum(const Observation& run) { return (run.values - run.truth).cwiseAbs().maxCoeff(); }

double mescd(const Observation& run) {
  const auto error = (run.values.rightCols(1) - run.truth.rightCols(1)).array().abs();
  const double relative = (error / (1.0 + run.truth.rightCols(1).array().abs())).maxCoeff();
  return -std::log10(std::max(relative, 1e-17));
}

double energy_residual(const Observation& run) {
  const auto& energy = run.scene.energy;
  const auto count = static_cast<std::size_t>(run.path.y.cols());
  std::vector<double> t(count), power(count);
  for (std::size_t n = 0; n < count; ++n) {
    t[n] = run.path.grid.time(run.path.steps[n]);
    power[n] = energy.power(t[n], run.path.y.col(static_cast<Eigen::Index>(n)));
  }
  const std::unique_ptr<gsl_spline, decltype(&gsl_spline_free)> spline(
      gsl_spline_alloc(gsl_interp_cspline, count), gsl_spline_free);
  gsl_spline_init(spline.get(), t.data(), power.data(), count);
  double work = 0.0, largest = 0.0;
  for (std::size_t n = 1; n < count; ++n) {
    work += gsl_spline_eval_integ(spline.get(), t[n - 1], t[n], nullptr);
    const double gained =
        energy.value(run.path.y.col(static_cast<Eigen::Index>(n))) - energy.value(run.path.y.col(0));
    if (!std::isfinite(gained - work)) return gained - work;  // std::max would pass over it
    largest = std::max(largest, std::abs(gained - work));
  }
  return largest;
}

}  // namespace fde
