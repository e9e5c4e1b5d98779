// SPDX-License-Identifier: MIT
#include "fdebench/reference/linear/transfer_functions/linear_response.hpp"

#include "fdebench/schemes/problem/progress/progress.hpp"

namespace fde::reference {
namespace {

// Long double evaluations are too short to report progress.
template <class Real>
void report_step(std::size_t done, std::size_t total) {
  if constexpr (std::is_same_v<Real, BigReal>) report_progress(done, total);
}

// Whether e^p of a pole far in the left half plane is negligible at every number of digits; off: a bound of
// the error of log p.
template <class Real>
bool is_negligible(const Complex<Real>& log_p, const Real& off) {
  using std::cos, std::exp;
  constexpr double least = 1e6;
  const Real cosine = cos(imag_part<Real>(log_p)) + off;
  return cosine < 0 && exp(real_part<Real>(log_p)) * cosine < -least;
}

// Rounding error of log p for a zero found by Newton's method.
template <class Real>
Real rounding_of(const Complex<Real>& log_p) {
  return Real(64 * (1 + norm1(log_p)) * epsilon<Real>());
}

// Largest radius of a circle in the plane of log p around a cluster of zeros: it stays away from other zeros,
// and e^p varies moderately on it. The circle encloses a cluster whose radius is at most largest_spread times
// its own.
template <class Real>
Real largest_radius(const Zero<Real>& zero, const Complex<Real>& center) {
  using std::abs, std::exp, std::min;
  return min(Real(0.25), min(Real(zero.isolation / 2), Real(4 / abs(Complex<Real>(exp(center))))));
}
constexpr double largest_spread = 0.9;

}  // namespace

bool is_unresolvable_cluster(const Zero<long double>& zero, long double log_time) {
  const std::complex<long double> center = zero.log + log_time;
  return zero.multiplicity > 1 &&
         !is_negligible<long double>(center, rounding_of<long double>(center) + zero.radius) &&
         zero.radius > largest_spread * largest_radius<long double>(zero, center);
}

template <class Real>
NodePowers<Real> powers_at_nodes(const RoundedTransform<Real>& transform, const Contour<Real>& contour) {
  NodePowers<Real> powers;
  for (const auto& node : contour.nodes())
    transform.table.evaluate(transform.exponents, node.log_s, node.s, powers.emplace_back());
  return powers;
}

template <class Real>
LinearResponse<Real>::LinearResponse(const RoundedTransform<Real>& transform, const Group& group,
                                     const Real& time)
    : transform_(transform), log_time_(0), log_time_size_(0) {
  using std::abs, std::log;
  log_time_ = log(time);
  log_time_size_ = abs(log_time_);
  transform.table.evaluate(transform.exponents, log_time_, time, time_powers_);
  denominator_ = scaled(transform.denominator, Real(1));
  for (const auto& numerator : group.numerators)
    numerators_.push_back(scaled(numerator, Real(Real(1) / time)));
}

template <class Real>
typename LinearResponse<Real>::Polynomial LinearResponse<Real>::scaled(const Polynomial& polynomial,
                                                                       const Real& factor) const {
  Polynomial result = polynomial;
  for (auto& [power, coefficient, size] : result) {
    const Real scale = factor / time_powers_[power];
    coefficient *= scale;
    size *= scale;
  }
  return result;
}

template <class Real>
void LinearResponse<Real>::evaluate(const Complex<Real>& log_p, const Complex<Real>& p) {
  transform_.table.evaluate(transform_.exponents, log_p, p, powers_);
  evaluate_sums(log_p, p);
}

template <class Real>
void LinearResponse<Real>::evaluate_sums(const Complex<Real>& log_p, const Complex<Real>& p) {
  constexpr double coefficient_ulps = 4.0;
  p_ = p;
  const Real logs = norm1(log_p) + log_time_size_;
  errors_.clear();
  for (std::size_t i = 0; i < powers_.size(); ++i) {
    const auto& entry = transform_.table.entries()[i];
    errors_.push_back(norm1(powers_[i]) * (coefficient_ulps + 2 * entry.fixed + entry.growing * logs));
  }
  characteristic_ = sum_of(denominator_);
}

template <class Real>
typename LinearResponse<Real>::Value LinearResponse<Real>::sum_of(const Polynomial& polynomial) const {
  Value sum{Complex<Real>(0), Real(0)};
  for (const auto& [power, coefficient, size] : polynomial) {
    sum.value += coefficient * powers_[power];
    sum.error += size * errors_[power];
  }
  sum.error *= 1.0 + static_cast<double>(polynomial.size()) /
                         8.0;  // additions, relative to terms with errors of at least 4 ulps
  return sum;
}

template <class Real>
typename LinearResponse<Real>::Slope LinearResponse<Real>::slope() const {
  Slope slope{Complex<Real>(0), Complex<Real>(0)};
  for (const auto& [power, coefficient, size] : denominator_) {
    const Real& exponent = transform_.exponents[power];
    const Complex<Real> term = Real(exponent * coefficient) * powers_[power];
    slope.value += term;
    slope.change += exponent * term;
  }
  return slope;
}

// Adds factor, with a relative error of `ulps`, times every numerator.
template <class Real>
void LinearResponse<Real>::add_terms(LinearValues<Real>& values, const Complex<Real>& factor,
                                     const Real& ulps, const Real& share) const {
  const Real factor_size = norm1(factor), relative = epsilon<Real>();
  for (std::size_t j = 0; j < numerators_.size(); ++j) {
    const auto [value, error] = sum_of(numerators_[j]);
    const Complex<Real> term = factor * value;
    values.rates[j] += p_ * term;
    values.sums[j].add(term, Real(factor_size * error + ulps * norm1(term)), relative, share);
  }
}

template <class Real>
void LinearResponse<Real>::add_nodes(LinearValues<Real>& values, const Contour<Real>& contour,
                                     const NodePowers<Real>& powers) {
  const auto& nodes = contour.nodes();
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const auto& node = nodes[k];
    report_step<Real>(k, nodes.size());
    powers_ = powers[k];
    evaluate_sums(node.log_s, node.s);
    const Real ulps = 3 + norm1(node.s) + characteristic_.error / norm1(characteristic_.value);
    // The real part of twice the term is its sum with the term of the conjugate node.
    add_terms(values, Real(2) * node.weight / characteristic_.value, ulps, contour.exp_minus_mu());
  }
}

