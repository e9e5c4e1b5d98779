// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <optional>

#include "fdebench/reference/linear/transfer_functions/linear_transform.hpp"

namespace fde::reference {

// P(e^w) of a linear problem (linear_transform.hpp) for the search for its zeros: in long double and, where
// the terms cancel, from exact coefficients with as many digits as needed. For orders at a distance delta, P
// is as small as a power of delta wherever their terms cancel. Not thread-safe.
class CharacteristicFunction {
 public:
  using Point = Complex<long double>;

  explicit CharacteristicFunction(const LinearTransform& exact);

  [[nodiscard]] const std::vector<ExponentialPolynomial<long double>::Term>& terms() const {
    return rounded_.terms;
  }

  // P and its derivatives in w, relative to the sum of the moduli of the terms of P, and the relative
  // rounding error of that sum.
  struct Derivatives {
    Point value, first, second;
    long double noise;

    // is_near_multiple_zero(): |dP/dw| is as small, compared with its derivative, as between two zeros closer
    // than this.
    static constexpr long double cluster_distance = 1e-6L;
    [[nodiscard]] bool is_near_multiple_zero() const {
      return std::abs(first) < 10.0L * cluster_distance * std::abs(second);
    }
  };
  [[nodiscard]] Derivatives derivatives(const Point& w) const;

  // P scaled such that its largest term has modulus 1; the rounding error of that value; and the number of
  // digits of the summation, 0 for long double.
  struct ScaledValue {
    Point value;
    long double noise;
    int digits;
  };
  [[nodiscard]] ScaledValue scaled_value(const Point& w) const;

  // On the straight path from a to b, P(w) e^(-order (w - a)) differs from its value `start` at a by at most
  // `change`; all are scaled by the same positive number.
  struct PathBound {
    Point start;
    long double order, change;
  };
  [[nodiscard]] PathBound path_bound(const Point& a, const Point& b) const;

 private:
  static constexpr std::size_t most_moments = 12;
  using Moments = std::array<Point, most_moments>;
  // sum_i t_i (o_i - origin)^k, k < count, over the terms t_i of the chosen orders o_i, scaled such that the
  // largest of all terms has modulus 1; digits as in ScaledValue.
  struct MomentSelection {
    std::size_t count = 1;
    std::optional<std::size_t> origin{};  // the order of this term; 0 by default
    std::vector<bool> terms{};            // empty: all
  };
  template <class Real>
  [[nodiscard]] static Moments moments(const ExponentialPolynomial<Real>& characteristic, const Point& w,
                                       const MomentSelection& chosen);
  [[nodiscard]] Moments moments(int digits, const Point& w, const MomentSelection& chosen) const;
  // Relative rounding error of a term, from log c + order w.
  [[nodiscard]] long double noise_at(const Point& w, int digits) const;
  [[nodiscard]] int next_digits(int digits) const { return std::min(std::max(2 * digits, 40), most_digits_); }

  GeneralizedPolynomial exact_;
  ExponentialPolynomial<long double> rounded_;
  int most_digits_;
  long double largest_log_ = 0.0L;                                   // |log c| of the coefficients
  mutable std::map<int, ExponentialPolynomial<BigReal>> precise_{};  // by digits
};

// |Im w| <= height, left <= Re w <= right.
struct Rectangle {
  using Point = Complex<long double>;
  long double left, right, height;

  [[nodiscard]] bool contains(const Point& w) const {
    return w.real() >= left && w.real() <= right && std::abs(w.imag()) <= height;
  }
};

// Number of zeros inside, by the argument principle; nullopt where a zero is too close to the sides.
std::optional<int> count_zeros(const CharacteristicFunction& function, const Rectangle& box);

}  // namespace fde::reference
