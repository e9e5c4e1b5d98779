#include "linear_transform.hpp"

#include <map>

namespace fde {
namespace {

template <class Real>
Complex<Real> decimal_complex(const std::complex<double>& z) {
  return {decimal<Real>(z.real()), decimal<Real>(z.imag())};
}

int ceiling(double order) { return static_cast<int>(std::ceil(order)); }

// coefficient * s^exponent, with the modulus of what the coefficient was summed from.
template <class Real>
struct Monomial {
  Complex<Real> coefficient;
  Real size, exponent;
};

constexpr double same_exponent = 1e-12;

template <class Real>
void collect(std::vector<Monomial<Real>>& monomials, const Complex<Real>& coefficient, const Real& exponent) {
  using std::abs;
  const auto place = std::ranges::find_if(monomials, [&](const Monomial<Real>& other) {
    return abs(Real(other.exponent - exponent)) < Real(same_exponent);
  });
  if (place == monomials.end()) {
    monomials.push_back({coefficient, size_of(coefficient), exponent});
  } else {
    place->coefficient += coefficient;
    place->size += size_of(coefficient);
  }
}

// The numerator of an output, times s^(1-o_n).
template <class Real>
std::vector<Monomial<Real>> numerator(const LinearTransform<Real>& transform,
                                      const typename LinearTransform<Real>::Group& group,
                                      const typename LinearTransform<Real>::Output& output) {
  const Real shift = output.order - transform.characteristic.terms.back().order;
  std::vector<Monomial<Real>> monomials;
  for (const auto& load : group.loads)
    collect(monomials, Complex<Real>(load.coefficient), Real(shift - load.power));
  for (std::size_t k = 0; group.with_initial && k < transform.initial.size(); ++k) {
    const int order_taken = static_cast<int>(k);
    const bool removed = order_taken < output.ceiling;
    for (std::size_t i = 0; i < transform.ceilings.size(); ++i) {
      const auto& [coefficient, order] = transform.characteristic.terms[i];
      if (removed == (transform.ceilings[i] > order_taken)) continue;
      const Complex<Real> data = transform.initial[k] * coefficient;
      collect(monomials, removed ? Complex<Real>(-data) : data, Real(order - order_taken + shift));
    }
  }
  return monomials;
}

}  // namespace

template <class Real>
LinearTransform<Real>::LinearTransform(const LinearEquation& equation, const std::vector<double>& orders) {
  read_terms(equation);
  for (const auto& value : equation.initial) {
    initial.push_back(decimal_complex<Real>(value));
    real = real && value.imag() == 0.0;
  }
  for (const double order : orders) {
    const Real value = decimal<Real>(order);
    outputs.push_back({value, ceiling(order), exponent_index(order, value)});
  }
  read_loads(equation);
}

template <class Real>
void LinearTransform<Real>::read_terms(const LinearEquation& equation) {
  std::map<double, Complex<Real>> sums;
  for (const auto& [coefficient, order, time_scale] : equation.terms) {
    using std::pow;
    const Real scale = pow(decimal<Real>(time_scale), decimal<Real>(order));
    sums.try_emplace(order, Complex<Real>(0)).first->second += decimal_complex<Real>(coefficient) * scale;
    real = real && coefficient.imag() == 0.0;
  }
  for (const auto& [order, coefficient] : sums) {
    if (size_of(coefficient) == 0) continue;
    const Real value = decimal<Real>(order);
    characteristic.terms.push_back({coefficient, value});
    ceilings.push_back(ceiling(order));
    term_exponents.push_back(exponent_index(order, value));
  }
}

template <class Real>
void LinearTransform<Real>::read_loads(const LinearEquation& equation) {
  groups.push_back({Real(0), true, {}});
  std::map<double, std::size_t> group_of{{0.0, 0}};
  for (const auto& [coefficient, power, from] : equation.loads) {
    if (coefficient == 0.0) continue;
    const auto [place, is_new] = group_of.try_emplace(from, groups.size());
    if (is_new) groups.push_back({decimal<Real>(from), false, {}});
    const Real exact_power = decimal<Real>(power), next = exact_power + 1;
    groups[place->second].loads.push_back(
        {decimal<Real>(coefficient) * gamma(next), exact_power, exponent_index(-power - 1.0, Real(-next))});
  }
}

template <class Real>
std::size_t LinearTransform<Real>::exponent_index(double name, const Real& value) {
  for (std::size_t i = 0; i < exponents.size(); ++i) {
    if (exponents[i].name == name) return i;
  }
  exponents.push_back({name, value});
  return exponents.size() - 1;
}

// Initial value theorem: the limit of s times the transform as s -> infinity, where P ~ c_n s^(o_n). It is
// what stands at s^0; a higher power, if any is left, makes the response infinite.
template <class Real>
void LinearTransform<Real>::add_start_values(const Group& group, std::vector<Sum<Real>>& sums) const {
  const Complex<Real>& leading = characteristic.terms.back().coefficient;
  for (std::size_t j = 0; j < outputs.size(); ++j) {
    for (const auto& [coefficient, size, exponent] : numerator(*this, group, outputs[j])) {
      const bool vanishes = size_of(coefficient) <= 16 * epsilon<Real>() * size;
      if (vanishes || exponent < Real(-same_exponent)) continue;
      const Complex<Real> limit = coefficient / leading;
      if (exponent < Real(same_exponent)) {
        sums[j].add(limit, Real(size / size_of(leading)), Real(16 * epsilon<Real>()), Real(1));
      } else {
        sums[j].add_infinite(limit, exponent);
      }
    }
  }
}

template struct LinearTransform<long double>;
template struct LinearTransform<BigReal>;

}  // namespace fde
