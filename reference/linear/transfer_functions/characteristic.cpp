// SPDX-License-Identifier: MIT
#include "fdebench/reference/linear/transfer_functions/characteristic.hpp"

namespace fde::reference {
template <class Real>
std::vector<Complex<Real>> ExponentialPolynomial<Real>::scaled_terms(const Complex<Real>& w) const {
  using std::exp;
  std::vector<Complex<Real>> scaled;
  for (const auto& [log_coefficient, order] : terms) scaled.push_back(log_coefficient + order * w);
  Real largest = real_part<Real>(scaled.front());
  for (const auto& term : scaled) largest = std::max(largest, real_part<Real>(term));
  for (auto& term : scaled) term = exp(Complex<Real>(term - largest));
  return scaled;
}

template <class Real>
Complex<Real> ExponentialPolynomial<Real>::newton_step(const Complex<Real>& w) const {
  const auto scaled = scaled_terms(w);
  Complex<Real> value(0), slope(0);
  for (std::size_t i = 0; i < scaled.size(); ++i) {
    value += scaled[i];
    slope += terms[i].order * scaled[i];
  }
  return value / slope;
}

template <class Real>
std::vector<Real> ExponentialPolynomial<Real>::log_sizes(const Complex<Real>& w) const {
  std::vector<Real> sizes;
  for (const auto& [log_coefficient, order] : terms)
    sizes.push_back(real_part<Real>(Complex<Real>(log_coefficient + order * w)));
  return sizes;
}

template <class Real>
std::vector<Zero<Real>> newton_refined(const ExponentialPolynomial<Real>& characteristic,
                                       const std::vector<Zero<long double>>& zeros) {
  std::vector<Zero<Real>> results;
  for (const auto& [log, multiplicity, spread, isolation] : zeros) {
    Complex<Real> w(Real(log.real()), Real(log.imag()));
    Real before(1);
    for (int i = 0; multiplicity == 1 && i < 60; ++i) {
      const Complex<Real> step = characteristic.newton_step(w);
      const Real length = norm1(step);
      w -= step;
      // Quadratic convergence has ended when the steps no longer decrease: they are rounding errors.
      if (length == 0 || (length < Real(1e-9) && length > before / 16)) break;
      before = length;
    }
    results.push_back({w, multiplicity, spread, isolation});
  }
  return results;
}

template struct ExponentialPolynomial<long double>;
template struct ExponentialPolynomial<BigReal>;
template std::vector<Zero<long double>> newton_refined(const ExponentialPolynomial<long double>&,
                                                       const std::vector<Zero<long double>>&);
template std::vector<Zero<BigReal>> newton_refined(const ExponentialPolynomial<BigReal>&,
                                                   const std::vector<Zero<long double>>&);

}  // namespace fde::reference
