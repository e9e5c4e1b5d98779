// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/mittag_leffler/contour_kernels.hpp"

#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fdebench/reference/special_functions/mittag_leffler/contour_kernels.cpp"
#include <hwy/foreach_target.h>  // includes this file once for each target
#include <hwy/highway.h>

#include "fdebench/reference/special_functions/numbers/double_double-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace fde::reference::HWY_NAMESPACE {

// Unit of the errors below: sums and products have an error of at most a quarter of it, exponentials of four.
constexpr double unit_roundoff = 0x1p-103;

HWY_INLINE Real load(const ContourNodes::Column& column, std::size_t i) {
  return {hn::LoadU(tag, column.hi.data() + i), hn::LoadU(tag, column.lo.data() + i)};
}

HWY_INLINE DoubleDouble sum_of_lanes(const Real& x) {
  std::array<double, double_double_lanes> hi{}, lo{};
  hn::StoreU(x.hi, tag, hi.data());
  hn::StoreU(x.lo, tag, lo.data());
  DoubleDouble sum{0.0, 0.0};
  for (std::size_t i = 0; i < hn::Lanes(tag); ++i) {
    const DoubleDouble next = exact_sum(sum.hi, hi[i]);
    sum = {next.hi, sum.lo + next.lo + lo[i]};
  }
  return exact_sum(sum.hi, sum.lo);
}

HWY_INLINE double sum_of_lanes(Vector x) { return hn::GetLane(hn::SumOfLanes(tag, x)); }

// Partial sums over the nodes, one per lane.
struct Sums {
  ComplexVector value;
  Vector error;

  // Adds weight / (power - z) for sign = 1, or the term of the conjugate node for sign = -1: the conjugate of
  // weight / (power - conj z).
  HWY_INLINE void add(const ComplexVector& weight, const ComplexVector& power, const PowerQuotient& quotient,
                      double sign) {
    const ComplexVector difference{power.re + constant(-quotient.scaled.real()),
                                   power.im + constant(-sign * quotient.scaled.imag())};
    const Real inverse =
        reciprocal(sum_of_products(difference.re, difference.re, difference.im, difference.im));
    const ComplexVector conjugate{difference.re, -difference.im};
    const ComplexVector term = (weight * conjugate) * inverse;
    value.re = value.re + term.re;
    value.im = sign > 0.0 ? value.im + term.im : value.im - term.im;
    const Vector size = hn::Mul(hn::Mul(norm1(weight), norm1(difference)), inverse.hi);
    const Vector loss = hn::Mul(hn::Mul(norm1(power), norm1(difference)), inverse.hi);
    error = hn::Add(error, hn::MulAdd(size, loss, size));
  }
};

// Completes a sum over one half of the contour whose other half gives the conjugate.
HWY_INLINE void double_real_part(QuotientSum& sum) {
  sum.value.re = {2.0 * sum.value.re.hi, 2.0 * sum.value.re.lo};
  sum.value.im = {0.0, 0.0};
  sum.error *= 2.0;
}

QuotientSum sum_kernel(const ContourNodes& nodes, const PowerQuotient& quotient) {
  const bool real = quotient.scaled.imag() == 0.0;
  const Vector alpha = constant(quotient.alpha), scaling = constant(quotient.scale);
  const Real exponent = constant(quotient.exponent);
  const Real zero{hn::Zero(tag), hn::Zero(tag)};
  Sums sums{{zero, zero}, hn::Zero(tag)};
  for (std::size_t i = 0; i < nodes.size(); i += hn::Lanes(tag)) {
    const ComplexVector log{load(nodes.log_re, i), load(nodes.log_im, i)};
    const ComplexVector unscaled = exponential(log * alpha);
    const ComplexVector power{scale(unscaled.re, scaling), scale(unscaled.im, scaling)};
    const ComplexVector weight =
        ComplexVector{load(nodes.weight_re, i), load(nodes.weight_im, i)} * exponential(log * exponent);
    sums.add(weight, power, quotient, 1.0);
    if (!real) sums.add(weight, power, quotient, -1.0);
  }
  QuotientSum result{{sum_of_lanes(sums.value.re), sum_of_lanes(sums.value.im)}, sum_of_lanes(sums.error)};
  const double additions = 0.25 * static_cast<double>(nodes.size());
  const double powers = quotient.alpha + std::abs(quotient.exponent.hi);
  result.error *= unit_roundoff * (16.0 + additions + nodes.largest_log * powers);
  if (real) double_real_part(result);
  return result;
}

