// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/fit/goodness.hpp"

#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>

namespace fde::bench {

double ColumnMisfit::rms() const { return count == 0 ? 0.0 : std::sqrt(sum_of_squares / count); }

std::optional<double> ChiSquared::probability() const {
  if (degrees < 1) return std::nullopt;
  return boost::math::cdf(complement(boost::math::chi_squared(degrees), value));
}

std::vector<ColumnMisfit> misfits(const ExternalTrajectory& measured, const Rows& model) {
  std::vector<ColumnMisfit> all;
  for (Eigen::Index c = 0; c < measured.values.rows(); ++c) {
    ColumnMisfit of{measured.columns[static_cast<std::size_t>(c)]};
    for (Eigen::Index i = 0; i < measured.values.cols(); ++i) {
      const double difference = measured.values(c, i) - model(c, i);
      if (std::isnan(difference)) continue;
      ++of.count;
      of.sum_of_squares += difference * difference;
    }
    all.push_back(of);
  }
  return all;
}

ChiSquared chi_squared(const ExternalTrajectory& measured, const Rows& model, int fitted_parameters) {
  ChiSquared sum{.degrees = -fitted_parameters};
  const Rows scaled = (measured.values - model).cwiseQuotient(measured.deviations);
  for (const double one : scaled.reshaped()) {
    if (std::isnan(one)) continue;
    ++sum.degrees;
    sum.value += one * one;
  }
  return sum;
}

}  // namespace fde::bench
