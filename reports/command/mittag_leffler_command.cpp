#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <ostream>

#include "command/arguments.hpp"
#include "command/command.hpp"
#include "prabhakar_and_matrix/mittag_leffler_matrix.hpp"
#include "prabhakar_and_matrix/prabhakar.hpp"
#include "references/written_bound.hpp"
#include "scenes/number_text.hpp"

namespace fde {
namespace {

struct Arguments {
  std::string alpha, beta;
  std::optional<std::string> z, derivative, gamma, matrix, digits;
};

struct Function {
  double alpha = 0.0, beta = 0.0;
  std::optional<int> digits{};
};

[[noreturn]] void reject_option(std::string_view name, const std::string& value, std::string_view allowed) {
  throw std::invalid_argument(fmt::format("{} = {}: must be {}", name, value, allowed));
}

// At most one of the options, and Z or --matrix.
void check(const Arguments& x) {
  if (x.matrix && x.derivative) reject_option("--derivative", *x.derivative, "without --matrix");
  if (x.matrix && x.gamma) reject_option("--gamma", *x.gamma, "without --matrix");
  if (x.matrix && x.z) reject_option("Z", *x.z, "left out with --matrix");
  if (x.derivative && x.gamma) reject_option("--gamma", *x.gamma, "without --derivative");
  if (!x.matrix && !x.z)
    throw std::invalid_argument("Z is missing: must be RE, RE,IM or RE+IMi, or --matrix in its place");
}

Function function_of(const Arguments& x) {
  Function function{.alpha = parse_number("ALPHA", x.alpha, {.low = 0.0, .high = 5.0, .open_low = true}),
                    .beta = parse_number("BETA", x.beta, any_number)};
  if (x.digits) function.digits = parse_count("--digits", *x.digits, 1, most_digits);
  return function;
}

// A value of digits without a finite bound is beyond the exponents of the multiprecision type.
void require_known(const DecimalComplex& value) {
  if (!is_finite_bound(value.bound)) throw NumericalFailure("the value is beyond all exponents of --digits");
}

void print(const DecimalComplex& value, std::ostream& out) {
  require_known(value);
  out << fmt::format("{} {} {}\n", value.re, value.im, value.bound);
}

[[noreturn]] void refuse_overflow() { throw NumericalFailure("the value is beyond double; --digits has it"); }

void print(std::complex<double> value, double bound, std::ostream& out) {
  if (!std::isfinite(value.real()) || !std::isfinite(value.imag()) || !std::isfinite(bound))
    refuse_overflow();
  out << fmt::format("{:.17g} {:.17g} {}\n", value.real(), value.imag(),
                     bound_text(bound_of_text(value.imag(), bound_of_text(value.real(), bound))));
}

void of_number(const Arguments& x, const Function& function, std::ostream& out) {
  const auto [re, im] = split_complex(*x.z);
  const auto [alpha, beta, digits] = function;
  // Decimals need not be within the range of a double.
  if (digits && !x.derivative && !x.gamma)
    return print(mittag_leffler(x.alpha, x.beta, re, im, *digits), out);
  const std::complex<double> z{parse_number("Z", re, any_number), parse_number("Z", im, any_number)};
  if (x.derivative) {
    const int k = parse_count("--derivative", *x.derivative, 0, most_derivatives);
    if (digits) return print(mittag_leffler_derivative(k, x.alpha, x.beta, re, im, *digits), out);
    const auto [value, bound] = mittag_leffler_derivative(k, alpha, beta, z);
    return print(value, bound, out);
  }
  if (x.gamma) {
    const double gamma = parse_number("--gamma", *x.gamma, any_number);
    if (digits) return print(prabhakar(x.alpha, x.beta, *x.gamma, re, im, *digits), out);
    const auto [value, bound] = prabhakar(alpha, beta, gamma, z);
    return print(value, bound, out);
  }
  const auto [value, bound] = mittag_leffler(alpha, beta, z);
  print(value, bound, out);
}

// "1,2;3,4" row by row.
std::vector<DecimalComplex> entries_of(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t begin = 0; begin <= text.size();) {
    const auto end = std::min(text.find(';', begin), text.size());
    rows.push_back(split_list(std::string_view(text).substr(begin, end - begin)));
    begin = end + 1;
  }
  std::vector<DecimalComplex> entries;
  for (const auto& row : rows) {
    if (row.size() != rows.size()) {
      reject_option("--matrix", text,
                    fmt::format("square: of {} rows one has length {}", rows.size(), row.size()));
    }
    for (const auto& entry : row) {
      const auto [re, im] = split_complex(entry);
      entries.push_back({re, im, "0"});
    }
  }
  return entries;
}

void of_matrix(const Arguments& x, const Function& function, std::ostream& out) {
  const auto entries = entries_of(*x.matrix);
  std::vector<std::complex<double>> numbers;
  for (const auto& [re, im, bound] : entries)
    numbers.emplace_back(parse_number("--matrix", re, any_number), parse_number("--matrix", im, any_number));
  const auto size = static_cast<Eigen::Index>(std::lround(std::sqrt(static_cast<double>(entries.size()))));
  if (function.digits) {
    const auto values = mittag_leffler(x.alpha, x.beta, entries, *function.digits);
    std::ranges::for_each(values, require_known);
    for (std::size_t i = 0; i < values.size(); ++i) {
      out << fmt::format("{} {} ", i / static_cast<std::size_t>(size) + 1,
                         i % static_cast<std::size_t>(size) + 1);
      print(values[i], out);
    }
    return;
  }
  using ByRows = Eigen::Matrix<std::complex<double>, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const ComplexMatrix matrix = Eigen::Map<const ByRows>(numbers.data(), size, size);
  const auto [value, bound] = mittag_leffler(function.alpha, function.beta, matrix);
  if (!value.allFinite() || !bound.allFinite()) refuse_overflow();
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j < size; ++j) {
      out << fmt::format("{} {} ", i + 1, j + 1);
      print(value(i, j), bound(i, j), out);
    }
  }
}

}  // namespace

void add_mittag_leffler_command(CommandLine& program, const Streams& streams, const Scenes& /*known*/) {
  auto arguments = std::make_shared<Arguments>();
  Subcommand command(program, "mittag-leffler", "E_{ALPHA,BETA}(Z) as: re im bound");
  command.required("ALPHA", arguments->alpha, "in (0, 5]");
  command.required("BETA", arguments->beta, "a real number");
  command.option("Z", arguments->z, "RE, RE,IM or RE+IMi");
  command.option("--derivative", arguments->derivative, "K: the K-th derivative in Z");
  command.option("--gamma", arguments->gamma, "G: the three-parameter function of Prabhakar");
  command.option("--matrix", arguments->matrix,
                 "\"1,2;3,4+i\" in place of Z; then a line for each entry: row column re im bound");
  command.option("--digits", arguments->digits, "number of decimal digits; default double");
  command.callback([=] {
    check(*arguments);
    const Function function = function_of(*arguments);
    if (arguments->matrix) return of_matrix(*arguments, function, streams.out);
    of_number(*arguments, function, streams.out);
  });
}

}  // namespace fde
