// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "fdebench/benchmarks/references/decimal_bound.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/decimal_arguments.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"
#include "fdebench/reference/special_functions/prabhakar_and_matrix/mittag_leffler_matrix.hpp"
#include "fdebench/reference/special_functions/prabhakar_and_matrix/prabhakar.hpp"
#include "fdebench/reports/command/command.hpp"
#include "fdebench/reports/command/reference_progress.hpp"

namespace fde::bench {
namespace {

constexpr Range parameters{.low = -reference::largest_parameter, .high = reference::largest_parameter};

// The arguments of the function as they are given.
struct Arguments {
  const Given& given;
  std::string alpha = given.text("ALPHA"), beta = given.text("BETA");
  std::optional<std::string> z = given.find("Z"), gamma = given.find("--gamma"),
                             matrix = given.find("--matrix");
};

// Digits computed before rounding to double, when --digits is not given: the bound stays close to half a unit
// in the last place.
constexpr int digits_of_doubles = 20;

[[noreturn]] void reject_option(std::string_view name, const std::string& value, std::string_view allowed) {
  throw std::invalid_argument(fmt::format("{} = {}: must be {}", name, value, allowed));
}

// At most one of the options, and Z or --matrix.
void check(const Arguments& x) {
  const auto derivative = x.given.find("--derivative");
  if (x.matrix && derivative) reject_option("--derivative", *derivative, "without --matrix");
  if (x.matrix && x.gamma) reject_option("--gamma", *x.gamma, "without --matrix");
  if (x.matrix && x.z) reject_option("Z", *x.z, "left out with --matrix");
  if (derivative && x.gamma) reject_option("--gamma", *x.gamma, "without --derivative");
  if (!x.matrix && !x.z)
    throw std::invalid_argument("Z is missing: must be RE, RE,IM or RE+IMi, or --matrix in its place");
}

// Decimals below the range of double are valid.
void check_parameter(std::string_view name, const std::string& text) {
  if (!is_decimal(text) || std::abs(std::strtod(text.c_str(), nullptr)) > parameters.high)
    reject_text(name, text, parameters.text());
}

// Checks the parameters without z.
void check_parameters(const Arguments& x) {
  static_cast<void>(x.given.number("ALPHA"));
  check_parameter("BETA", x.beta);
  if (x.gamma) check_parameter("--gamma", *x.gamma);
}

// A multiprecision value without a finite bound exceeds the exponent range of its type.
void require_known(const reference::DecimalComplex& value) {
  if (!is_finite_bound(value.bound)) throw NumericalFailure("the value is beyond all exponents");
}

void print(const reference::DecimalComplex& value, std::ostream& out) {
  require_known(value);
  out << fmt::format("{} {} {}\n", value.re, value.im, value.bound);
}

[[noreturn]] void refuse_overflow() { throw NumericalFailure("the value is beyond double; --digits has it"); }

void print(std::complex<double> value, double bound, std::ostream& out) {
  if (!std::isfinite(value.real()) || !std::isfinite(value.imag()) || !std::isfinite(bound))
    refuse_overflow();
  out << fmt::format("{:.17g} {:.17g} {}\n", value.real(), value.imag(),
                     bound_text(bound_of_decimal(value.imag(), bound_of_decimal(value.real(), bound))));
}

reference::DecimalComplex in_digits(const Arguments& x, const ComplexText& z, int digits) {
  if (const auto k = x.given.find_count("--derivative"))
    return reference::mittag_leffler_derivative(*k, x.alpha, x.beta, z.re, z.im, digits);
  return x.gamma ? reference::prabhakar(x.alpha, x.beta, *x.gamma, z.re, z.im, digits)
                 : reference::mittag_leffler(x.alpha, x.beta, z.re, z.im, digits);
}

// The value in double. Takes microseconds if every argument is exactly a double (0.5, not 0.1).
reference::MittagLefflerValue evaluate_in_double(const Arguments& x, const ComplexText& text) {
  const auto k = x.given.find_count("--derivative");
  if (!k && !x.gamma) return reference::mittag_leffler_in_double(x.alpha, x.beta, text.re, text.im);
  const auto alpha = reference::exact_double(x.alpha), beta = reference::exact_double(x.beta),
             gamma = reference::exact_double(x.gamma.value_or("1")), re = reference::exact_double(text.re),
             im = reference::exact_double(text.im);
  if (!alpha || !beta || !gamma || !re || !im)
    return rounded_to_double(in_digits(x, text, digits_of_doubles));
  const std::complex<double> z(*re, *im);
  if (x.gamma) return reference::prabhakar(*alpha, *beta, *gamma, z);
  return reference::mittag_leffler_derivative(*k, *alpha, *beta, z);
}

void of_number(const Arguments& x, std::ostream& out) {
  const auto z = split_complex(*x.z);
  require_decimal("Z", z.re);
  require_decimal("Z", z.im);
  if (const auto digits = x.given.find_count("--digits")) return print(in_digits(x, z, *digits), out);
  const auto [value, bound] = evaluate_in_double(x, z);
  print(value, bound, out);
}

// The entries of "1,2;3,4", row by row.
std::vector<reference::DecimalComplex> entries_of(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t begin = 0; begin <= text.size();) {
    const auto end = std::min(text.find(';', begin), text.size());
    rows.push_back(split_list(std::string_view(text).substr(begin, end - begin)));
    begin = end + 1;
  }
  std::vector<reference::DecimalComplex> entries;
  for (const auto& row : rows) {
    if (row.size() != rows.size()) {
      reject_option("--matrix", text,
                    fmt::format("square: of {} rows one has length {}", rows.size(), row.size()));
    }
    for (const auto& entry : row) {
      const auto [re, im] = split_complex(entry);
      require_decimal("--matrix", re);
      require_decimal("--matrix", im);
      entries.push_back({re, im, "0"});
    }
  }
  return entries;
}

void print(const std::vector<reference::DecimalComplex>& entries, std::size_t size, bool in_double,
           std::ostream& out) {
  std::ranges::for_each(entries, require_known);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const auto place = fmt::format("{} {} ", i / size + 1, i % size + 1);
    if (in_double) {
      const auto [value, bound] = rounded_to_double(entries[i]);
      out << place;
      print(value, bound, out);
    } else {
      out << place;
      print(entries[i], out);
    }
  }
}

