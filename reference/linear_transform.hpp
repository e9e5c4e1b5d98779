#pragma once

#include "characteristic.hpp"
#include "linear_equation.hpp"

namespace fde {

// A linear equation read at some precision, with the Laplace transforms of the derivatives D^delta u of its
// solution:
//   s^delta U - sum_{k < ceil(delta)} s^(delta-1-k) u_k = s^delta [G + sum_k u_k N_k] / P,
//   P = sum_i c_i s^(o_i),  G = sum of loads coefficient Gamma(power+1) s^(-power-1),
//   N_k = -sum_{ceil(o_i) <= k} c_i s^(o_i-1-k) for k < ceil(delta), sum_{ceil(o_i) > k} c_i s^(o_i-1-k) for
//   the others.
// Written so, and not as the difference on the left, nothing cancels for large s.
//
// A load that acts from later on makes a response of its own, shifted: there is one group of loads for each
// such time, and the initial values act with the first.
template <class Real>
struct LinearTransform {
  LinearTransform(const LinearEquation& equation, const std::vector<double>& orders);

  struct LoadTerm {
    Real coefficient;  // times Gamma(power + 1)
    Real power;
    std::size_t exponent;  // of s^(-power-1)
  };
  struct Group {
    Real from;
    bool with_initial;
    std::vector<LoadTerm> loads;
  };
  struct Output {
    Real order;
    int ceiling;
    std::size_t exponent;
  };
  struct Exponent {
    double name;  // exponents are the same if these are
    Real value;
  };

  Characteristic<Real> characteristic;
  std::vector<int> ceilings;                // ceil(o_i)
  std::vector<std::size_t> term_exponents;  // of s^(o_i)
  std::vector<Complex<Real>> initial;
  std::vector<Group> groups;
  std::vector<Output> outputs;
  std::vector<Exponent> exponents;
  bool real = true;  // coefficients and initial values are

  // Adds the limits from the right of a group's response at the time it starts; infinite where it has none.
  void add_start_values(const Group& group, std::vector<Sum<Real>>& sums) const;

 private:
  void read_terms(const LinearEquation& equation);
  void read_loads(const LinearEquation& equation);
  std::size_t exponent_index(double name, const Real& value);
};

extern template struct LinearTransform<long double>;
extern template struct LinearTransform<BigReal>;

}  // namespace fde
