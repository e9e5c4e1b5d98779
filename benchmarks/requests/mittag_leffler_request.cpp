// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/requests/mittag_leffler_request.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdlib>
#include <string_view>

#include "fdebench/benchmarks/references/decimal_bound.hpp"
#include "fdebench/benchmarks/requests/failure.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/decimal_arguments.hpp"
#include "fdebench/reference/special_functions/prabhakar_and_matrix/mittag_leffler_matrix.hpp"
#include "fdebench/reference/special_functions/prabhakar_and_matrix/prabhakar.hpp"

namespace fde::bench {
namespace {

using reference::DecimalComplex, reference::MittagLefflerValue, reference::exact_double;
using Request = MittagLefflerRequest;
using Decimals = std::vector<DecimalComplex>;
using Doubles = std::vector<MittagLefflerValue>;

// Digits computed before rounding to double: the bound stays close to half a unit in the last place.
constexpr int digits_of_doubles = 20;

// Decimals below the range of double are valid.
void require_parameter(std::string_view name, const std::string& text) {
  if (!is_decimal(text) || std::abs(std::strtod(text.c_str(), nullptr)) > mittag_leffler_parameters.high)
    reject_text(name, text, mittag_leffler_parameters.text());
}

void require_decimals(std::string_view name, const DecimalComplex& z) {
  for (const auto& part : {z.re, z.im})
    if (!is_decimal(part)) reject_text(name, part, any_number.text());
}

void require_one_function(const Request& x, bool is_matrix) {
  const auto refuse = [](std::string_view name, const std::string& value, const std::string& other) {
    refuse_value(name, value, {"without ", RequestField{other}});
  };
  if (is_matrix && x.derivative) refuse("derivative", std::to_string(*x.derivative), "matrix");
  if (is_matrix && x.gamma) refuse("gamma", *x.gamma, "matrix");
  if (x.derivative && x.gamma) refuse("gamma", *x.gamma, "derivative");
}

void require_valid(const Request& x) {
  const auto* matrix = std::get_if<Decimals>(&x.argument);
  require_one_function(x, matrix != nullptr);
  parse_number("alpha", x.alpha, mittag_leffler_orders);
  require_parameter("beta", x.beta);
  if (x.gamma) require_parameter("gamma", *x.gamma);
  if (matrix == nullptr) require_decimals("z", std::get<DecimalComplex>(x.argument));
  if (matrix != nullptr)
    for (const auto& entry : *matrix) require_decimals("matrix", entry);
  if (x.digits) require_in("digits", *x.digits, CountRange{1, reference::max_digits});
  if (x.derivative) require_in("derivative", *x.derivative, CountRange{0, reference::max_derivative});
}

// The values, where each has a finite bound.
Decimals bounded(Decimals values) {
  // a value without a finite bound exceeds the exponent range of its type
  if (!std::ranges::all_of(values, is_finite_bound, &DecimalComplex::bound))
    throw NumericalFailure("the value is beyond all exponents");
  return values;
}

DecimalComplex in_digits(const Request& x, const DecimalComplex& z, int digits) {
  if (x.derivative)
    return reference::mittag_leffler_derivative(*x.derivative, x.alpha, x.beta, z.re, z.im, digits);
  return x.gamma ? reference::prabhakar(x.alpha, x.beta, *x.gamma, z.re, z.im, digits)
                 : reference::mittag_leffler(x.alpha, x.beta, z.re, z.im, digits);
}

// Takes microseconds if every argument is exactly a double (0.5, not 0.1).
MittagLefflerValue in_double(const Request& x, const DecimalComplex& z) {
  if (!x.derivative && !x.gamma) return reference::mittag_leffler_in_double(x.alpha, x.beta, z.re, z.im);
  const auto alpha = exact_double(x.alpha), beta = exact_double(x.beta),
             gamma = exact_double(x.gamma.value_or("1")), re = exact_double(z.re), im = exact_double(z.im);
  if (!alpha || !beta || !gamma || !re || !im) return rounded_to_double(in_digits(x, z, digits_of_doubles));
  const std::complex<double> number(*re, *im);
  return x.gamma ? reference::prabhakar(*alpha, *beta, *gamma, number)
                 : reference::mittag_leffler_derivative(*x.derivative, *alpha, *beta, number);
}

// The matrix in double; nullopt if an entry is not exactly a double, or it is not square.
std::optional<Eigen::MatrixXcd> exact_matrix(const Decimals& entries) {
  const auto size = std::lround(std::sqrt(static_cast<double>(entries.size())));
  Eigen::MatrixXcd matrix(size, size);
  if (matrix.size() != std::ssize(entries)) return std::nullopt;
  for (Eigen::Index i = 0; i < matrix.size(); ++i) {
    const auto& entry = entries[static_cast<std::size_t>(i)];
    const auto re = exact_double(entry.re), im = exact_double(entry.im);
    if (!re || !im) return std::nullopt;
    matrix(i / size, i % size) = {*re, *im};
  }
  return matrix;
}

Doubles in_double(const Request& x, const Decimals& entries) {
  Doubles values(entries.size());
  const auto alpha = exact_double(x.alpha), beta = exact_double(x.beta);
  const auto matrix = exact_matrix(entries);
  if (!alpha || !beta || !matrix) {
    const auto decimals = bounded(reference::mittag_leffler(x.alpha, x.beta, entries, digits_of_doubles));
    std::ranges::transform(decimals, values.begin(), reference::rounded_to_double);
    return values;
  }
  const auto [value, bound] = reference::mittag_leffler(*alpha, *beta, *matrix);
  for (Eigen::Index i = 0; i < value.size(); ++i) {
    const auto row = i / value.cols(), column = i % value.cols();
    values[static_cast<std::size_t>(i)] = {value(row, column), bound(row, column)};
  }
  return values;
}

}  // namespace

MittagLefflerValues mittag_leffler(const MittagLefflerRequest& request) {
  require_valid(request);
  if (const auto* matrix = std::get_if<Decimals>(&request.argument)) {
    if (!request.digits) return in_double(request, *matrix);
    return bounded(reference::mittag_leffler(request.alpha, request.beta, *matrix, *request.digits));
  }
  const auto& z = std::get<DecimalComplex>(request.argument);
  if (!request.digits) return Doubles{in_double(request, z)};
  return bounded({in_digits(request, z, *request.digits)});
}

}  // namespace fde::bench
