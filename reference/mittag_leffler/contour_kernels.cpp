#include "mittag_leffler/contour_kernels.hpp"

// Vectors of unknown length cannot be members.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "mittag_leffler/contour_kernels.cpp"
#include <hwy/foreach_target.h>  // includes this file once for each target
#include <hwy/highway.h>

#include "numbers/double_double-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace fde::HWY_NAMESPACE {

// Errors below are counted in this unit: sums and products are good to a quarter of it, exponentials to four.
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

// What the nodes have added up to, one sum a lane.
struct Sums {
  Pair value;
  Vector error;

  // weight / (power - z) or its conjugate; z has a real part and sign * its imaginary part.
  HWY_INLINE void add(const Pair& weight, const Pair& power, const PowerQuotient& quotient, double sign) {
    const Pair difference{power.re + constant(-quotient.scaled.real()),
                          power.im + constant(-sign * quotient.scaled.imag())};
    const Real inverse =
        reciprocal(sum_of_products(difference.re, difference.re, difference.im, difference.im));
    const Pair conjugate{difference.re, -difference.im};
    const Pair term = (weight * conjugate) * inverse;
    value.re = value.re + term.re;
    value.im = sign > 0.0 ? value.im + term.im : value.im - term.im;
    const Vector size = hn::Mul(hn::Mul(size_of(weight), size_of(difference)), inverse.hi);
    const Vector loss = hn::Mul(hn::Mul(size_of(power), size_of(difference)), inverse.hi);
    error = hn::Add(error, hn::MulAdd(size, loss, size));
  }
};

QuotientSum sum_kernel(const ContourNodes& nodes, const PowerQuotient& quotient) {
  const bool real = quotient.scaled.imag() == 0.0;
  const Vector alpha = constant(quotient.alpha), scaling = constant(quotient.scale);
  const Real exponent = constant(quotient.exponent);
  const Real zero{hn::Zero(tag), hn::Zero(tag)};
  Sums sums{{zero, zero}, hn::Zero(tag)};
  for (std::size_t i = 0; i < nodes.size(); i += hn::Lanes(tag)) {
    const Pair log{load(nodes.log_re, i), load(nodes.log_im, i)};
    const Pair unscaled = exponential(log * alpha);
    const Pair power{scale(unscaled.re, scaling), scale(unscaled.im, scaling)};
    const Pair weight =
        Pair{load(nodes.weight_re, i), load(nodes.weight_im, i)} * exponential(log * exponent);
    sums.add(weight, power, quotient, 1.0);
    if (!real) sums.add(weight, power, quotient, -1.0);
  }
  QuotientSum result{{sum_of_lanes(sums.value.re), sum_of_lanes(sums.value.im)}, sum_of_lanes(sums.error)};
  const double additions = 0.25 * static_cast<double>(nodes.size());
  const double powers = quotient.alpha + std::abs(quotient.exponent.hi);
  result.error *= unit_roundoff * (16.0 + additions + nodes.largest_log * powers);
  if (real) {
    result.value.re = {2.0 * result.value.re.hi, 2.0 * result.value.re.lo};
    result.value.im = {0.0, 0.0};
    result.error *= 2.0;
  }
  return result;
}

HWY_INLINE DoubleDouble first_lane(const Real& x) { return {hn::GetLane(x.hi), hn::GetLane(x.lo)}; }

// One Newton step for e^w = z, with the remainder in double-double: it is below 2^-50.
ComplexDoubleDouble logarithm_kernel(std::complex<double> z) {
  const double re = std::log(std::abs(z)), im = std::arg(z);
  const Pair there{constant(DoubleDouble{z.real(), 0.0}), constant(DoubleDouble{z.imag(), 0.0})};
  const Pair back = exponential(Pair{constant(DoubleDouble{-re, 0.0}), constant(DoubleDouble{-im, 0.0})});
  const Pair quotient = there * back;
  const Real rest = quotient.re + constant(-1.0);
  const Pair log{rest + constant(DoubleDouble{re, 0.0}), quotient.im + constant(im)};
  return {first_lane(log.re), first_lane(log.im)};
}

HWY_INLINE Pair inverse(const Pair& z) {
  const Real square = reciprocal(sum_of_products(z.re, z.re, z.im, z.im));
  return {z.re * square, -z.im * square};
}

