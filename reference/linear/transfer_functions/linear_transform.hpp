// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/reference/linear/transfer_functions/characteristic.hpp"
#include "fdebench/reference/linear/transfer_functions/generalized_polynomial.hpp"
#include "fdebench/reference/linear/transfer_functions/power_table.hpp"

namespace fde::reference {

// The exact Laplace transforms of the outputs of a linear problem, with a common denominator:
//   X_j(s) = N_j(s) / P(s),  sums of powers with real coefficients.
// A load that starts later adds a shifted response: there is one group of numerators per start time. Orders,
// times and coefficients are taken as their shortest decimal representations.
struct LinearTransform {
  struct Group {
    Rational start_time;
    std::vector<GeneralizedPolynomial> numerators;  // one per output
  };
  GeneralizedPolynomial characteristic;  // P
  std::vector<Group> groups;
  std::vector<Rational> generators;  // exponents of which the others are sums, as far as known

  Group& group_at(const Rational& time, std::size_t outputs);  // added if there is none yet
};

// The same rounded to Real, with all powers in one PowerTable.
template <class Real>
class RoundedTransform {
 public:
  explicit RoundedTransform(const LinearTransform& exact);

  // coefficient * s^exponent, and the sum of the moduli of the summands of coefficient.
  struct Monomial {
    std::size_t power;  // index in the table
    Real coefficient, size;
  };
  using Polynomial = std::vector<Monomial>;  // increasing exponents
  struct Group {
    Real start_time;
    std::vector<Polynomial> numerators;
  };

  ExponentialPolynomial<Real> characteristic;
  Polynomial denominator;
  std::vector<Group> groups;
  PowerTable table;
  std::vector<Real> exponents;  // of the table

  // Adds the limits from the right of a group's outputs at its start time, by the initial value theorem: the
  // coefficient of s^0 in s X(s) as s -> infinity. The limit is infinite where a higher power remains.
  void add_start_values(const Group& group, std::vector<BoundedSum<Real>>& sums) const;

 private:
  Polynomial read(const GeneralizedPolynomial& polynomial);
};

extern template class RoundedTransform<long double>;
extern template class RoundedTransform<BigReal>;

}  // namespace fde::reference
