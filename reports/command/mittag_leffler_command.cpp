// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "fdebench/benchmarks/references/decimal_bound.hpp"
#include "fdebench/benchmarks/requests/mittag_leffler_request.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/reference/special_functions/prabhakar_and_matrix/prabhakar.hpp"
#include "fdebench/reports/command/command.hpp"
#include "fdebench/reports/command/reference_progress.hpp"

namespace fde::bench {
namespace {

std::string line_of(const reference::DecimalComplex& value) {
  return fmt::format("{} {} {}\n", value.re, value.im, value.bound);
}

std::string line_of(const reference::MittagLefflerValue& result) {
  const double re = result.value.real(), im = result.value.imag();
  if (!std::isfinite(re) || !std::isfinite(im) || !std::isfinite(result.bound))
    throw NumericalFailure("the value is beyond double; --digits has it");
  return fmt::format("{:.17g} {:.17g} {}\n", re, im,
                     bound_text(bound_of_decimal(im, bound_of_decimal(re, result.bound))));
}

// A line for each entry of a square matrix, with its row and column in front, or one for a number.
template <typename Value>
std::string lines_of(const std::vector<Value>& entries, bool is_matrix) {
  if (!is_matrix) return line_of(entries.front());
  const auto size = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(entries.size()))));
  std::string lines;
  for (std::size_t i = 0; i < entries.size(); ++i)
    lines += fmt::format("{} {} {}", i / size + 1, i % size + 1, line_of(entries[i]));
  return lines;
}

// Splits "1", "1,2", "-2.5i", "1e-3+i" into the texts of real and imaginary part, which are not validated.
reference::DecimalComplex split_complex(std::string_view text) {
  const auto comma = text.find(',');
  if (comma != std::string_view::npos)
    return {std::string(text.substr(0, comma)), std::string(text.substr(comma + 1)), "0"};
  if (!text.ends_with('i')) return {std::string(text), "0", "0"};
  text.remove_suffix(1);
  // The last sign that does not belong to an exponent separates the parts.
  auto sign = text.find_last_of("+-");
  while (sign != std::string_view::npos && sign > 0 && (text[sign - 1] == 'e' || text[sign - 1] == 'E'))
    sign = text.find_last_of("+-", sign - 1);
  const std::size_t begin = sign == std::string_view::npos ? 0 : sign;
  std::string im(text.substr(begin));
  if (im.empty() || im == "+" || im == "-") im += "1";
  return {begin == 0 ? "0" : std::string(text.substr(0, begin)), im, "0"};
}

// The entries of "1,2;3,4", row by row.
std::vector<reference::DecimalComplex> parse_matrix(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  for (std::size_t begin = 0; begin <= text.size();) {
    const auto end = std::min(text.find(';', begin), text.size());
    rows.push_back(split_list(std::string_view(text).substr(begin, end - begin)));
    begin = end + 1;
  }
  std::vector<reference::DecimalComplex> entries;
  for (const auto& row : rows) {
    if (row.size() != rows.size()) {
      refuse_value("matrix", text,
                   {fmt::format("square: of {} rows one has length {}", rows.size(), row.size())});
    }
    std::ranges::transform(row, std::back_inserter(entries), split_complex);
  }
  return entries;
}

MittagLefflerRequest function_request_of(const Given& given) {
  const auto z = given.find("Z"), matrix = given.find("--matrix");
  if (!matrix && !z)
    throw std::invalid_argument("Z is missing: must be RE, RE,IM or RE+IMi, or --matrix in its place");
  if (matrix && z) refuse_value("Z", *z, {"left out with --matrix"});
  MittagLefflerRequest request{.alpha = given.text("ALPHA"),
                               .beta = given.text("BETA"),
                               .derivative = given.find_count("--derivative"),
                               .gamma = given.find("--gamma"),
                               .digits = given.find_count("--digits")};
  if (matrix) request.argument = parse_matrix(*matrix);
  if (z) request.argument = split_complex(*z);
  return request;
}

std::string answer(const Given& given) {
  try {
    const auto request = function_request_of(given);
    const bool is_matrix = given.has("--matrix");
    return std::visit([=](const auto& entries) { return lines_of(entries, is_matrix); },
                      mittag_leffler(request));
  } catch (const Refusal& refusal) {
    given.refuse(refusal, {{"alpha", "ALPHA"}, {"beta", "BETA"}, {"z", "Z"}});
  }
}

void print_mittag_leffler(const Given& given, const Streams& streams, const SceneRegistry& /*known*/) {
  ReferenceProgress work(streams, given.find_number("--budget"), "the value");
  try {
    streams.out << answer(given);
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
       {{"ALPHA:ALPHA", "the first parameter", mittag_leffler_orders},
        {"BETA:BETA", "the second parameter", mittag_leffler_parameters},
        {"[Z:Z]", "the argument: RE, RE,IM or RE+IMi"},
        {"[--derivative K]", "the K-th derivative in Z", CountRange{0, reference::max_derivative}},
        {"[--gamma G]", "the three-parameter function of Prabhakar", mittag_leffler_parameters},
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
