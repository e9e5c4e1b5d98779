#pragma once

#include "transfer_functions/characteristic.hpp"
#include "transfer_functions/generalized_polynomial.hpp"
#include "transfer_functions/power_table.hpp"

namespace fde {

// The Laplace transforms of the outputs of a linear problem, exactly: each is a numerator over one
// denominator,
//   X_j(s) = N_j(s) / P(s),  sums of powers with real coefficients.
// What sets in later makes a response of its own, shifted: there is one group of numerators for each such
// time. Orders, times and coefficients are the decimals that name them.
struct LinearTransform {
  struct Group {
    Rational from;
    std::vector<GeneralizedPolynomial> numerators;  // one for each output
  };
  GeneralizedPolynomial characteristic;  // P
  std::vector<Group> groups;
  std::vector<Rational> generators;  // exponents that the others are sums of, as far as is known

  Group& group_from(const Rational& time, std::size_t outputs);  // added if it is new
};

// The same rounded to Real, with all powers in one table.
template <class Real>
class RoundedTransform {
 public:
  explicit RoundedTransform(const LinearTransform& exact);

  // coefficient * s^exponent, with the sum of moduli that the coefficient was put together from.
  struct Monomial {
    std::size_t power;  // place in the table
    Real coefficient, size;
  };
  using Polynomial = std::vector<Monomial>;  // increasing exponents
  struct Group {
    Real from;
    std::vector<Polynomial> numerators;
  };

  Characteristic<Real> characteristic;
  Polynomial denominator;
  std::vector<Group> groups;
  PowerTable table;
  std::vector<Real> exponents;  // of the table

  // Adds the limits from the right of a group's outputs at the time it starts, by the initial value theorem:
  // what stands at s^0 in s X(s) as s -> infinity. They are infinite where a higher power is left.
  void add_start_values(const Group& group, std::vector<Sum<Real>>& sums) const;

 private:
  Polynomial read(const GeneralizedPolynomial& polynomial);
};

extern template class RoundedTransform<long double>;
extern template class RoundedTransform<BigReal>;

}  // namespace fde
