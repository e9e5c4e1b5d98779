// SPDX-License-Identifier: MIT
#include "fdebench/reference/linear/transfer_functions/linear_transform.hpp"

namespace fde::reference {

LinearTransform::Group& LinearTransform::group_at(const Rational& time, std::size_t outputs) {
  const auto place = std::ranges::find(groups, time, &Group::start_time);
  if (place != groups.end()) return *place;
  return groups.emplace_back(Group{time, std::vector<GeneralizedPolynomial>(outputs)});
}

template <class Real>
RoundedTransform<Real>::RoundedTransform(const LinearTransform& exact) {
  for (const auto& exponent : exact.generators) table.index(exponent);
  denominator = read(exact.characteristic);
  for (const auto& [from, numerators] : exact.groups) {
    groups.push_back({rounded<Real>(from), {}});
    for (const auto& numerator : numerators) groups.back().numerators.push_back(read(numerator));
  }
  for (const auto& entry : table.entries()) exponents.push_back(rounded<Real>(entry.exponent));
  for (const auto& [power, coefficient, size] : denominator)
    characteristic.terms.push_back({log(Complex<Real>(coefficient)), exponents[power]});
}

template <class Real>
typename RoundedTransform<Real>::Polynomial RoundedTransform<Real>::read(
    const GeneralizedPolynomial& polynomial) {
  Polynomial result;
  for (const auto& [exponent, coefficient] : polynomial) {
    const auto [value, size] = rounded<Real>(coefficient);
    result.push_back({table.index(exponent), value, size});
  }
  return result;
}

template <class Real>
void RoundedTransform<Real>::add_start_values(const Group& group, std::vector<BoundedSum<Real>>& sums) const {
  const auto& [top, leading, leading_size] = denominator.back();
  for (std::size_t j = 0; j < sums.size(); ++j) {
    for (const auto& [power, coefficient, size] : group.numerators[j]) {
      const Rational exponent = table.entries()[power].exponent + 1 - table.entries()[top].exponent;
      if (exponent < 0) continue;
      const Complex<Real> limit(Real(coefficient / leading));
      if (exponent == 0) {
        sums[j].add(limit, Real(size / norm1(Complex<Real>(leading))), Real(16 * epsilon<Real>()), Real(1));
      } else {
        sums[j].add_infinite(limit, rounded<Real>(exponent));
      }
    }
  }
}

template class RoundedTransform<long double>;
template class RoundedTransform<BigReal>;

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

PowerTable::PowerTable() {
  using Made = Entry::Method;
  for (const auto& [exponent, made] :
       {std::pair{0, Made::one}, std::pair{1, Made::identity}, std::pair{-1, Made::inverse}}) {
    places_.emplace(exponent, entries_.size());
    entries_.push_back({.exponent = exponent, .method = made, .fixed = exponent == -1 ? 2.0 : 0.0});
  }
}

PowerTable::Entry PowerTable::cheapest_entry(const Rational& exponent) const {
  for (std::size_t i = 1; i < entries_.size(); ++i) {
    const auto other = places_.find(Rational(exponent - entries_[i].exponent));
    if (other == places_.end()) continue;
    const Entry &left = entries_[i], &right = entries_[other->second];
    return {.exponent = exponent,
            .method = Entry::Method::product,
            .left = i,
            .right = other->second,
            .fixed = left.fixed + right.fixed + 1.5,
            .growing = left.growing + right.growing};
  }
  return {.exponent = exponent,
          .method = Entry::Method::exponential,
          .fixed = 1.5,
          .growing = 1.5 * std::abs(exponent.convert_to<double>())};
}

std::size_t PowerTable::index(const Rational& exponent) {
  const auto [place, is_new] = places_.try_emplace(exponent, entries_.size());
  if (is_new) entries_.push_back(cheapest_entry(exponent));
  return place->second;
}

}  // namespace fde::reference
