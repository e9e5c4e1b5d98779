// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/prabhakar_and_matrix/prabhakar.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "fdebench/reference/special_functions/mittag_leffler/decimal_arguments.hpp"
#include "fdebench/reference/special_functions/numbers/bounded.hpp"
#include "fdebench/reference/special_functions/prabhakar_and_matrix/prabhakar_quick.hpp"
#include "fdebench/reference/special_functions/prabhakar_and_matrix/prabhakar_transform.hpp"

namespace fde::reference {
namespace {

// An evaluation: name for messages, arguments, decimal places of the parameters, and k of the factor k! of
// derivatives.
struct Request {
  std::string name;
  ReadPrabhakar read;
  int places;
  int factorial = 0;
};

void require_derivative(int k) {
  if (k >= 0 && k <= max_derivative) return;
  throw std::invalid_argument(
      fmt::format("mittag_leffler_derivative: k = {} has to be in [0, {}]", k, max_derivative));
}

bool series_applies(const PrabhakarArguments& x) {
  return (x.gamma <= 0 && is_integer(x.gamma)) ||
         norm1(x.z) <= 0.4 * pow(std::max(BigReal(1), x.beta), x.alpha);
}

// The terms of the series may cancel: the working digits are doubled until the value is accurate. If the
// terms cancel completely even with max_working_digits(), the value counts as zero.
Bounded<BigReal> sum_series(const Request& request, int wanted) {
  const DigitSearchOptions search{.target_digits = wanted,
                                  .guard = 10,
                                  .next_digits = [](int digits, int /*missing*/) { return 2 * digits; }};
  const DigitSearchResult raised = increase_digits(search, [&](int digits) {
    const Precision precision(digits + request.places);
    const BoundedSum<BigReal> sum = prabhakar_series(request.read());
    const bool last = digits == max_working_digits(wanted);
    return std::vector<WorkingEstimate>{
        {.value_and_bound = {sum.value, sum.error}, .scale = last ? sum.scale : BigReal(0)}};
  });
  if (raised.largest_missed_bound) throw insufficient_digits(raised);
  return raised.values.front();
}

Bounded<BigReal> evaluate(const Request& request, int wanted) {
  const auto value = [&] {
    try {
      if (series_applies(request.read())) return sum_series(request, wanted);
      return invert(prabhakar_transform(request.read), wanted).front();
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(fmt::format("{}: {}", request.name, error.what()));
    }
  }();
  const BigReal factorial = gamma(BigReal(request.factorial + 1));
  return {BigComplex(value.value * factorial),
          BigReal((value.bound + 8 * epsilon<BigReal>() * norm1(value.value)) * factorial)};
}

MittagLefflerValue evaluate_in_double(const Request& request) {
  const Precision precision(2 * double_digits + 10);
  const auto [value, bound] = to_double(evaluate(request, double_digits));
  if (!std::isfinite(bound)) throw std::runtime_error(request.name + " is beyond double");
  const double re = value.real() + 0.0, im = value.imag() + 0.0;  // no -0
  return {request.read().real() ? std::complex(re) : std::complex(re, im), bound};
}

// k! times a quick evaluation for Im z >= 0, or its conjugate for Im z < 0; nullopt where it gives none.
template <class Quick>
std::optional<MittagLefflerValue> evaluate_quick(const Quick& quick, std::complex<double> z, int k) {
  constexpr int most_exact = 25;  // largest k for which k! is exact in long double
  if (k > most_exact) return std::nullopt;
  const bool mirrored = z.imag() < 0.0;
  const auto known = quick(mirrored ? std::conj(z) : std::complex(z.real(), std::abs(z.imag())));
  if (!known) return std::nullopt;
  long double times = 1.0L;
  for (int m = 2; m <= k; ++m) times *= static_cast<long double>(m);
  const long double rounding = few_ulps * norm1(known->value);
  const auto [value, bound] = to_double(times * known->value, times * (known->error + rounding));
  if (!std::isfinite(bound)) return std::nullopt;
  if (z.imag() == 0.0) return MittagLefflerValue{std::complex(value.real() + 0.0), bound};
  return MittagLefflerValue{mirrored ? std::conj(value) : value, bound};
}

DecimalComplex in_digits(const std::string& function, const Request& request, int digits) {
  require_digits(function, digits);
  const Precision precision(digits + 20 + request.places);
  const PrabhakarArguments x = request.read();
  require_order(function, x.alpha);
  require_parameter(function, "beta", x.beta);
  require_parameter(function, "gamma", x.gamma);
  return to_decimal_complex(evaluate(request, digits), x.real(), digits);
}

void require_arguments(const std::string& name, double alpha, double beta, double gamma,
                       std::complex<double> z) {
  require_order(name, alpha);
  require_parameter(name, "beta", beta);
  require_parameter(name, "gamma", gamma);
  require_finite(name, z);
}

}  // namespace

MittagLefflerValue prabhakar(double alpha, double beta, double gamma, std::complex<double> z) {
  require_arguments("prabhakar", alpha, beta, gamma, z);
  const auto quick = [&](std::complex<double> upper) {
    return prabhakar_quick(alpha, {beta, 0.0}, gamma, upper);
  };
  if (const auto value = evaluate_quick(quick, z, 0)) return *value;
  return evaluate_in_double(
      {fmt::format("prabhakar({}, {}, {}, z = {} {:+} i)", alpha, beta, gamma, z.real(), z.imag()),
       [=] {
         return PrabhakarArguments{BigReal(alpha), BigReal(beta), BigReal(gamma),
                                   BigComplex(z.real(), z.imag())};
       },
       std::max(decimal_places(alpha, beta), decimal_places(gamma, gamma))});
}

MittagLefflerValue mittag_leffler_derivative(int k, double alpha, double beta, std::complex<double> z) {
  require_derivative(k);
  require_arguments("mittag_leffler_derivative", alpha, beta, 1.0, z);
  const auto quick = [&](std::complex<double> upper) {
    return prabhakar_quick(alpha, DoubleDouble{beta, 0.0} + exact_product(k, alpha), k + 1.0, upper);
  };
  if (const auto value = evaluate_quick(quick, z, k)) return *value;
  return evaluate_in_double({fmt::format("mittag_leffler_derivative({}, {}, {}, z = {} {:+} i)", k, alpha,
                                         beta, z.real(), z.imag()),
                             [=] {
                               const BigReal order(alpha);
                               return PrabhakarArguments{order, BigReal(beta + k * order), BigReal(k + 1),
                                                         BigComplex(z.real(), z.imag())};
                             },
                             decimal_places(alpha, beta), k});
}

DecimalComplex prabhakar(const std::string& alpha, const std::string& beta, const std::string& gamma,
                         const std::string& re, const std::string& im, int digits) {
  const std::string function = "prabhakar";
  return in_digits(function,
                   {fmt::format("prabhakar({}, {}, {}, z = {} + {} i)", alpha, beta, gamma, re, im),
                    [=] {
                      return PrabhakarArguments{
                          parse_argument(function, "alpha", alpha), parse_argument(function, "beta", beta),
                          parse_argument(function, "gamma", gamma), parse_complex(function, re, im)};
                    },
                    std::max({decimal_places(alpha), decimal_places(beta), decimal_places(gamma)})},
                   digits);
}

DecimalComplex mittag_leffler_derivative(int k, const std::string& alpha, const std::string& beta,
                                         const std::string& re, const std::string& im, int digits) {
  require_derivative(k);
  const std::string function = "mittag_leffler_derivative";
  return in_digits(
      function,
      {fmt::format("mittag_leffler_derivative({}, {}, {}, z = {} + {} i)", k, alpha, beta, re, im),
       [=] {
         const BigReal order = parse_argument(function, "alpha", alpha);
         return PrabhakarArguments{order, BigReal(parse_argument(function, "beta", beta) + k * order),
                                   BigReal(k + 1), parse_complex(function, re, im)};
       },
       std::max(decimal_places(alpha), decimal_places(beta)), k},
      digits);
}

}  // namespace fde::reference