// log z by one Newton step for e^w = z from a logarithm in double, whose error is below 2^-40.
HWY_INLINE ComplexVector logarithm(const ComplexVector& z) {
  std::array<double, double_double_lanes> re{}, im{};
  hn::StoreU(z.re.hi, tag, re.data());
  hn::StoreU(z.im.hi, tag, im.data());
  for (std::size_t lane = 0; lane < hn::Lanes(tag); ++lane) {
    const std::complex<double> at(re[lane], im[lane]);
    re[lane] = std::log(std::abs(at));
    im[lane] = std::arg(at);
  }
  const Vector log_re = hn::LoadU(tag, re.data()), log_im = hn::LoadU(tag, im.data()), zero = hn::Zero(tag);
  const ComplexVector quotient =
      z * exponential(ComplexVector{{hn::Neg(log_re), zero}, {hn::Neg(log_im), zero}});
  const ComplexVector off{quotient.re + constant(-1.0), quotient.im};
  // log(1 + off) = off - off^2 / 2 + ...
  const Vector a = off.re.hi, b = off.im.hi, half = constant(-0.5);
  const Real square_re = off.re + hn::Mul(half, hn::Sub(hn::Mul(a, a), hn::Mul(b, b)));
  const Real square_im = off.im + hn::Neg(hn::Mul(a, b));
  return {square_re + log_re, square_im + log_im};
}

// Partial sums over the nodes, one per lane.
struct PowerSums {
  ComplexVector value;
  Vector terms,
      differences;  // sizes of the terms, times those of their exponents or times the cancellation in 1 - q

  HWY_INLINE void add(const ComplexVector& node_weight, const ComplexVector& log, const BinomialPower& power,
                      double sign) {
    const ComplexDoubleDouble& z = power.log_z;
    const ComplexVector scaled = log * constant(power.alpha),
                        log_z{constant(z.re), constant(DoubleDouble{sign * z.im.hi, sign * z.im.lo})};
    const ComplexVector turned = power.outward ? ComplexVector{scaled.re - log_z.re, scaled.im - log_z.im}
                                               : ComplexVector{log_z.re - scaled.re, log_z.im - scaled.im};
    const ComplexVector ratio = exponential(turned);
    const ComplexVector difference{-ratio.re + constant(1.0), -ratio.im};
    const ComplexVector raised = logarithm(difference) * constant(-power.singularity_order);
    const ComplexVector head = log * constant(power.exponent), exponent = head + raised;
    const ComplexVector term = node_weight * exponential(exponent);
    value.re = value.re + term.re;
    value.im = sign > 0.0 ? value.im + term.im : value.im - term.im;
    const Vector size = norm1(term), parts = hn::Add(norm1(head), norm1(raised));
    terms = hn::MulAdd(size, hn::Add(parts, constant(1.0)), terms);
    differences = hn::Add(
        differences, hn::Div(hn::Mul(size, hn::Add(norm1(ratio), norm1(difference))), norm1(difference)));
  }
};

QuotientSum power_kernel(const ContourNodes& nodes, const BinomialPower& power) {
  const Real zero{hn::Zero(tag), hn::Zero(tag)};
  PowerSums sums{{zero, zero}, hn::Zero(tag), hn::Zero(tag)};
  for (std::size_t i = 0; i < nodes.size(); i += hn::Lanes(tag)) {
    const ComplexVector log{load(nodes.log_re, i), load(nodes.log_im, i)};
    const ComplexVector weight{load(nodes.weight_re, i), load(nodes.weight_im, i)};
    sums.add(weight, log, power, 1.0);
    if (!power.real) sums.add(weight, log, power, -1.0);
  }
  QuotientSum result{{sum_of_lanes(sums.value.re), sum_of_lanes(sums.value.im)}, 0.0};
  const double additions = 0.25 * static_cast<double>(nodes.size());
  const double log_z = std::abs(power.log_z.re.hi) + std::abs(power.log_z.im.hi);
  const double ratio = 8.0 + 2.0 * (log_z + power.alpha * nodes.largest_log);
  result.error = unit_roundoff * ((24.0 + additions) * sum_of_lanes(sums.terms) +
                                  std::abs(power.singularity_order) * ratio * sum_of_lanes(sums.differences));
  if (power.real) double_real_part(result);
  return result;
}