void print(const reference::MatrixValue& matrix, std::ostream& out) {
  const auto& [value, bound] = matrix;
  if (!value.allFinite() || !bound.allFinite()) refuse_overflow();
  for (Eigen::Index i = 0; i < value.rows(); ++i) {
    for (Eigen::Index j = 0; j < value.cols(); ++j) {
      out << fmt::format("{} {} ", i + 1, j + 1);
      print(value(i, j), bound(i, j), out);
    }
  }
}

// The matrix in double; nullopt if an entry is not exactly a double.
std::optional<ComplexMatrix> exact_matrix(const std::vector<reference::DecimalComplex>& entries,
                                          Eigen::Index size) {
  ComplexMatrix matrix(size, size);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const auto re = reference::exact_double(entries[i].re), im = reference::exact_double(entries[i].im);
    if (!re || !im) return std::nullopt;
    const auto at = static_cast<Eigen::Index>(i);
    matrix(at / size, at % size) = {*re, *im};
  }
  return matrix;
}

void of_matrix(const Arguments& x, std::ostream& out) {
  const auto entries = entries_of(*x.matrix);
  const auto size = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(entries.size()))));
  const auto digits = x.given.find_count("--digits");
  const auto alpha = reference::exact_double(x.alpha), beta = reference::exact_double(x.beta);
  const auto matrix = exact_matrix(entries, static_cast<Eigen::Index>(size));
  if (!digits && alpha && beta && matrix)
    return print(reference::mittag_leffler(*alpha, *beta, *matrix), out);
  print(mittag_leffler(x.alpha, x.beta, entries, digits.value_or(digits_of_doubles)), size, !digits, out);
}

void print_mittag_leffler(const Given& given, const Streams& streams, const SceneRegistry& /*known*/) {
  const Arguments x{given};
  check(x);
  check_parameters(x);
  ReferenceProgress work(streams, given.find_number("--budget"), "the value");
  try {
    std::ostringstream lines;
    x.matrix ? of_matrix(x, lines) : of_number(x, lines);
    streams.out << lines.str();
  } catch (const Cancelled&) {
    work.fail();
  }
}

}  // namespace

Command mittag_leffler_command() {
  return {
      {"mittag-leffler",
       "Look up",
       "Print the Mittag-Leffler function E_{ALPHA,BETA}(Z): re im bound",
       {{"ALPHA:ALPHA", "the first parameter", Range{.low = 0.0, .high = 5.0, .open_low = true}},
        {"BETA:BETA", "the second parameter", parameters},
        {"[Z:Z]", "the argument: RE, RE,IM or RE+IMi"},
        {"[--derivative K]", "the K-th derivative in Z", CountRange{0, reference::max_derivative}},
        {"[--gamma G]", "the three-parameter function of Prabhakar", parameters},
        {"[--matrix ROWS]",
         "a square matrix in place of Z, \"1,2;3,4+i\"; then a line for each entry: row column re im bound"},
        digits_argument(),
        evaluation_budget_argument()},
       {{"fdebench mittag-leffler 0.5 1 -30", "prints E_{1/2,1}(-30), its imaginary part and a bound."},
        {"fdebench mittag-leffler 0.8 1 -1+2i --digits 50", "prints fifty digits for a complex argument."}},
       {"exact", "reference"}},
      print_mittag_leffler};
}

}  // namespace fde::bench
