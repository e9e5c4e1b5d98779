// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "fdebench/benchmarks/reference_data/table_kind.hpp"
#include "fdebench/benchmarks/reference_data/tables/mittag_leffler_points.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"

namespace fde::bench {
namespace {

TableMetadata mittag_leffler_facts(const SceneVariant& /*of*/) {
  return {
      .title = "Mittag-Leffler function E_{alpha,beta}(z) of two parameters",
      .method =
          "inverse Laplace transform in multiple precision: one trapezoidal sum on a parabola round the "
          "branch cut and residues at the poles, with a bound by theory",
      .source =
          "E_{alpha,beta}(z) = sum_{k>=0} z^k / Gamma(alpha k + beta); NIST Digital Library of "
          "Mathematical Functions, section 10.46",
      .bound = "of |E - (re + i im)|, the rounding of the texts included",
      .digits = table_digits,
      .columns = {
          {.name = "alpha",
           .description = "first parameter, in (0, 5], taken as the decimal it is",
           .argument = true,
           .minimum = 0,
           .maximum = 5},
          {.name = "beta", .description = "second parameter, taken as the decimal it is", .argument = true},
          {.name = "re_z",
           .description = "real part of the argument, taken as the decimal it is",
           .argument = true},
          {.name = "im_z",
           .description = "imaginary part of the argument",
           .required = false,
           .argument = true},
          {.name = "re", .description = "real part of E_{alpha,beta}(z)"},
          {.name = "im", .description = "imaginary part of E_{alpha,beta}(z)", .required = false},
          {.name = "bound", .description = "bound of the absolute error", .required = false, .minimum = 0}}};
}

ComputedTable mittag_leffler_rows(const SceneVariant& of) {
  ComputedTable made;
  for (const auto& column : mittag_leffler_facts(of).columns) made.table.columns.push_back(column.name);
  for (const auto& [alpha, beta, re, im] : mittag_leffler_points()) {
    const auto value = reference::mittag_leffler(alpha, beta, re, im, table_digits);
    made.table.rows.push_back({alpha, beta, re, im, value.re, value.im, value.bound});
  }
  return made;
}

RowCheck mittag_leffler_check(const SceneVariant& /*of*/, const DataTable& given) {
  const auto comparison = std::make_shared<TableComparison>(given, std::vector<std::string>{"re", "im"});
  return [&given, comparison](std::size_t row) {
    const auto cell = [&](std::string_view column) {
      const auto at = given.find(column);
      return at ? given.rows[row][*at] : "0";
    };
    const auto value = reference::mittag_leffler(cell("alpha"), cell("beta"), cell("re_z"), cell("im_z"),
                                                 comparison->digits() + more_digits);
    if (value.bound == "inf") throw std::runtime_error("the value is beyond all exponents");
    const std::vector<reference::Decimal> recomputed{{value.re, value.bound}, {value.im, value.bound}};
    comparison->require_accurate(row, recomputed, comparison->digits());
    return (*comparison)(row, recomputed);
  };
}

}  // namespace

const TableKind mittag_leffler_table{.id = "mittag_leffler",
                                     .folder = "",
                                     .identifying_column = "re_z",
                                     .facts = mittag_leffler_facts,
                                     .make = mittag_leffler_rows,
                                     .check = mittag_leffler_check};

}  // namespace fde::bench
