#include "linear_response.hpp"

#include <array>

namespace fde {

template <class Real>
LinearResponse<Real>::LinearResponse(const LinearTransform<Real>& transform,
                                     const typename LinearTransform<Real>::Group& group, const Real& time)
    : transform_(transform), log_time_(0) {
  using std::log, std::pow;
  log_time_ = log(time);
  for (const auto& [coefficient, order] : transform.characteristic.terms)
    coefficients_.push_back(coefficient * Real(pow(time, Real(-order))));
  for (std::size_t k = 0; group.with_initial && k < transform.initial.size(); ++k)
    initial_.push_back(transform.initial[k] * Real(pow(time, Real(k))));
  for (const auto& load : group.loads)
    loads_.emplace_back(Real(load.coefficient * pow(time, load.power)), load.exponent);
  for (const auto& output : transform.outputs) output_scales_.push_back(pow(time, Real(-output.order)));
  numerators_.resize(transform.outputs.size());
  numerator_sizes_.resize(transform.outputs.size());
}

template <class Real>
void LinearResponse<Real>::evaluate(const Complex<Real>& log_p, const Complex<Real>& p) {
  using std::exp;
  const auto power = [&](const auto& exponent) -> Complex<Real> {
    if (exponent.name == 0.0) return Complex<Real>(1);
    if (exponent.name == 1.0) return p;
    if (exponent.name == 2.0) return p * p;
    if (exponent.name == -1.0) return Real(1) / p;
    return exp(exponent.value * log_p);
  };
  powers_.clear();
  for (const auto& exponent : transform_.exponents) powers_.push_back(power(exponent));
  combine(p);
}

// P and the numerators, from the powers of p.
template <class Real>
void LinearResponse<Real>::combine(const Complex<Real>& p) {
  constexpr std::size_t most = 2;  // orders up to 2: two initial values
  std::array<Complex<Real>, most> above{},
      below{};  // sums of c_i p^(o_i) with ceil(o_i) > k, and of the others
  std::array<Real, most> above_size{}, below_size{};
  characteristic_ = slope_ = Complex<Real>(0);
  characteristic_size_ = largest_term_ = Real(0);
  for (std::size_t i = 0; i < coefficients_.size(); ++i) {
    const Complex<Real> term = coefficients_[i] * powers_[transform_.term_exponents[i]];
    const Real size = size_of(term);
    characteristic_ += term;
    slope_ += transform_.characteristic.terms[i].order * term;
    characteristic_size_ += size;
    largest_term_ = std::max(largest_term_, size);
    for (std::size_t k = 0; k < initial_.size(); ++k) {
      const bool higher = transform_.ceilings[i] > static_cast<int>(k);
      (higher ? above : below)[k] += term;
      (higher ? above_size : below_size)[k] += size;
    }
  }
  Complex<Real> loads(0), inverse(Real(1) / p);
  for (const auto& [coefficient, exponent] : loads_) loads += coefficient * powers_[exponent];
  const Real loads_size = size_of(loads);
  for (std::size_t j = 0; j < numerators_.size(); ++j) {
    Complex<Real> sum = loads, data(1);
    Real size = loads_size;
    for (std::size_t k = 0; k < initial_.size(); ++k) {
      data *= inverse;
      const bool removed = static_cast<int>(k) < transform_.outputs[j].ceiling;
      const Complex<Real> value = initial_[k] * data;
      sum += removed ? -value * below[k] : value * above[k];
      size += size_of(value) * (removed ? below_size : above_size)[k];
    }
    const Complex<Real> scale = output_scales_[j] * powers_[transform_.outputs[j].exponent];
    numerators_[j] = scale * sum;
    numerator_sizes_[j] = size_of(scale) * size;
  }
}

// Adds factor times every numerator.
template <class Real>
void LinearResponse<Real>::add_terms(std::vector<Sum<Real>>& sums, const Complex<Real>& factor,
                                     const Real& ulps, const Real& share) const {
  const Real size = size_of(factor), relative = ulps * epsilon<Real>();
  for (std::size_t j = 0; j < sums.size(); ++j)
    sums[j].add(factor * numerators_[j], Real(size * numerator_sizes_[j]), relative, share);
}

template <class Real>
void LinearResponse<Real>::add_nodes(std::vector<Sum<Real>>& sums, const Contour<Real>& contour) {
  using std::conj;
  const auto add = [&](const Complex<Real>& weight, const Real& ulps) {
    const Real loss = 1 + characteristic_size_ / size_of(characteristic_);
    add_terms(sums, Complex<Real>(weight / characteristic_), Real(ulps * loss), contour.share());
  };
  for (const auto& node : contour.nodes()) {
    const Real ulps = 3 + size_of(node.log_s);
    evaluate(node.log_s, node.s);
    if (transform_.real) {
      add(Real(2) * node.weight, ulps);  // the real part of which is the sum with the conjugate
      continue;
    }
    add(node.weight, ulps);
    for (auto& power : powers_) power = conj(power);
    combine(conj(node.s));
    add(conj(node.weight), ulps);
  }
}

// Simple pole: Res(e^p N/P) = e^p N / P', times the factor of the contour.
template <class Real>
void LinearResponse<Real>::add_residue(std::vector<Sum<Real>>& sums, const Complex<Real>& log_pole,
                                       const Contour<Real>& contour) {
  using std::exp;
  const Complex<Real> pole = exp(log_pole);
  if (contour.at_branch_point(log_pole) || real_part<Real>(pole) < -8 / epsilon<Real>()) return;
  evaluate(log_pole, pole);
  const Real pole_ulps = 1 + (1 + size_of(log_pole)) * characteristic_size_ / size_of(slope_);
  if (exp_overflows(pole, Real(pole_ulps * epsilon<Real>()))) {
    const Complex<Real> direction = exp(Complex<Real>(Real(0), imag_part<Real>(pole))) * pole / slope_;
    for (std::size_t j = 0; j < sums.size(); ++j)
      sums[j].add_infinite(direction * numerators_[j], real_part<Real>(pole));
    return;
  }
  const Complex<Real> factor = contour.pole_factor(log_pole);
  const Real ulps =
      3 + (1 + size_of(pole) + contour.omega() * size_of(Complex<Real>(factor - Real(1)))) * pole_ulps;
  add_terms(sums, exp(pole) * factor * pole / slope_, ulps, Real(1));
}

// Poles that cannot be told apart: the sum of their residues, by the trapezoidal rule on a circle round them
// in the plane of log p. It stays clear of the other poles, and of the nodes, where the factor of the contour
// has poles.
template <class Real>
void LinearResponse<Real>::add_circle(std::vector<Sum<Real>>& sums, const Zero<Real>& zero,
                                      const Contour<Real>& contour) {
  using std::abs, std::conj, std::exp, std::log, std::min;
  const Complex<Real> center = zero.log + log_time_;
  if (contour.at_branch_point(center)) return;
  Real radius = min(Real(0.25), min(Real(zero.isolation / 2), Real(4 / abs(Complex<Real>(exp(center))))));
  for (const auto& node : contour.nodes()) {
    const Complex<Real> upper = center - node.log_s, lower = center - conj(node.log_s);
    radius = min(radius, Real(min(Real(abs(upper)), Real(abs(lower))) / 2));
  }
  // Zeros at that fraction of the radius, others at twice the radius and more: what n points leave is
  // fraction^n.
  const Real fraction = std::clamp(Real(zero.spread / radius), Real(0.5), Real(0.95));
  const int points = 8 + static_cast<int>(log(epsilon<Real>()) / log(fraction));
  for (int i = 0; i < points; ++i) {
    const Complex<Real> offset = radius * exp(Complex<Real>(Real(0), Real(2 * i * pi<Real>() / points)));
    const Complex<Real> log_p = center + offset, p = exp(log_p);
    evaluate(log_p, p);
    const Real ulps = 6 + size_of(p) + characteristic_size_ / size_of(characteristic_);
    const Complex<Real> weight = exp(p) * p * contour.pole_factor(log_p) * offset / Real(points);
    add_terms(sums, weight / characteristic_, ulps, Real(1));
  }
}

template <class Real>
void LinearResponse<Real>::add_to(std::vector<Sum<Real>>& sums, const std::vector<Zero<Real>>& zeros,
                                  const Contour<Real>& contour) {
  add_nodes(sums, contour);
  for (const auto& zero : zeros) {
    if (zero.multiplicity > 1) {
      add_circle(sums, zero, contour);
    } else {
      add_residue(sums, zero.log + log_time_, contour);
    }
  }
}

template <class Real>
void LinearResponse<Real>::add_discretisation(std::vector<Sum<Real>>& sums, const Contour<Real>& contour) {
  using std::log;
  for (std::size_t j = 0; j < sums.size(); ++j) {
    sums[j].error += contour.discretisation([&](const Real& r) {
      evaluate(Complex<Real>(Real(log(r))), Complex<Real>(r));
      return Real(numerator_sizes_[j] / largest_term_);
    });
  }
}

template class LinearResponse<long double>;
template class LinearResponse<BigReal>;

}  // namespace fde