// The same for x^j / p(x).
struct PolynomialSums {
  std::array<ComplexVector, max_degree> values;
  std::array<Vector, max_degree> errors;
  Vector largest_loss;

  // The relative error of p and the ulps are counted in units of unit_roundoff.
  HWY_INLINE void add(const ComplexVector& weight, const ComplexVector& x, const PolynomialQuotient& quotient,
                      double power_ulps, double weight_ulps, double sign) {
    const std::size_t degree = quotient.coefficients.size();
    ComplexVector sum{constant(DoubleDouble{1.0, 0.0}), constant(DoubleDouble{0.0, 0.0})};
    const Vector modulus = norm1(x);
    Vector lost = constant(static_cast<double>(degree) * power_ulps);
    for (std::size_t j = degree; j-- > 0;) {
      const auto& [re, im] = quotient.coefficients[j];
      sum = sum * x + ComplexVector{constant(re), constant(DoubleDouble{sign * im.hi, sign * im.lo})};
      const double own = (std::abs(re.hi) + std::abs(im.hi)) * (static_cast<double>(j) + 1.0) * power_ulps +
                         quotient.errors[j] / unit_roundoff;
      lost = hn::MulAdd(lost, modulus, constant(own));
    }
    const Real square = reciprocal(sum_of_products(sum.re, sum.re, sum.im, sum.im));
    ComplexVector term = weight * ComplexVector{sum.re * square, -sum.im * square};
    // |p| is at least half of |Re p| + |Im p|
    const Vector loss = hn::Mul(constant(2.0), hn::Div(lost, norm1(sum)));
    largest_loss = hn::Max(largest_loss, loss);
    for (std::size_t j = 0; j < degree; ++j) {
      values[j].re = values[j].re + term.re;
      values[j].im = sign > 0.0 ? values[j].im + term.im : values[j].im - term.im;
      const Vector relative = hn::Add(hn::Mul(constant(2.0), loss),
                                      constant(weight_ulps + static_cast<double>(j) * (power_ulps + 2.0)));
      errors[j] = hn::MulAdd(norm1(term), relative, errors[j]);
      if (j + 1 < degree) term = term * x;
    }
  }
};

std::array<QuotientSum, max_degree> polynomial_kernel(const ContourNodes& nodes,
                                                      const PolynomialQuotient& quotient) {
  const Real zero{hn::Zero(tag), hn::Zero(tag)};
  PolynomialSums sums{};
  sums.values.fill({zero, zero});
  sums.errors.fill(hn::Zero(tag));
  sums.largest_loss = hn::Zero(tag);
  bool real = true;
  for (const auto& coefficient : quotient.coefficients) real = real && coefficient.im.hi == 0.0;
  const double power_ulps = 8.0 + quotient.alpha * nodes.largest_log,
               weight_ulps = 16.0 + 0.25 * static_cast<double>(nodes.size()) +
                             std::abs(quotient.exponent.hi) * nodes.largest_log;
  for (std::size_t i = 0; i < nodes.size(); i += hn::Lanes(tag)) {
    const ComplexVector log{load(nodes.log_re, i), load(nodes.log_im, i)};
    const ComplexVector x = exponential(log * constant(quotient.alpha));
    const ComplexVector weight = ComplexVector{load(nodes.weight_re, i), load(nodes.weight_im, i)} *
                                 exponential(log * constant(quotient.exponent));
    sums.add(weight, x, quotient, power_ulps, weight_ulps, 1.0);
    if (!real) sums.add(weight, x, quotient, power_ulps, weight_ulps, -1.0);
  }
  constexpr double most_loss = 0.25 / unit_roundoff;
  const bool hopeless = !(hn::GetLane(hn::MaxOfLanes(tag, sums.largest_loss)) < most_loss);
  std::array<QuotientSum, max_degree> results{};
  for (std::size_t j = 0; j < quotient.coefficients.size(); ++j) {
    results[j] = {
        {sum_of_lanes(sums.values[j].re), sum_of_lanes(sums.values[j].im)},
        hopeless ? std::numeric_limits<double>::infinity() : unit_roundoff * sum_of_lanes(sums.errors[j])};
    if (real) double_real_part(results[j]);
  }
  return results;
}