// log s* + log t may cancel, and e^p amplifies the rounding of the two. After one Newton step on the scaled
// denominator, where nothing large cancels, only the error of its own evaluation remains.
template <class Real>
typename LinearResponse<Real>::Pole LinearResponse<Real>::at_pole(const Complex<Real>& estimate) {
  using std::exp;
  const Complex<Real> rough = exp(estimate);
  evaluate(estimate, rough);
  const Complex<Real> step = characteristic_.value / slope().value, log = estimate - step;
  const Complex<Real> pole = rough - rough * step;
  evaluate(log, pole);
  const auto [slope, change] = this->slope();
  const Real noise = characteristic_.error / norm1(slope), ulps = 1 + norm1(log) + noise;
  const Real top = transform_.exponents[denominator_.back().power];
  for (std::size_t i = 0; i < powers_.size(); ++i) {
    using std::abs;
    errors_[i] += abs(transform_.exponents[i]) * norm1(powers_[i]) * ulps;
  }
  return {log, pole, slope, ulps, Real(top * noise + norm1(change) / norm1(slope) * ulps)};
}

// Simple pole: Res(e^p N/P) = e^p N / P', times the factor of the contour.
template <class Real>
void LinearResponse<Real>::add_residue(LinearValues<Real>& values, const Complex<Real>& estimate,
                                       const Contour<Real>& contour, const Real& count) {
  using std::exp;
  if (contour.at_branch_point(estimate) || is_negligible<Real>(estimate, rounding_of<Real>(estimate))) return;
  const auto [log_pole, pole, slope, pole_ulps, slope_ulps] = at_pole(estimate);
  if (exp_overflows(pole, Real(pole_ulps * epsilon<Real>()))) {
    const Complex<Real> direction = exp(Complex<Real>(Real(0), imag_part<Real>(pole))) * pole / slope;
    for (std::size_t j = 0; j < numerators_.size(); ++j) {
      const auto [value, error] = sum_of(numerators_[j]);
      if (norm1(value) > 16 * epsilon<Real>() * error) {
        values.sums[j].add_infinite(direction * value, real_part<Real>(pole));
      } else {  // the residue may be 0: its numerator is lost in rounding
        values.sums[j].error = std::numeric_limits<double>::infinity();
      }
    }
    return;
  }
  const Complex<Real> factor = contour.pole_factor(log_pole);
  const Real shift = 1 + norm1(pole) + contour.omega() * norm1(Complex<Real>(factor - Real(1)));
  const Real ulps = 3 + slope_ulps + shift * pole_ulps;
  add_terms(values, count * exp(pole) * factor * pole / slope, ulps, Real(1));
}

