// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/symbols/delayed_part.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "fdebench/schemes/problem/stored_results.hpp"

namespace fde {
namespace {

// The weights of the results 1, 2, ... steps before t_n in the value that a run looks up so many steps before
// t_n, when it has results up to t_(n-1): the values that StoredResults interpolates in unit vectors.
Vec look_up_weights(double steps) {
  constexpr Eigen::Index count = 17;  // more than a polynomial takes on both sides
  StoredResults results(Vec::Unit(count, 0), {});
  for (Eigen::Index j = 1; j < count; ++j) results.add(static_cast<double>(j), Vec::Unit(count, j));
  return results.at(static_cast<double>(count) - steps).reverse();
}

}  // namespace

double steps_in(double lag, double length) {
  constexpr double rounding = 1e-9;
  const double steps = lag / length, whole = std::round(steps);
  return std::abs(steps - whole) <= rounding * whole ? whole : steps;
}

DelayedPart::DelayedPart(const std::vector<double>& lags, const std::vector<Matrix>& factors, double length,
                         const Vec& offsets)
    : size_(offsets.size()) {
  constexpr double middle = 8.0;  // of the results in look_up_weights
  for (std::size_t k = 0; k < lags.size(); ++k) {
    for (Eigen::Index i = 0; i < size_; ++i) {
      if (factors[k].row(i).isZero(0.0)) continue;
      const double steps = steps_in(lags[k], length) + 1.0 - offsets[i];
      const double farther = std::max(0.0, std::floor(steps) - middle);
      const Vec weights = look_up_weights(steps - farther);
      Eigen::Index first = 0, last = weights.size() - 1;
      while (weights[first] == 0.0) ++first;
      while (weights[last] == 0.0) --last;
      rows_.push_back({i, factors[k].row(i).cast<ComplexValue>(), farther + 1.0 + static_cast<double>(first),
                       weights.segment(first, last - first + 1)});
    }
  }
}

ComplexMatrix DelayedPart::at(ComplexValue log_zeta) const {
  ComplexMatrix sum = ComplexMatrix::Zero(size_, size_);
  const ComplexValue zeta = std::exp(log_zeta);
  for (const auto& row : rows_) {
    ComplexValue polynomial = 0.0;
    for (Eigen::Index j = row.weights.size() - 1; j >= 0; --j)
      polynomial = row.weights[j] + zeta * polynomial;
    sum.row(row.index) += std::exp(row.newest * log_zeta) * polynomial * row.factors;
  }
  return sum;
}

}  // namespace fde
