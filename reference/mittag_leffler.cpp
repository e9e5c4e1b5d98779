#include "mittag_leffler.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "contour.hpp"
#include "mittag_leffler_digits.hpp"
#include "mittag_leffler_quick.hpp"

namespace fde {
namespace {

using Arguments = MittagLefflerArguments;

constexpr int most_beta = 10000;

// |z E'| from below: alpha z E'_{alpha,beta}(z) = E_{alpha,beta-1}(z) - (beta-1) E_{alpha,beta}(z).
long double least_slope(double alpha, double beta, std::complex<double> z, const QuickValue& value) {
  const auto before = mittag_leffler_quick(alpha, exact_sum(beta, -1.0), z);
  if (!before) return 0.0L;
  const long double factor = static_cast<long double>(beta) - 1.0L;
  const long double error = before->error + std::abs(factor) * value.error;
  return (std::abs(before->value - factor * value.value) - error) / alpha;
}

bool is_good(double alpha, double beta, std::complex<double> z, const QuickValue& value) {
  return value.error <= quick_tolerance * std::abs(value.value) ||
         value.error <= quick_tolerance * least_slope(alpha, beta, z, value);
}

// Decimal digits after the point with which alpha and beta, and so their sums, are exact.
int places_of(double alpha, double beta) {
  constexpr int mantissa = std::numeric_limits<double>::digits;
  const int lowest = std::min(std::ilogb(alpha), beta == 0.0 ? 0 : std::ilogb(beta)) - mantissa;
  return static_cast<int>(std::ceil(std::max(0, -lowest) * std::numbers::ln2 / std::numbers::ln10));
}

MittagLefflerValue upper_half_plane(double alpha, double beta, std::complex<double> z) {
  const bool real = z.imag() == 0.0;
  const auto quick = mittag_leffler_quick(alpha, {beta, 0.0}, z);
  if (quick && is_good(alpha, beta, z, *quick)) {
    const auto [value, bound] = to_double(quick->value, quick->error);
    return {real ? std::complex(value.real()) : value, bound};
  }
  const Precision precision(contour_precision(double_digits));
  const auto read = [&] { return Arguments{BigReal(alpha), BigReal(beta), BigComplex(z.real(), z.imag())}; };
  const auto [value, bound] = to_double(mittag_leffler_to(double_digits, places_of(alpha, beta), read));
  return {real ? std::complex(value.real()) : value, bound};
}

void require(bool holds, const char* message) {
  if (!holds) throw std::invalid_argument(fmt::format("mittag_leffler: {}", message));
}

template <class Real>
void require_order(const Real& alpha) {
  require(alpha > 0 && alpha <= 5, "alpha has to be in (0, 5]");
}

template <class Real>
void require_beta(const Real& beta) {
  require(beta >= -most_beta && beta <= most_beta, "beta has to be in [-10000, 10000]");
}

BigReal argument(const std::string& name, const std::string& text) {
  try {
    return parse<BigReal>(text);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("mittag_leffler: {}: {}", name, error.what()));
  }
}

// Of a decimal text after its point: "1.25e-3" has 5.
int decimal_places(const std::string& text) {
  const auto e = std::min(text.find_first_of("eE"), text.size()), point = std::min(text.find('.'), e);
  const long written = e == point ? 0 : static_cast<long>(e - point) - 1;
  const long exponent = e == text.size() ? 0 : std::strtol(text.c_str() + e + 1, nullptr, 10);
  return static_cast<int>(std::clamp(written - exponent, 0L, 100000L));
}

}  // namespace

MittagLefflerValue mittag_leffler(double alpha, double beta, std::complex<double> z) {
  require_order(alpha);
  require_beta(beta);
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
    return Arguments{argument("alpha", alpha), argument("beta", beta),
                     BigComplex(argument("re z", re), argument("im z", im))};
  };
  const Precision precision(contour_precision(digits));
  require_order(read().alpha);
  require_beta(read().beta);
  const auto [value, bound] =
      mittag_leffler_to(digits, std::max(decimal_places(alpha), decimal_places(beta)), read);
  const DecimalText re_text = write_decimal(real_part<BigReal>(value), bound, digits);
  if (read().real()) return {re_text.value, "0", write_bound(re_text.bound)};
  const DecimalText im_text = write_decimal(imag_part<BigReal>(value), bound, digits);
  return {re_text.value, im_text.value, write_bound(BigReal(re_text.bound + im_text.bound))};
}

}  // namespace fde
