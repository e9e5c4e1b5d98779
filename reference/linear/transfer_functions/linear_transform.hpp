// SPDX-License-Identifier: MIT
#pragma once

#include <map>

#include "fdebench/reference/linear/transfer_functions/generalized_polynomial.hpp"
#include "fdebench/reference/special_functions/numbers/rational.hpp"
#include "fdebench/reference/special_functions/numbers/real.hpp"

namespace fde::reference {

// The powers s^e for a set of exponents e. Exponentials dominate the cost of an evaluation, so a power that
// is the product of two others is computed as the product.
class PowerTable {
 public:
  PowerTable();

  // Index of s^exponent, which is added if it is new.
  std::size_t index(const Rational& exponent);

  // How a power is computed. Its relative error is at most fixed + growing * |log s| ulps.
  struct Entry {
    Rational exponent;
    enum class Method { one, identity, inverse, exponential, product } method;
    std::size_t left = 0, right = 0;  // of a product
    double fixed = 0.0, growing = 0.0;
  };
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }

  // All powers at one s, real or complex; `exponents` are the exponents of the entries, rounded.
  template <class Real, class Number>
  void evaluate(const std::vector<Real>& exponents, const Number& log_s, const Number& s,
                std::vector<Number>& powers) const {
    using std::exp;
    powers.clear();
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      switch (const Entry& entry = entries_[i]; entry.method) {
        case Entry::Method::one:
          powers.emplace_back(1);
          break;
        case Entry::Method::identity:
          powers.push_back(s);
          break;
        case Entry::Method::inverse:
          powers.push_back(Real(1) / s);
          break;
        case Entry::Method::exponential:
          powers.push_back(exp(Number(exponents[i] * log_s)));
          break;
        case Entry::Method::product:
          powers.push_back(powers[entry.left] * powers[entry.right]);
          break;
      }
    }
  }

 private:
  [[nodiscard]] Entry cheapest_entry(const Rational& exponent) const;

  std::vector<Entry> entries_;
  std::map<Rational, std::size_t> places_;
};

// P(s) = sum_i c_i s^(o_i) as a function of w = log s: P(e^w) = sum_i c_i e^(o_i w) is entire, the principal
// sheet is the strip |Im w| <= pi, and the other sheets continue it above and below.
template <class Real>
struct ExponentialPolynomial {
  struct Term {
    Complex<Real> log_coefficient;
    Real order;
  };
  std::vector<Term> terms;  // increasing orders, no zero coefficient

  // The terms at w, divided by the largest modulus.
  [[nodiscard]] std::vector<Complex<Real>> scaled_terms(const Complex<Real>& w) const;
  // P / (dP/dw), the step of Newton's method.
  [[nodiscard]] Complex<Real> newton_step(const Complex<Real>& w) const;
  // The logarithms of the moduli of the terms at w.
  [[nodiscard]] std::vector<Real> log_sizes(const Complex<Real>& w) const;
};

// A zero of P inside the strip, or a cluster of zeros that are too close to be separated. Zeros on the cut
// need no correction on a contour around it.
template <class Real>
struct Zero {
  Complex<Real> log;  // log s*; of a cluster, the mean
  int multiplicity = 1;
  long double radius = 0.0L;                                        // radius of the cluster
  long double isolation = std::numeric_limits<long double>::max();  // distance from the nearest other zero
};

// The zeros to working precision, by Newton's method; the centre of a cluster is not changed.
template <class Real>
std::vector<Zero<Real>> newton_refined(const ExponentialPolynomial<Real>& characteristic,
                                       const std::vector<Zero<long double>>& zeros);

extern template struct ExponentialPolynomial<long double>;
extern template struct ExponentialPolynomial<BigReal>;

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
