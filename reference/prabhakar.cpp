#include "prabhakar.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "prabhakar_transform.hpp"

namespace fde {
namespace {

using Arguments = PrabhakarArguments<BigReal>;

// A function of the family with a name for messages, and the factor k! of derivatives.
struct Request {
  std::string name;
  ReadPrabhakar read;
  int factorial = 0;
};

void require(bool holds, const std::string& name, const std::string& message) {
  if (!holds) throw std::invalid_argument(name + ": " + message);
}

template <class Number>
void require_order(const std::string& name, const Number& alpha) {
  require(alpha > 0 && alpha <= 5, name,
          fmt::format("alpha = {} has to be in (0, 5]", static_cast<double>(alpha)));
}

template <class Number>
void require_parameter(const std::string& name, const char* argument, const Number& value) {
  constexpr int largest = 10000;
  require(
      value >= -largest && value <= largest, name,
      fmt::format("{} = {} has to be in [-{}, {}]", argument, static_cast<double>(value), largest, largest));
}

void require_derivative(int k) {
  require(k >= 0 && k <= most_derivatives, "mittag_leffler_derivative",
          fmt::format("k = {} has to be in [0, {}]", k, most_derivatives));
}

BigReal argument(const std::string& name, const std::string& text) {
  try {
    return parse<BigReal>(text);
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format("prabhakar: {}: {}", name, error.what()));
  }
}

bool ends_or_is_small(const Arguments& x) {
  return (x.gamma <= 0 && is_whole(x.gamma)) ||
         size_of(x.z) <= 0.4 * pow(std::max(BigReal(1), x.beta), x.alpha);
}

// Digits until the terms of the series, which may cancel, leave enough of the value.
Bounded<BigReal> sum_series(const Request& request, int wanted) {
  const int most = 4 * wanted + 1000;
  for (int digits = wanted + 10;;) {
    const Precision precision(digits);
    const Sum<BigReal> sum = prabhakar_series(request.read());
    const bool enough = sum.error <= size_of(sum.value) * pow(BigReal(10), -wanted);
    if (enough || digits >= most) return {sum.value, sum.error};
    digits = std::min(2 * digits, most);
  }
}

Bounded<BigReal> evaluate(const Request& request, int wanted) {
  const auto value = [&] {
    try {
      if (ends_or_is_small(request.read())) return sum_series(request, wanted);
      return invert(prabhakar_transform(request.read), wanted).front();
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(fmt::format("{}: {}", request.name, error.what()));
    }
  }();
  const BigReal factorial = gamma(BigReal(request.factorial + 1));
  return {BigComplex(value.value * factorial),
          BigReal((value.bound + 8 * epsilon<BigReal>() * size_of(value.value)) * factorial)};
}

MittagLefflerValue in_double(const Request& request) {
  const Precision precision(2 * double_digits + 10);
  const auto [value, bound] = to_double(evaluate(request, double_digits));
  if (!std::isfinite(bound)) throw std::runtime_error(request.name + " is beyond double");
  const double re = value.real() + 0.0, im = value.imag() + 0.0;  // no -0
  return {request.read().real() ? std::complex(re) : std::complex(re, im), bound};
}

DecimalComplex in_digits(const Request& request, int digits) {
  const Precision precision(digits + 20);
  const Arguments x = request.read();
  require_order(request.name, x.alpha);
  require_parameter(request.name, "beta", x.beta);
  require_parameter(request.name, "gamma", x.gamma);
  const auto [value, bound] = evaluate(request, digits);
  const DecimalText re = write_decimal(real_part<BigReal>(value), bound, digits);
  if (request.read().real()) return {re.value, "0", write_bound(re.bound)};
  const DecimalText im = write_decimal(imag_part<BigReal>(value), bound, digits);
  return {re.value, im.value, write_bound(BigReal(re.bound + im.bound))};
}

void require_finite(const std::string& name, double alpha, double beta, double gamma,
                    std::complex<double> z) {
  require_order(name, alpha);
  require_parameter(name, "beta", beta);
  require_parameter(name, "gamma", gamma);
  require(std::isfinite(z.real()) && std::isfinite(z.imag()), name,
          fmt::format("z = {} {:+} i has to be finite", z.real(), z.imag()));
}

}  // namespace

MittagLefflerValue prabhakar(double alpha, double beta, double gamma, std::complex<double> z) {
  require_finite("prabhakar", alpha, beta, gamma, z);
  return in_double(
      {fmt::format("prabhakar({}, {}, {}, z = {} {:+} i)", alpha, beta, gamma, z.real(), z.imag()), [=] {
         return Arguments{BigReal(alpha), BigReal(beta), BigReal(gamma), BigComplex(z.real(), z.imag())};
       }});
}

MittagLefflerValue mittag_leffler_derivative(int k, double alpha, double beta, std::complex<double> z) {
  require_derivative(k);
  require_finite("mittag_leffler_derivative", alpha, beta, 1.0, z);
  return in_double(
      {fmt::format("mittag_leffler_derivative({}, {}, {}, z = {} {:+} i)", k, alpha, beta, z.real(),
                   z.imag()),
       [=] {
         const BigReal order(alpha);
         return Arguments{order, BigReal(beta + k * order), BigReal(k + 1), BigComplex(z.real(), z.imag())};
       },
       k});
}

DecimalComplex prabhakar(const std::string& alpha, const std::string& beta, const std::string& gamma,
                         const std::string& re, const std::string& im, int digits) {
  require(digits >= 1, "prabhakar", fmt::format("digits = {} has to be positive", digits));
  return in_digits({fmt::format("prabhakar({}, {}, {}, z = {} + {} i)", alpha, beta, gamma, re, im),
                    [=] {
                      return Arguments{argument("alpha", alpha), argument("beta", beta),
                                       argument("gamma", gamma),
                                       BigComplex(argument("re z", re), argument("im z", im))};
                    }},
                   digits);
}

DecimalComplex mittag_leffler_derivative(int k, const std::string& alpha, const std::string& beta,
                                         const std::string& re, const std::string& im, int digits) {
  require_derivative(k);
  require(digits >= 1, "mittag_leffler_derivative", fmt::format("digits = {} has to be positive", digits));
  return in_digits(
      {fmt::format("mittag_leffler_derivative({}, {}, {}, z = {} + {} i)", k, alpha, beta, re, im),
       [=] {
         const BigReal order = argument("alpha", alpha);
         return Arguments{order, BigReal(argument("beta", beta) + k * order), BigReal(k + 1),
                          BigComplex(argument("re z", re), argument("im z", im))};
       },
       k},
      digits);
}

}  // namespace fde
