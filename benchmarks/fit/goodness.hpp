// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "fdebench/benchmarks/records/external_trajectory.hpp"

namespace fde::bench {

// How far the measurements of one column are from a model.
struct ColumnMisfit {
  Eigen::Index column;  // index among those of the scene
  int count = 0;        // of its measurements that are not missing
  double sum_of_squares = 0.0;

  [[nodiscard]] double rms() const;  // sqrt(sum / count), in the unit of the column; 0 without measurements
};

// Pearson's chi^2, the sum of ((measured - model) / standard deviation)^2, which of a true model is
// distributed with as many degrees of freedom as there are measurements less fitted parameters.
struct ChiSquared {
  double value = 0.0;
  int degrees = 0;

  // Of a chi^2 of the true model to be this large or larger; nullopt without degrees of freedom.
  [[nodiscard]] std::optional<double> probability() const;
};

// `model` has the measured columns, one column a row of the measurements.
std::vector<ColumnMisfit> misfits(const ExternalTrajectory& measured, const Rows& model);
// Precondition: the measurements have standard deviations.
ChiSquared chi_squared(const ExternalTrajectory& measured, const Rows& model, int fitted_parameters);

}  // namespace fde::bench
