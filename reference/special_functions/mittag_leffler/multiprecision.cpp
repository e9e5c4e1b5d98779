// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/mittag_leffler/multiprecision.hpp"

#include <stdexcept>

#include "fdebench/reference/special_functions/laplace/contour.hpp"
#include "fdebench/reference/special_functions/laplace/contour_bound.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/forms.hpp"
#include "fdebench/reference/special_functions/numbers/reciprocal_gamma.hpp"
#include "fdebench/schemes/problem/progress/progress.hpp"

namespace fde::reference {
namespace {

using Arguments = MittagLefflerArguments;

// For real s* with log s* above this, e^s* overflows however s* is rounded.
constexpr double beyond_exponents = 50.0;

// e^-nothing is near the smallest number that MPFR represents.
constexpr double nothing = 1e18;

// Adds Res(e^s F, s*) = (1/alpha) e^(s* + (1-beta) log s*) times a factor known to that many ulps.
void add_residue(BoundedSum<BigReal>& sum, const Arguments& x, const BigComplex& log_pole,
                 const BigComplex& factor, const BigReal& factor_ulps) {
  if (imag_part<BigReal>(log_pole) == 0 && real_part<BigReal>(log_pole) > beyond_exponents)
    return sum.add_infinite(BigComplex(1), exp(BigReal(real_part<BigReal>(log_pole))));
  const BigComplex pole = x.alpha == 1 ? x.z : BigComplex(exp(log_pole));
  if (real_part<BigReal>(pole) < -8 / epsilon<BigReal>()) {  // s* may have overflowed
    sum.error += exp(BigReal(-nothing));
    return;
  }
  const BigReal power = 1 - x.beta;
  const BigReal pole_ulps = x.alpha == 1 ? BigReal(1) : BigReal(1 + norm1(log_pole));
  const BigComplex exponent = pole + power * log_pole;
  if (real_part<BigReal>(exponent) + norm1(exponent) * pole_ulps * epsilon<BigReal>() < -nothing) {
    sum.error += exp(BigReal(-nothing));
    return;
  }
  if (exp_overflows(pole, BigReal(pole_ulps * epsilon<BigReal>()))) {
    sum.add_infinite(exp(BigComplex(BigReal(0), imag_part<BigReal>(exponent))), real_part<BigReal>(pole));
    return;
  }
  const BigComplex residue = exp(exponent) / x.alpha;
  const BigReal ulps = (norm1(pole) + factor_ulps) * pole_ulps + abs(power) * norm1(log_pole) + 4;
  sum.add(residue * factor, ulps * epsilon<BigReal>());
}

// The value for EvaluationForm::residues_only.
BoundedSum<BigReal> sum_of_residues(const Arguments& x) {
  const BigComplex log_z = log(x.z);
  BoundedSum<BigReal> sum;
  for (int sheet = 0; sheet < x.alpha; ++sheet) {
    const BigComplex log_pole = log_on_sheet<BigReal>(log_z, sheet) / x.alpha;
    add_residue(sum, x, log_pole, BigComplex(1), BigReal(0));
  }
  return sum;
}

// s^-beta at a node, without an exponential for beta = 0, 1 and 2.
BigComplex power_minus_beta(const Arguments& x, const Contour<BigReal>::Node& node) {
  if (x.beta == 0) return {1};
  if (x.beta == 1) return 1 / node.s;
  if (x.beta == 2) return 1 / (node.s * node.s);
  return exp(BigComplex(-x.beta * node.log_s));
}

void add_nodes(BoundedSum<BigReal>& sum, const Arguments& x, const Contour<BigReal>& contour) {
  const bool equal = x.beta == x.alpha;
  const BigReal powers = 2 * x.alpha + abs(x.beta);
  const auto& nodes = contour.nodes();
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const auto& node = nodes[k];
    report_progress(k, nodes.size());
    const BigComplex s_alpha = exp(BigComplex(x.alpha * node.log_s));
    const BigComplex weight =
        equal ? node.weight : BigComplex(node.weight * s_alpha * power_minus_beta(x, node));
    const BigReal ulps = 3 + powers * norm1(node.log_s);
    const auto loss = [&](const BigComplex& difference) {  // by cancellation in s^alpha - z
      return BigReal(ulps * (1 + norm1(s_alpha) / norm1(difference)) * epsilon<BigReal>());
    };
    const BigComplex denominator = s_alpha - x.z, term = weight / denominator;
    if (x.real()) {
      const BigComplex with_conjugate(BigReal(2 * real_part<BigReal>(term)));
      sum.add(with_conjugate, BigReal(2 * norm1(term)), loss(denominator), BigReal(1));
      continue;
    }
    const BigComplex mirrored = conj(s_alpha) - x.z;
    sum.add(term, loss(denominator), BigReal(1));
    sum.add(BigComplex(conj(weight) / mirrored), loss(mirrored), BigReal(1));
  }
}

// 1 + i theta = sqrt(s* / mu) for the point theta of a pole on a contour, with its modulus clamped to the
// range of double.
std::complex<double> root_on(double mu, const BigComplex& log_pole) {
  constexpr double most_log = 600.0;
  const double log_size = real_part<BigReal>(log_pole).convert_to<double>() - std::log(mu);
  const double modulus = std::exp(std::clamp(log_size, -most_log, most_log) / 2.0);
  return std::polar(modulus, imag_part<BigReal>(log_pole).convert_to<double>() / 2.0);
}

// The sum of the residues that overflow. If there are any, everything else is negligible.
BoundedSum<BigReal> overflowing_residues(const Arguments& x) {
  constexpr double least_log = 40.0;  // log |s*| below which e^s* does not overflow
  BoundedSum<BigReal> sum;
  for (const auto& [sheet, log_pole] : poles_of(x.alpha, BigComplex(log(x.z))).on_near_sheets) {
    if (real_part<BigReal>(log_pole) < least_log ||
        abs(BigReal(imag_part<BigReal>(log_pole))) > pi<BigReal>())
      continue;
    BoundedSum<BigReal> residue;
    add_residue(residue, x, log_pole, BigComplex(1), BigReal(0));
    if (residue.overflows) sum.add_infinite(residue.value, residue.largest_exponent);
  }
  return sum;
}

BoundedSum<BigReal> on_contour(const Arguments& x, int digits) {
  const BigComplex log_z = log(x.z);
  const auto exponent = BigReal(x.alpha - x.beta).convert_to<double>();
  const Contour<BigReal>& contour = contour_for(digits, exponent);
  const ContourShape shape = contour.shape();
  const Poles<BigReal> poles = poles_of(x.alpha, log_z);
  PerSheet<std::complex<double>> roots;
  for (const auto& pole : poles.on_near_sheets) roots.push_back(root_on(shape.mu, pole.log));
  const auto [log_bound, distance] =
      ContourBound(shape).bound_for({.exponent = exponent,
                                     .alpha = x.alpha.convert_to<double>(),
                                     .log_size = real_part<BigReal>(log_z).convert_to<double>(),
                                     .nearest_other_argument = poles.nearest_other_argument,
                                     .roots = {roots.data(), roots.size()}});
  BoundedSum<BigReal> sum;
  for (std::size_t i = 0; i < roots.size(); ++i) {
    if (!ContourBound::includes_residue(roots[i], distance)) continue;
    const BigComplex& log_pole = poles.on_near_sheets[i].log;
    const BigComplex factor = contour.pole_factor(log_pole);
    const BigReal off = norm1(BigComplex(factor - 1));
    // To the right of both far lines of ContourBound the exact factor is 1.
    const BigReal beyond =
        roots[i].real() > shape.nearer_far_line() ? BigReal(off / epsilon<BigReal>()) : BigReal(0);
    add_residue(sum, x, log_pole, factor, BigReal(contour.omega() * off + beyond));
  }
  add_nodes(sum, x, contour);
  sum.error += exp(BigReal(log_bound));
  return sum;
}

void scale(BoundedSum<BigReal>& sum, const BigComplex& factor) {
  sum.value *= factor;
  sum.error = norm1(factor) * sum.error + 8 * epsilon<BigReal>() * norm1(sum.value);
}

// With the first two terms of the asymptotic expansion peeled off (forms.hpp). For large |z| they are most of
// the value; for beta = alpha the first is 0 and the second is most of it.
BoundedSum<BigReal> with_leading_terms(const Arguments& x, int digits) {
  const BigComplex inverse = 1 / x.z, square = inverse * inverse;
  const BigReal first = x.beta - x.alpha, second = first - x.alpha;
  BoundedSum<BigReal> sum = on_contour({x.alpha, second, x.z}, digits);
  scale(sum, square);
  add_reciprocal_gamma(sum, -inverse, first, BigReal(abs(x.beta) + x.alpha));
  add_reciprocal_gamma(sum, -square, second, BigReal(abs(x.beta) + 2 * x.alpha));
  return sum;
}

BoundedSum<BigReal> at_zero(const Arguments& x) {
  BoundedSum<BigReal> sum;
  const BigReal size = is_integer(x.beta) ? BigReal(0) : BigReal(abs(x.beta));
  add_reciprocal_gamma(sum, BigComplex(1), x.beta, size);
  return sum;
}

BoundedSum<BigReal> evaluate(const Arguments& x, int digits) {
  const EvaluationForm form = evaluation_form(x.alpha, x.beta, x.z);
  if (form == EvaluationForm::at_zero) return at_zero(x);
  if (form == EvaluationForm::residues_only) return sum_of_residues(x);
  if (BoundedSum<BigReal> overflow = overflowing_residues(x); overflow.overflows) return overflow;
  if (form == EvaluationForm::shifted_beta) {
    BoundedSum<BigReal> sum = evaluate({x.alpha, BigReal(x.alpha + x.beta), x.z}, digits);
    scale(sum, x.z);
    return sum;
  }
  constexpr double far = 65536.0;
  return norm1(x.z) < far ? on_contour(x, digits) : with_leading_terms(x, digits);
}

// Decimal digits by which the phases of e^s* exceed one turn, for the poles that are not far in the left half
// plane. Throws std::runtime_error if e^s* overflows and its phase takes `most` digits or more.
int phase_digits(const Arguments& x, int most) {
  if (x.z == 0) return 0;
  constexpr double left = -1e-3, next_to_the_axis = -1e-10, log_of_far = 40.0,
                   circle = 1.01 * std::numbers::pi, grows = 0.5 * std::numbers::pi * (1.0 - 1e-15);
  const bool only = evaluation_form(x.alpha, x.beta, x.z) == EvaluationForm::residues_only;
  double digits = 0.0;
  for (const auto& [sheet, log_pole] : poles_of(x.alpha, BigComplex(log(x.z))).on_near_sheets) {
    const auto log_size = real_part<BigReal>(log_pole).convert_to<double>(),
               turned = std::abs(imag_part<BigReal>(log_pole).convert_to<double>());
    if (turned > circle || std::cos(turned) < (log_size > log_of_far ? next_to_the_axis : left)) continue;
    const double own = log_size / std::numbers::ln10;
    if (!only && imag_part<BigReal>(log_pole) != 0 && turned < grows && own >= most)
      throw std::runtime_error("the value overflows, and its phase takes more digits than can be had");
    digits = std::max(digits, own);
  }
  return static_cast<int>(std::min(digits, static_cast<double>(most))) + 1;
}

}  // namespace

Bounded<BigReal> mittag_leffler_multiprecision(int digits, int places,
                                               const std::function<MittagLefflerArguments()>& read) {
  constexpr int most_turns = 2000;  // the digits allowed for phases, beyond those for the value
  const int extra = phase_digits(read(), max_working_digits(digits) + most_turns) + places;
  return increase_digits_by_bound(digits, extra, [&](int working) { return evaluate(read(), working); });
}

}  // namespace fde::reference