HWY_INLINE DoubleDouble first_lane(const Real& x) { return {hn::GetLane(x.hi), hn::GetLane(x.lo)}; }

// One Newton step for e^w = z, with the remainder, which is below 2^-50, in double-double.
ComplexDoubleDouble logarithm_kernel(std::complex<double> z) {
  const double re = std::log(std::abs(z)), im = std::arg(z);
  const ComplexVector there{constant(DoubleDouble{z.real(), 0.0}), constant(DoubleDouble{z.imag(), 0.0})};
  const ComplexVector back =
      exponential(ComplexVector{constant(DoubleDouble{-re, 0.0}), constant(DoubleDouble{-im, 0.0})});
  const ComplexVector quotient = there * back;
  const Real rest = quotient.re + constant(-1.0);
  const ComplexVector log{rest + constant(DoubleDouble{re, 0.0}), quotient.im + constant(im)};
  return {first_lane(log.re), first_lane(log.im)};
}

HWY_INLINE ComplexVector inverse(const ComplexVector& z) {
  const Real square = reciprocal(sum_of_products(z.re, z.re, z.im, z.im));
  return {z.re * square, -z.im * square};
}

HWY_INLINE void store(Residues& out, std::size_t i, const ComplexVector& value, Vector exponent,
                      Vector error) {
  std::array<std::array<double, double_double_lanes>, 6> columns{};
  const std::array<Vector, 6> rows{value.re.hi, value.re.lo, value.im.hi, value.im.lo, exponent, error};
  for (std::size_t c = 0; c < rows.size(); ++c) hn::StoreU(rows[c], tag, columns[c].data());
  for (std::size_t lane = 0; lane < hn::Lanes(tag); ++lane) {
    out[i + lane] = {{{columns[0][lane], columns[1][lane]}, {columns[2][lane], columns[3][lane]}},
                     columns[4][lane],
                     columns[5][lane]};
  }
}

// The factor m of a pole (contour.hpp), and d log m / d log s*.
struct PoleFactor {
  ComplexVector factor;
  Vector sensitivity;
};

// m = 1 / (1 -+ e^(-omega (root - 1)))
HWY_INLINE PoleFactor factor_of_pole(const PoleArguments& poles, const ComplexVector& log) {
  const ComplexVector half{log.re * constant(0.5) - constant(poles.half_log_mu), log.im * constant(0.5)};
  const ComplexVector root = exponential(half);
  const Vector omega = constant(poles.omega), least = constant(-1000.0);
  const ComplexVector phase{(root.re + constant(-1.0)) * hn::Neg(omega), root.im * hn::Neg(omega)};
  const Exponential size = exponential(phase.re);
  const ComplexVector wave =
      exp_i(phase.im) * scale(size.mantissa, power_of_two(hn::Max(size.exponent, least)));
  const Vector sign = constant(poles.half_step_shift ? 1.0 : -1.0);
  const ComplexVector factor = inverse(ComplexVector{wave.re * sign + constant(1.0), wave.im * sign});
  const Vector phase_error = hn::Mul(omega, hn::Add(norm1(root), constant(1.0)));
  return {factor, hn::Mul(phase_error, hn::Mul(norm1(wave), norm1(factor)))};
}

