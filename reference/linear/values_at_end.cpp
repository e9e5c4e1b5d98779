// SPDX-License-Identifier: MIT
#include "fdebench/reference/linear/values_at_end.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>
#include <utility>

#include "fdebench/reference/special_functions/numbers/bounded.hpp"

namespace fde::reference {
namespace {

using BigVector = std::vector<BigReal>;
using BigMatrix = std::vector<BigVector>;  // by rows

[[noreturn]] void throw_undetermined() {
  throw std::runtime_error("the values at the end do not determine the missing initial values");
}

// An approximate inverse, by Gauss-Jordan elimination with pivots of largest modulus.
BigMatrix inverse(BigMatrix matrix) {
  const std::size_t size = matrix.size();
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < size; ++j) matrix[i].emplace_back(i == j ? 1 : 0);
  for (std::size_t k = 0; k < size; ++k) {
    const auto largest =
        std::max_element(matrix.begin() + static_cast<std::ptrdiff_t>(k), matrix.end(),
                         [k](const auto& a, const auto& b) { return abs(a[k]) < abs(b[k]); });
    if ((*largest)[k] == 0) throw_undetermined();
    std::swap(*largest, matrix[k]);
    const BigReal pivot = matrix[k][k];
    for (auto& entry : matrix[k]) entry /= pivot;
    for (std::size_t i = 0; i < size; ++i) {
      const BigReal factor = matrix[i][k];
      for (std::size_t j = 0; i != k && j < 2 * size; ++j) matrix[i][j] -= factor * matrix[k][j];
    }
  }
  for (auto& row : matrix) row.erase(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(size));
  return matrix;
}

// Values with bounds of their errors.
struct BoundedVector {
  BigVector value, bound;
};

BoundedVector in_digits(const Reference& reference, double t, int digits) {
  BoundedVector result;
  for (const auto& [value, bound] : reference.digits(t, digits)) {
    result.value.push_back(parse<BigReal>(value));
    if (bound == "inf" || bound == "nan") throw_undetermined();
    result.bound.push_back(parse<BigReal>(bound));
  }
  return result;
}

// An approximate solution s of (columns - particular) s = values - particular, and a bound of the modulus of
// its error: with R the approximate inverse, |ds| <= |R| r / (1 - |I - R U|), where r is the residual with
// the errors of the entries.
struct UnknownValues {
  BigVector values;
  BigReal error;
};
UnknownValues solve(const BoundedVector& particular, const std::vector<BoundedVector>& columns,
                    const BigVector& values, const BigReal& rounding) {
  const std::size_t size = values.size();
  BigMatrix matrix(size), errors(size);
  for (std::size_t i = 0; i < size; ++i) {
    for (const auto& [value, bound] : columns) {
      matrix[i].push_back(value[i] - particular.value[i]);
      errors[i].push_back(bound[i] + particular.bound[i] +
                          rounding * (abs(value[i]) + abs(particular.value[i])));
    }
  }
  const auto left = inverse(matrix);
  UnknownValues result{BigVector(size), BigReal(0)};
  for (std::size_t k = 0; k < size; ++k)
    for (std::size_t i = 0; i < size; ++i) result.values[k] += left[k][i] * (values[i] - particular.value[i]);
  BigVector residual(size);
  for (std::size_t i = 0; i < size; ++i) {
    BigReal missed = values[i] - particular.value[i];
    residual[i] = particular.bound[i] + rounding * (abs(values[i]) + abs(particular.value[i]));
    for (std::size_t k = 0; k < size; ++k) {
      missed -= matrix[i][k] * result.values[k];
      residual[i] += errors[i][k] * abs(result.values[k]);
    }
    residual[i] += abs(missed);
  }
  BigReal defect = 0;
  for (std::size_t k = 0; k < size; ++k) {
    BigReal error = 0, row = 0;
    for (std::size_t i = 0; i < size; ++i) error += abs(left[k][i]) * residual[i];
    for (std::size_t j = 0; j < size; ++j) {
      BigReal entry = j == k ? 1 : 0;
      for (std::size_t i = 0; i < size; ++i) {
        entry -= left[k][i] * matrix[i][j];
        row += abs(left[k][i]) * errors[i][j];
      }
      row += abs(entry);
    }
    result.error = std::max(result.error, error);
    defect = std::max(defect, row);
  }
  if (!(defect < BigReal(0.5))) throw_undetermined();
  result.error *= BigReal(2);
  return result;
}

class ByValuesAtEnd {
 public:
  ByValuesAtEnd(SolutionByInitialValues solution, double end, std::vector<Rational> values)
      : solution_(std::move(solution)), end_(end), values_(std::move(values)) {
    for (std::size_t k = 0; k <= values_.size(); ++k) basis_.push_back(solution_.outputs(unit(k)));
  }