HWY_INLINE void store(Residues& out, std::size_t i, const Pair& value, Vector exponent, Vector error) {
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
struct Seen {
  Pair factor;
  Vector sensitivity;
};

// m = 1 / (1 -+ e^(-omega (root - 1)))
HWY_INLINE Seen seen_from(const PoleArguments& poles, const Pair& log) {
  const Pair half{log.re * constant(0.5) - constant(poles.half_log_mu), log.im * constant(0.5)};
  const Pair root = exponential(half);
  const Vector omega = constant(poles.omega), least = constant(-1000.0);
  const Pair phase{(root.re + constant(-1.0)) * hn::Neg(omega), root.im * hn::Neg(omega)};
  const Exponential size = exponential(phase.re);
  const Pair wave = unit(phase.im) * scale(size.mantissa, power_of_two(hn::Max(size.exponent, least)));
  const Vector sign = constant(poles.half_step_shift ? 1.0 : -1.0);
  const Pair factor = inverse(Pair{wave.re * sign + constant(1.0), wave.im * sign});
  const Vector phase_error = hn::Mul(omega, hn::Add(size_of(root), constant(1.0)));
  return {factor, hn::Mul(phase_error, hn::Mul(size_of(wave), size_of(factor)))};
}

Residues residues_kernel(const PoleArguments& poles, const std::array<double, double_double_lanes>& sheets,
                         std::size_t count) {
  Residues residues{};
  const Real per_alpha = reciprocal(constant(DoubleDouble{poles.alpha, 0.0})), power = constant(poles.power);
  const Pair one{constant(DoubleDouble{1.0, 0.0}), constant(DoubleDouble{0.0, 0.0})};
  for (std::size_t i = 0; i < count; i += hn::Lanes(tag)) {
    const Real turns = constant(pi_double_double) * hn::Mul(constant(2.0), hn::LoadU(tag, sheets.data() + i));
    const Pair log{constant(poles.log_z.re) * per_alpha, (constant(poles.log_z.im) + turns) * per_alpha};
    const Pair pole = exponential(log);
    const Seen seen = poles.omega == 0.0 ? Seen{one, hn::Zero(tag)} : seen_from(poles, log);
    const Pair exponent = pole + log * power;
    const Exponential growth = exponential(exponent.re);
    const Pair residue = unit(exponent.im) * (growth.mantissa * per_alpha);
    // The logarithm of z is good to a few 2^-104, that of s* to 1/alpha times as much.
    const Vector log_error = hn::Add(size_of(log), constant(4.0 + 2.0 / poles.alpha));
    const Vector pole_error = hn::Add(size_of(pole), constant(1.0 + std::abs(poles.power.hi)));
    const Vector error = hn::MulAdd(hn::Add(pole_error, seen.sensitivity), log_error, constant(8.0));
    store(residues, i, residue * seen.factor, growth.exponent, hn::Mul(constant(8.0 * unit_roundoff), error));
  }
  return residues;
}

}  // namespace fde::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fde {

HWY_EXPORT(sum_kernel);
HWY_EXPORT(logarithm_kernel);
HWY_EXPORT(residues_kernel);

ContourNodes::ContourNodes(const Contour<BigReal>& contour) {
  const auto put = [](Column& column, const BigReal& x) {
    const DoubleDouble parts = to_double_double(x);
    column.hi.push_back(parts.hi);
    column.lo.push_back(parts.lo);
  };
  for (const auto& [s, log_s, weight] : contour.nodes()) {
    put(log_re, real_part<BigReal>(log_s));
    put(log_im, imag_part<BigReal>(log_s));
    put(weight_re, real_part<BigReal>(weight));
    put(weight_im, imag_part<BigReal>(weight));
  }
  for (const auto& node : contour.nodes())
    largest_log = std::max(largest_log, size_of(node.log_s).convert_to<double>());
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

ComplexDoubleDouble complex_logarithm(std::complex<double> z) {
  return HWY_DYNAMIC_DISPATCH(logarithm_kernel)(z);
}

Residues residues_at(const PoleArguments& poles, const std::array<double, double_double_lanes>& sheets,
                     std::size_t count) {
  return HWY_DYNAMIC_DISPATCH(residues_kernel)(poles, sheets, count);
}

}  // namespace fde
#endif