Residues residues_kernel(const PoleArguments& poles, const std::array<double, double_double_lanes>& sheets,
                         std::size_t count) {
  Residues residues{};
  const Real per_alpha = reciprocal(constant(DoubleDouble{poles.alpha, 0.0})), power = constant(poles.power);
  const ComplexVector one{constant(DoubleDouble{1.0, 0.0}), constant(DoubleDouble{0.0, 0.0})};
  for (std::size_t i = 0; i < count; i += hn::Lanes(tag)) {
    const Real turns = constant(pi_double_double) * hn::Mul(constant(2.0), hn::LoadU(tag, sheets.data() + i));
    const ComplexVector log{constant(poles.log_z.re) * per_alpha,
                            (constant(poles.log_z.im) + turns) * per_alpha};
    const ComplexVector pole = exponential(log);
    const PoleFactor seen = poles.omega == 0.0 ? PoleFactor{one, hn::Zero(tag)} : factor_of_pole(poles, log);
    const ComplexVector exponent = pole + log * power;
    const Exponential growth = exponential(exponent.re);
    const ComplexVector residue = exp_i(exponent.im) * (growth.mantissa * per_alpha);
    // The error of log z is a few 2^-104, the error of log s* 1/alpha times as much.
    const Vector log_error = hn::Add(norm1(log), constant(4.0 + 2.0 / poles.alpha));
    const Vector pole_error = hn::Add(norm1(pole), constant(1.0 + std::abs(poles.power.hi)));
    const Vector error = hn::MulAdd(hn::Add(pole_error, seen.sensitivity), log_error, constant(8.0));
    store(residues, i, residue * seen.factor, growth.exponent, hn::Mul(constant(8.0 * unit_roundoff), error));
  }
  return residues;
}

}  // namespace fde::reference::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fde::reference {

HWY_EXPORT(sum_kernel);
HWY_EXPORT(power_kernel);
HWY_EXPORT(polynomial_kernel);
HWY_EXPORT(logarithm_kernel);
HWY_EXPORT(residues_kernel);

ContourNodes::ContourNodes(const Contour<BigReal>& contour, double offset) {
  const auto put = [](Column& column, const BigReal& x) {
    const DoubleDouble parts = to_double_double(x);
    column.hi.push_back(parts.hi);
    column.lo.push_back(parts.lo);
  };
  const BigReal share = exp(BigReal(offset));
  for (const auto& node : contour.nodes()) {
    const BigComplex log_s = offset == 0.0 ? node.log_s : log(BigComplex(node.s + offset)),
                     weight = node.weight * share;
    put(log_re, real_part<BigReal>(log_s));
    put(log_im, imag_part<BigReal>(log_s));
    put(weight_re, real_part<BigReal>(weight));
    put(weight_im, imag_part<BigReal>(weight));
    largest_log = std::max(largest_log, norm1(log_s).convert_to<double>());
  }
  const std::size_t whole = (size() + double_double_lanes - 1) / double_double_lanes * double_double_lanes;
  for (Column* column : {&log_re, &log_im}) {
    column->hi.resize(whole, column->hi.back());
    column->lo.resize(whole, column->lo.back());
  }
  for (Column* column : {&weight_re, &weight_im}) {
    column->hi.resize(whole, 0.0);
    column->lo.resize(whole, 0.0);
  }
}

QuotientSum sum_over_nodes(const ContourNodes& nodes, const PowerQuotient& quotient) {
  return HWY_DYNAMIC_DISPATCH(sum_kernel)(nodes, quotient);
}

QuotientSum sum_over_nodes(const ContourNodes& nodes, const BinomialPower& power) {
  return HWY_DYNAMIC_DISPATCH(power_kernel)(nodes, power);
}

std::array<QuotientSum, max_degree> sum_over_nodes(const ContourNodes& nodes,
                                                   const PolynomialQuotient& quotient) {
  return HWY_DYNAMIC_DISPATCH(polynomial_kernel)(nodes, quotient);
}

ComplexDoubleDouble complex_logarithm(std::complex<double> z) {
  return HWY_DYNAMIC_DISPATCH(logarithm_kernel)(z);
}

Residues residues_at(const PoleArguments& poles, const std::array<double, double_double_lanes>& sheets,
                     std::size_t count) {
  return HWY_DYNAMIC_DISPATCH(residues_kernel)(poles, sheets, count);
}

}  // namespace fde::reference
#endif
