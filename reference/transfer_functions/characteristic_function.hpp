#pragma once

#include <array>
#include <map>

#include "transfer_functions/linear_transform.hpp"

namespace fde {

// P(e^w) of a linear problem (characteristic.hpp) for those who look for its zeros: in long double, and where
// too little is left of the terms, from exact coefficients with as many digits as that takes. Orders delta
// apart make P as small as a power of delta wherever their terms cancel. For one thread.
class CharacteristicFunction {
 public:
  using Point = Complex<long double>;

  explicit CharacteristicFunction(const LinearTransform& exact);

  [[nodiscard]] const std::vector<Characteristic<long double>::Term>& terms() const { return rounded_.terms; }

  // P and its derivatives in w, relative to the sum of the moduli of its terms, and what rounding leaves of
  // that sum.
  struct Derivatives {
    Point value, first, second;
    long double noise;

    // dP/dw is as small against its own change as two zeros closer than that make it.
    static constexpr long double too_close = 1e-6L;
    [[nodiscard]] bool flat() const { return std::abs(first) < 10.0L * too_close * std::abs(second); }
  };
  [[nodiscard]] Derivatives derivatives(const Point& w) const;

  // P scaled by a positive number, with which its largest term is 1 in modulus; what rounding leaves of that;
  // and the digits it was summed with, none for long double.
  struct Direction {
    Point value;
    long double noise;
    int digits;
  };
  [[nodiscard]] Direction direction(const Point& w) const;

  // On the straight way from a to b, P(w) e^(-order (w - a)) stays within change of its value at a, all
  // scaled by one positive number.
  struct Way {
    Point start;
    long double order, change;
  };
  [[nodiscard]] Way way(const Point& a, const Point& b) const;

 private:
  static constexpr std::size_t most_moments = 12;
  using Moments = std::array<Point, most_moments>;
  // sum_i t_i (o_i - origin)^k, k < count, over the terms t_i of the chosen orders o_i, the largest of all
  // terms being 1 in modulus; digits as in Direction.
  struct Chosen {
    std::size_t count = 1;
    std::optional<std::size_t> origin{};  // a term; without one 0
    std::vector<bool> terms{};            // empty: all
  };
  template <class Real>
  [[nodiscard]] static Moments moments(const Characteristic<Real>& characteristic, const Point& w,
                                       const Chosen& chosen);
  [[nodiscard]] Moments moments(int digits, const Point& w, const Chosen& chosen) const;
  // What rounding leaves of log c + order w of a term, relative to the term.
  [[nodiscard]] long double noise_at(const Point& w, int digits) const;
  [[nodiscard]] int more(int digits) const { return std::min(std::max(2 * digits, 40), most_digits_); }

  GeneralizedPolynomial exact_;
  Characteristic<long double> rounded_;
  int most_digits_;
  long double largest_log_ = 0.0L;                            // |log c| of the coefficients
  mutable std::map<int, Characteristic<BigReal>> precise_{};  // by digits
};

}  // namespace fde
