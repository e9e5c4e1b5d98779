// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/measures/accuracy.hpp"

#include <algorithm>
#include <limits>

namespace fde::bench {
namespace {

// The first column from which on all entries are true; nullopt if these are less than a tenth of the columns.
std::optional<Eigen::Index> true_until_end(const Eigen::Array<bool, 1, Eigen::Dynamic>& seen) {
  Eigen::Index first = seen.size();
  while (first > 0 && seen[first - 1]) --first;
  return 10 * (seen.size() - first) < seen.size() ? std::nullopt : std::optional(first);
}

Eigen::RowVectorXd sizes(const Rows& of) { return of.cwiseAbs().colwise().maxCoeff(); }

}  // namespace

std::optional<Eigen::Index> first_not_finite(const Rows& values) {
  for (Eigen::Index c = 0; c < values.cols(); ++c) {
    if (!values.col(c).allFinite()) return c;
  }
  return std::nullopt;
}

std::optional<Eigen::Index> accuracy_lost(const Rows& values, const Rows& reference) {
  constexpr double rounding = 1e-15;
  const Eigen::RowVectorXd size = sizes(reference);
  const double infinity = std::numeric_limits<double>::infinity();
  const double least = rounding * (size.array() < infinity).select(size.array(), 0.0).maxCoeff();
  const Eigen::RowVectorXd error = sizes(values - reference);
  return true_until_end(size.array() == infinity ||
                        (error.array() > 0.0 && error.array() >= size.cwiseMax(least).array()));
}

std::optional<Eigen::Index> rounding_dominates(const Rows& values, const Rows& rounded,
                                               const Rows& reference) {
  const Eigen::RowVectorXd error = sizes(values - reference);
  return true_until_end(sizes(values - rounded).array() >= error.array() / 4 && error.array() > 0.0);
}

std::optional<double> relative_error(const Rows& values, const Rows& reference, In bound) {
  constexpr double passing = 1e-3;
  const Vec nearby =
      reference.rightCols(std::max<Eigen::Index>(1, reference.cols() / 10)).cwiseAbs().rowwise().maxCoeff();
  const Vec size = reference.rightCols(1).cwiseAbs().cwiseMax(passing * nearby);
  const Vec error = (values.rightCols(1) - reference.rightCols(1)).cwiseAbs() + bound;
  std::optional<double> largest;
  for (Eigen::Index i = 0; i < size.size(); ++i) {
    if (size[i] > 0.0) largest = std::max(largest.value_or(0.0), error[i] / size[i]);
  }
  return largest;
}

}  // namespace fde::bench
