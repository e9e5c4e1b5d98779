// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fdebench/benchmarks/fit/free_parameter.hpp"
#include "fdebench/benchmarks/fit/goodness.hpp"
#include "fdebench/benchmarks/records/external_trajectory.hpp"
#include "fdebench/benchmarks/requests/failure.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"

namespace fde::bench {

// What is asked of fit(). In messages its fields are vary, data, scheme, confidence and budget.
struct FitRequest {
  SceneVariant variant;  // with the values from which the fit starts
  std::vector<VariedParameter> vary;
  std::function<ExternalTrajectory(const Scene& scene)> data;  // called once the rest is accepted
  std::optional<std::string>
      scheme{};              // one with adaptive step size; nullopt: the first that takes the scene
  double confidence = 0.95;  // of the intervals
  double budget = 600.0;     // seconds, after which no further run is made
};

// An estimate of a parameter. Standard error and interval are of the linearised model: value +- standard
// error times the quantile of the normal distribution, or of Student's where the noise is estimated too.
struct FittedParameter {
  std::string name;
  double value;
  double standard_error = 0.0, low = value, high = value;
  // By how much the estimate with exact solutions would differ, to first order: the error of the scheme at
  // the times of the measurements, by the reference or by a run with a hundredth of its tolerance, as a
  // parameter.
  double solver_error = 0.0;
  // Whether the sum of squares is least at this end of its range: then it counts as known, without errors.
  bool is_at_limit = false;
};

// Parameters of a scene estimated from measurements by least squares.
struct FittedScene {
  SceneVariant variant;  // the scene with the estimates
  std::vector<FittedParameter> parameters{};
  Matrix correlation{};  // of the estimates, 0 beside those at a limit
  ExternalTrajectory measured{};
  std::vector<std::string> names{};  // of its columns
  Rows model{};       // the measured columns at the rows of the measurements, without the error of the scheme
  Rows deviations{};  // given, or estimated for each column from what the model leaves
  std::vector<ColumnMisfit> misfits{};  // by column
  ChiSquared chi_squared{};             // of no use where deviations are estimated
  std::string scheme{};
  double accuracy = 0.0;     // tolerance of the scheme
  bool by_reference = true;  // the solver error; false: by a run with a smaller tolerance
  int iterations = 0, solves = 0;
};

// Called before each solve with the number of solves so far.
using FitProgress = std::function<void(int solves)>;

// Estimates the parameters that minimise the sum of ((measured - model) / deviation)^2. Deviations that are
// not given are estimated, one a column (maximum likelihood). The tolerance of the scheme is lowered from
// 1e-8 until the solver error is below a hundredth of the standard error of every parameter, at most to
// 1e-12. It is a minimum near the start. Throws Refusal naming a field, and NumericalFailure where the scene
// cannot be solved at the start, the fit does not converge, or the measurements do not determine the
// parameters, naming these.
FittedScene fit(const FitRequest& request, const FitProgress& progress = {});

}  // namespace fde::bench
