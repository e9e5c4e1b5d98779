#include "refine.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "contour.hpp"

namespace fde {
namespace {

constexpr int guard_digits = 8;
constexpr int zero_digits = 40;

// At so many digits the bound says what there is.
int most_digits(int wanted_digits) { return 4 * wanted_digits + 1000; }

std::vector<Sum<BigReal>> evaluate_at(const EvaluateAt& evaluate, int digits, int extra) {
  const Precision precision(contour_precision(digits) + extra);
  return evaluate(digits);
}

// How many decimal digits the bound is above the target; not positive where it is met.
int missing_digits(const Bounded<BigReal>& x, const BigReal& scale, int wanted, int digits) {
  if (!isfinite(x.bound)) return digits;  // a difference came out as 0 and was divided by
  if (x.bound == 0) return 0;
  const BigReal size = std::max(size_of(x.value), BigReal(scale * pow(BigReal(10), -zero_digits)));
  if (size == 0) return digits;
  return static_cast<int>(ceil(log10(BigReal(x.bound / size)))) + wanted;
}

// mpfr's own conversion: Boost takes "no digit after the point" for "all digits".
std::string print(const char* format, int decimals, const BigReal& x) {
  const int length = mpfr_snprintf(nullptr, 0, format, decimals, x.backend().data());
  std::string text(static_cast<std::size_t>(length) + 1, '\0');  // and the 0 that ends it
  mpfr_snprintf(text.data(), text.size(), format, decimals, x.backend().data());
  text.pop_back();
  return text;
}

std::string scientific(const BigReal& x, int digits) { return print("%.*Re", digits - 1, x); }

// A number of significant digits, with an exponent only where the number would be hard to read without.
std::string in_decimal(const BigReal& x, int digits) {
  constexpr int most_zeros = 5;
  const std::string text = scientific(x, digits);
  const auto exponent = std::stoll(text.substr(text.find('e') + 1));
  return exponent < -most_zeros || exponent >= digits
             ? text
             : print("%.*Rf", digits - 1 - static_cast<int>(exponent), x);
}

// A bound that was rounded to nearest, made one again.
double upwards(double bound) { return std::nextafter(bound, std::numeric_limits<double>::infinity()); }

}  // namespace

std::vector<Bounded<BigReal>> refine(int wanted_digits, int extra, const EvaluateAt& evaluate) {
  const int most = most_digits(wanted_digits);
  for (int digits = wanted_digits + guard_digits;;) {
    const auto coarse = evaluate_at(evaluate, digits, extra);
    const auto fine = evaluate_at(evaluate, digits + std::max(10, digits / 16), extra);
    std::vector<Bounded<BigReal>> values;
    int missing = 0;
    for (std::size_t i = 0; i < fine.size(); ++i) {
      const BigComplex difference = fine[i].value - coarse[i].value;
      values.push_back({fine[i].value, BigReal(4 * size_of(difference) + fine[i].error)});
      if (fine[i].infinite) continue;
      missing = std::max(missing, missing_digits(values.back(), fine[i].scale, wanted_digits, digits));
    }
    if (missing == 0 || digits >= most) return values;
    digits = std::min(digits + missing + 2, most);
  }
}

Bounded<BigReal> raise_digits(int wanted_digits, int extra,
                              const std::function<Sum<BigReal>(int digits)>& evaluate) {
  const int most = most_digits(wanted_digits);
  for (int digits = wanted_digits + guard_digits;;) {
    const Precision precision(contour_precision(digits) + extra);
    const Sum<BigReal> sum = evaluate(digits);
    Bounded<BigReal> value{sum.value, sum.error};
    const int missing = sum.infinite ? 0 : missing_digits(value, BigReal(0), wanted_digits, digits);
    if (missing <= 0) return value;
    if (digits >= most) throw std::runtime_error(fmt::format("no accurate value within {} digits", most));
    digits = std::min(digits + missing + 2, most);
  }
}

std::string write_bound(const BigReal& bound) {
  if (!isfinite(bound)) return "inf";
  return bound == 0 ? "0"
                    : scientific(BigReal(bound * 1.06), 2);  // two digits are then never below the bound
}

DecimalText write_decimal(const BigReal& value, const BigReal& bound, int digits) {
  if (!isfinite(value)) return {value.str(), BigReal(std::numeric_limits<double>::infinity())};
  if (abs(value) <= bound) return {"0", BigReal(abs(value) + bound)};
  const auto supported = bound == 0 ? BigReal(digits) : BigReal(1 + log10(BigReal(abs(value) / bound)));
  const std::string text = in_decimal(value, supported < digits ? static_cast<int>(supported) : digits);
  return {text, BigReal(abs(BigReal(BigReal(text) - value)) + bound)};
}

DoubleBounded to_double(const Complex<long double>& value, long double error) {
  const std::complex<double> rounded(static_cast<double>(value.real()), static_cast<double>(value.imag()));
  if (!std::isfinite(rounded.real()) || !std::isfinite(rounded.imag()))
    return {rounded, std::numeric_limits<double>::infinity()};
  const Complex<long double> off(value.real() - rounded.real(), value.imag() - rounded.imag());
  return {rounded, upwards(static_cast<double>(size_of(off) + error))};
}

DoubleBounded to_double(const Bounded<BigReal>& x) {
  const auto re = real_part<BigReal>(x.value), im = imag_part<BigReal>(x.value);
  const bool nothing = size_of(x.value) <= x.bound;
  std::complex<double> rounded = 0.0;
  if (!nothing) rounded = {re.convert_to<double>(), im.convert_to<double>()};
  if (!std::isfinite(rounded.real()) || !std::isfinite(rounded.imag()))
    return {rounded, std::numeric_limits<double>::infinity()};
  const BigReal off = abs(BigReal(re - rounded.real())) + abs(BigReal(im - rounded.imag()));
  return {rounded, upwards(BigReal(off + x.bound).convert_to<double>())};
}

}  // namespace fde