// Adds the sum of the residues of a cluster of poles, by the trapezoidal rule on a circle around them in the
// plane of log p. The circle stays away from the other poles and from the nodes, where the factor m of the
// contour has poles.
template <class Real>
void LinearResponse<Real>::add_cluster_residues(LinearValues<Real>& values, const Zero<Real>& zero,
                                                const Contour<Real>& contour, const Real& count) {
  using std::abs, std::conj, std::exp, std::log, std::min;
  const Complex<Real> center = zero.log + log_time_;
  if (contour.at_branch_point(center) || is_negligible<Real>(center, rounding_of<Real>(center) + zero.radius))
    return;
  Real radius = largest_radius<Real>(zero, center);
  for (const auto& node : contour.nodes()) {
    const Complex<Real> upper = center - node.log_s, lower = center - conj(node.log_s);
    radius = min(radius, Real(min(Real(abs(upper)), Real(abs(lower))) / 2));
  }
  if (zero.radius >
      Real(largest_spread) * radius) {  // the infinite bound leads to more digits and other nodes
    for (auto& sum : values.sums) sum.error = std::numeric_limits<double>::infinity();
    return;
  }
  // The zeros are within fraction * radius, others at twice the radius or more: the error of n points is
  // fraction^n.
  const Real fraction = std::clamp(Real(zero.radius / radius), Real(0.5), Real(largest_spread));
  const int points = 8 + static_cast<int>(log(epsilon<Real>()) / log(fraction));
  for (int i = 0; i < points; ++i) {
    report_step<Real>(static_cast<std::size_t>(i), static_cast<std::size_t>(points));
    const Complex<Real> offset = radius * exp(Complex<Real>(Real(0), Real(2 * i * pi<Real>() / points)));
    const Complex<Real> log_p = center + offset, p = exp(log_p);
    evaluate(log_p, p);
    const Real ulps = 6 + 2 * norm1(p) + characteristic_.error / norm1(characteristic_.value);
    const Complex<Real> weight = exp(p) * p * contour.pole_factor(log_p) * offset * Real(count / points);
    add_terms(values, weight / characteristic_.value, ulps, Real(1));
  }
}

template <class Real>
void LinearResponse<Real>::add_to(LinearValues<Real>& values, const std::vector<Zero<Real>>& zeros,
                                  const Contour<Real>& contour, const NodePowers<Real>& powers) {
  constexpr double on_the_axis = 1e-7;  // closer conjugate pairs are one zero of multiplicity 2
  add_nodes(values, contour, powers);
  for (const auto& zero : zeros) {
    const Real height = imag_part<Real>(zero.log);
    if (height < -on_the_axis) continue;  // the real part of twice its conjugate is the sum of both
    const Real count(height > on_the_axis ? 2 : 1);
    if (zero.multiplicity > 1) {
      add_cluster_residues(values, zero, contour, count);
    } else {
      add_residue(values, zero.log + log_time_, contour, count);
    }
  }
}

// |F| on circles is estimated by its terms over the largest term of the denominator.
template <class Real>
void LinearResponse<Real>::add_discretisation(LinearValues<Real>& values, const Contour<Real>& contour) {
  using std::log;
  for (std::size_t j = 0; j < numerators_.size(); ++j) {
    values.sums[j].error += contour.discretisation_error([&](const Real& r) {
      evaluate(Complex<Real>(Real(log(r))), Complex<Real>(r));
      Real largest(0);
      for (const auto& [power, coefficient, size] : denominator_)
        largest = std::max(largest, Real(size * norm1(powers_[power])));
      return Real(sum_of(numerators_[j]).error / largest);
    });
  }
}

template NodePowers<long double> powers_at_nodes(const RoundedTransform<long double>&,
                                                 const Contour<long double>&);
template NodePowers<BigReal> powers_at_nodes(const RoundedTransform<BigReal>&, const Contour<BigReal>&);
template class LinearResponse<long double>;
template class LinearResponse<BigReal>;

}  // namespace fde::reference
