#include "mittag_leffler.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "mittag_leffler_transform.hpp"
#include "refine.hpp"

namespace fde {
namespace {

template <class Real>
using Arguments = MittagLefflerArguments<Real>;

// sum_k z^k / Gamma(alpha k + beta), for z so small that its terms fall off from the first ones on.
Sum<long double> power_series(const Arguments<long double>& x) {
  Sum<long double> sum;
  Complex<long double> power(1.0L);
  for (int k = 0; k < 200; ++k) {
    const long double argument = x.alpha * static_cast<long double>(k) + x.beta;
    const Complex<long double> term = power * reciprocal_gamma(argument);
    const long double ulps = 8.0L + std::abs(argument) * (1.0L + std::log1p(std::abs(argument)));
    sum.add(term, ulps * epsilon<long double>());
    if (argument > 2.0L && size_of(term) <= 0.01L * epsilon<long double>() * size_of(sum.value)) break;
    power *= x.z;
  }
  return sum;
}

// Ratios of terms stay below about 0.4; a very negative beta has large terms first.
bool series_is_best(const Arguments<long double>& x) {
  if (x.beta < -5.0L) return x.z == 0.0L;
  return size_of(x.z) <= 0.4L * std::pow(std::max(1.0L, x.beta), x.alpha);
}

// |F| on |s| = r, poles aside, after peeling.
long double transform_size(const Arguments<long double>& x, int peeled, long double r) {
  const long double size = std::abs(x.z), r_alpha = std::pow(r, x.alpha);
  return std::pow(r_alpha / size, static_cast<long double>(peeled)) * r_alpha * std::pow(r, -x.beta) /
         std::max(r_alpha, size);
}

Sum<long double> in_long_double(const Arguments<long double>& x) {
  if (x.beta == 0.0L) {  // E_{alpha,0}(z) = z E_{alpha,alpha}(z), where less cancels
    Sum<long double> sum = in_long_double({x.alpha, x.alpha, x.z});
    sum.value *= x.z;
    sum.error *= size_of(x.z);
    return sum;
  }
  if (series_is_best(x)) return power_series(x);
  if (x.cut_free()) return sum_of_residues(x);
  const auto poles = poles_of(x);
  const auto& contour = contour_away_from(poles);
  // How large |z| is against |s^alpha| where e^s is large.
  const long double head = std::abs(x.z) * std::pow(4.0L, -x.alpha);
  const int peeled = head > 8.0L ? 2 : head > 1.0L ? 1 : 0;
  Sum<long double> sum = on_contour(x, contour, poles, peeled);
  sum.error += contour.discretisation([&](long double r) { return transform_size(x, peeled, r); });
  return sum;
}

Sum<BigReal> value_at_zero(const Arguments<BigReal>& x) {
  Sum<BigReal> sum;
  sum.add(BigComplex(reciprocal_gamma(x.beta)), (8 + 4 * abs(x.beta)) * epsilon<BigReal>());
  return sum;
}

Sum<BigReal> in_digits(const Arguments<BigReal>& x, int digits) {
  if (x.z == 0) return value_at_zero(x);
  if (x.cut_free()) return sum_of_residues(x);
  return on_contour(x, contour_for(digits), poles_of(x), 0);
}

// Digits by which the phase of e^s* exceeds one turn, where that can matter for a double.
int phase_digits(const Arguments<BigReal>& x) {
  constexpr double most = 400.0;
  if (x.z == 0) return 0;
  const BigReal digits = log(BigReal(abs(x.z))) / (x.alpha * std::numbers::ln10);
  return static_cast<int>(std::clamp(digits.convert_to<double>(), 0.0, most)) + 1;
}

MittagLefflerValue upper_half_plane(double alpha, double beta, std::complex<double> z) {
  const Arguments<long double> x{alpha, beta, {z.real(), z.imag()}};
  const Sum<long double> quick = in_long_double(x);
  if (quick.infinite ||
      (std::isfinite(quick.error) && quick.error <= double_tolerance * std::abs(quick.value))) {
    const auto [value, bound] = to_double(quick.value, quick.error);
    return {x.real() ? std::complex(value.real()) : value, bound};
  }
  const auto exactly = [&] {
    return Arguments<BigReal>{BigReal(alpha), BigReal(beta), BigComplex(z.real(), z.imag())};
  };
  const Precision precision(contour_precision(double_digits));
  const auto careful = refine(double_digits, phase_digits(exactly()),
                              [&](int digits) { return std::vector{in_digits(exactly(), digits)}; });
  const auto [value, bound] = to_double(careful.front());
  return {x.real() ? std::complex(value.real()) : value, bound};
}

void require(bool holds, const char* message) {
  if (!holds) throw std::invalid_argument(fmt::format("mittag_leffler: {}", message));
}

template <class Real>
void require_order(const Real& alpha) {
  require(alpha > 0 && alpha <= 5, "alpha has to be in (0, 5]");
}

BigReal argument(const std::string& name, const std::string& text) {
  try {
    return parse<BigReal>(text);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("mittag_leffler: {}: {}", name, error.what()));
  }
}

}  // namespace

MittagLefflerValue mittag_leffler(double alpha, double beta, std::complex<double> z) {
  require_order(alpha);
  require(std::isfinite(beta), "beta has to be finite");
  require(std::isfinite(z.real()) && std::isfinite(z.imag()), "z has to be finite");
  if (z.imag() >= 0.0) return upper_half_plane(alpha, beta, std::complex(z.real(), std::abs(z.imag())));
  const MittagLefflerValue mirrored = upper_half_plane(alpha, beta, std::conj(z));
  return {std::conj(mirrored.value), mirrored.bound};
}

double mittag_leffler(double alpha, double beta, double z) {
  return mittag_leffler(alpha, beta, std::complex<double>(z)).value.real();
}

DecimalComplex mittag_leffler(const std::string& alpha, const std::string& beta, const std::string& re,
                              const std::string& im, int digits) {
  require(digits >= 1, "digits has to be positive");
  const auto read = [&] {
    return Arguments<BigReal>{argument("alpha", alpha), argument("beta", beta),
                              BigComplex(argument("re z", re), argument("im z", im))};
  };
  const Precision precision(contour_precision(digits));
  require_order(read().alpha);
  const auto [value, bound] = refine(digits, phase_digits(read()), [&](int working) {
                                return std::vector{in_digits(read(), working)};
                              }).front();
  const DecimalText re_text = write_decimal(real_part<BigReal>(value), bound, digits);
  if (read().real()) return {re_text.value, "0", write_bound(re_text.bound)};
  const DecimalText im_text = write_decimal(imag_part<BigReal>(value), bound, digits);
  return {re_text.value, im_text.value, write_bound(BigReal(re_text.bound + im_text.bound))};
}

}  // namespace fde
