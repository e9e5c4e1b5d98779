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

}  // namespace fde::reference