  [[nodiscard]] ReferenceValue at(double t) const {
    const Known& known = with_digits(double_digits);
    ReferenceValue result = known.reference.at(t);
    if (known.error > 0.0) result.bound += known.error * sensitivity(t);
    return result;
  }

  [[nodiscard]] std::vector<Decimal> digits(double t, int digits) const {
    const Known& known = with_digits(digits);
    auto texts = known.reference.digits(t, digits);
    const Vec sizes = sensitivity(t);
    const Precision precision(double_digits);
    for (std::size_t c = 0; c < texts.size(); ++c) {
      const BigReal size(sizes[static_cast<Eigen::Index>(c)]);
      if (texts[c].bound != "inf" && known.exact_error > 0)
        texts[c].bound = to_bound_text(parse<BigReal>(texts[c].bound) + known.exact_error * size);
    }
    return texts;
  }

  [[nodiscard]] Evidence evidence() const { return basis_.front().evidence; }

 private:
  // The solution with the unknown initial values of a number of digits.
  struct Known {
    Reference reference;
    BigReal exact_error;  // of each of these values
    double error;
  };

  // 0 for k = 0, then the unit vectors.
  [[nodiscard]] std::vector<Rational> unit(std::size_t k) const {
    std::vector<Rational> values(values_.size(), Rational(0));
    if (k > 0) values[k - 1] = 1;
    return values;
  }

  // sum_k |u_k(t)|.
  [[nodiscard]] Vec sensitivity(double t) const {
    const auto [particular, error] = basis_.front().at(t);
    Vec sum = Vec::Zero(particular.size());
    for (std::size_t k = 1; k < basis_.size(); ++k) {
      const auto [value, bound] = basis_[k].at(t);
      sum += (value - particular).cwiseAbs() + bound + error;
    }
    return sum;
  }

  [[nodiscard]] const Known& with_digits(int digits) const {
    constexpr int more = 30;
    const int working = digits + more;
    const Precision precision(working + more);
    if (const auto known = known_.find(digits); known != known_.end()) return known->second;
    const auto particular = in_digits(solution_.given_at_end(unit(0)), end_, working);
    std::vector<BoundedVector> columns;
    for (std::size_t k = 1; k <= values_.size(); ++k)
      columns.push_back(in_digits(solution_.given_at_end(unit(k)), end_, working));
    BigVector values;
    for (const auto& value : values_) values.push_back(rounded<BigReal>(value));
    const auto found = solve(particular, columns, values, pow(BigReal(10), -working));
    std::vector<Rational> unknown;
    for (const auto& value : found.values) unknown.push_back(fraction_of(value));
    const double error =
        std::nextafter(found.error.convert_to<double>(), std::numeric_limits<double>::infinity());
    return known_.emplace(digits, Known{solution_.outputs(unknown), found.error, error}).first->second;
  }

  SolutionByInitialValues solution_;
  double end_;
  std::vector<Rational> values_;
  std::vector<Reference> basis_{};
  mutable std::map<int, Known> known_{};  // guarded by the lock of Precision
};

}  // namespace

Reference with_values_at_end(SolutionByInitialValues solution, double end, std::vector<Rational> values) {
  const auto made = std::make_shared<const ByValuesAtEnd>(std::move(solution), end, std::move(values));
  return {.at = [made](double t) { return made->at(t); },
          .digits = [made](double t, int digits) { return made->digits(t, digits); },
          .evidence = made->evidence()};
}

}  // namespace fde::reference
