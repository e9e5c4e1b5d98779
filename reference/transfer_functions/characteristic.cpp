#include "transfer_functions/characteristic.hpp"

namespace fde {
namespace {

// The terms c_i e^(o_i w), all scaled by the same positive number so that the largest is about 1.
template <class Real>
std::vector<Complex<Real>> scaled_terms(const Characteristic<Real>& characteristic, const Complex<Real>& w) {
  using std::exp, std::log;
  std::vector<Complex<Real>> terms;
  for (const auto& [coefficient, order] : characteristic.terms) terms.push_back(log(coefficient) + order * w);
  Real largest = real_part<Real>(terms.front());
  for (const auto& term : terms) largest = std::max(largest, real_part<Real>(term));
  for (auto& term : terms) term = exp(Complex<Real>(term - largest));
  return terms;
}

}  // namespace

template <class Real>
typename Characteristic<Real>::Step Characteristic<Real>::newton_step(const Complex<Real>& w) const {
  const auto scaled = scaled_terms(*this, w);
  Complex<Real> value(0), slope(0);
  Real size(0);
  for (std::size_t i = 0; i < scaled.size(); ++i) {
    value += scaled[i];
    slope += terms[i].order * scaled[i];
    size += size_of(scaled[i]);
  }
  return {value / slope, size_of(value) / size, size_of(slope) / size};
}

template <class Real>
Complex<Real> Characteristic<Real>::direction(const Complex<Real>& w) const {
  Complex<Real> sum(0);
  for (const auto& term : scaled_terms(*this, w)) sum += term;
  return sum;
}

template <class Real>
std::vector<Real> Characteristic<Real>::log_sizes(const Complex<Real>& w) const {
  using std::log;
  std::vector<Real> sizes;
  for (const auto& [coefficient, order] : terms)
    sizes.push_back(real_part<Real>(Complex<Real>(log(coefficient) + order * w)));
  return sizes;
}

template <class Real>
std::vector<Zero<Real>> polished(const Characteristic<Real>& characteristic,
                                 const std::vector<Zero<long double>>& zeros) {
  std::vector<Zero<Real>> results;
  for (const auto& [log, multiplicity, spread, isolation] : zeros) {
    Complex<Real> w(Real(log.real()), Real(log.imag()));
    Real before(1);
    for (int i = 0; multiplicity == 1 && i < 60; ++i) {
      const Complex<Real> step = characteristic.newton_step(w).value;
      const Real length = size_of(step);
      w -= step;
      // Quadratic convergence is over when the steps stop shrinking: what is left is rounding.
      if (length == 0 || (length < Real(1e-9) && length > before / 16)) break;
      before = length;
    }
    results.push_back({w, multiplicity, spread, isolation});
  }
  return results;
}

template struct Characteristic<long double>;
template struct Characteristic<BigReal>;
template std::vector<Zero<long double>> polished(const Characteristic<long double>&,
                                                 const std::vector<Zero<long double>>&);
template std::vector<Zero<BigReal>> polished(const Characteristic<BigReal>&,
                                             const std::vector<Zero<long double>>&);

}  // namespace fde
