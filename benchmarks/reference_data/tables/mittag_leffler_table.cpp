// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/reference_data/tables/mittag_leffler_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <numbers>
#include <stdexcept>

#include "fdebench/benchmarks/reference_data/table_kind.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"
#include "fdebench/reference/special_functions/numbers/real.hpp"

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

using Points = std::vector<MittagLefflerPoint>;
using Texts = std::vector<std::string>;

constexpr int argument_digits = 20;

std::string argument(const reference::BigReal& x) { return reference::to_text(x, argument_digits); }

// E_{1/8}(-x^(1/8)), 0 <= x <= 2: the whole singular layer at 0 of a relaxation of small order.
void add_small_order(Points& points) {
  const reference::Precision precision(2 * argument_digits);
  for (int k = 0; k <= 200; ++k) {
    const reference::BigReal x = reference::BigReal(k) / 100;
    points.push_back(
        {"0.125", "1",
         argument(reference::BigReal(k == 0 ? x : reference::BigReal(-pow(x, reference::BigReal(0.125))))),
         "0"});
  }
}

// E_{1/2}(-x) = e^(x^2) erfc(x), 20 <= x <= 40; e^(x^2) overflows double at 26.6.
void add_scaled_error_function(Points& points) {
  for (int k = 40; k <= 80; ++k) points.push_back({"0.5", "1", fmt::format("{}", -0.5 * k), "0"});
}

// On rays up to |arg z| = alpha pi/2, where the exponential term neither grows nor decays, and alpha pi,
// where it appears; beta = alpha is the kernel of linear equations.
void add_rays(Points& points) {
  const reference::Precision precision(2 * argument_digits);
  for (const auto* alpha : {"0.3", "0.7", "0.9"}) {
    for (const double part : {0.25, 0.5, 0.75, 1.0}) {
      const reference::BigReal angle = part * reference::parse<reference::BigReal>(alpha) *
                                       reference::pi<reference::BigReal>(),
                               x = cos(angle), y = sin(angle);
      for (const int r : {1, 10, 50}) {
        if (part == 0.25 && r > 1) continue;
        for (const auto* beta : {alpha, "1"}) {
          points.push_back(
              {alpha, beta, argument(reference::BigReal(r * x)), argument(reference::BigReal(r * y))});
        }
      }
    }
  }
}

void add_all(Points& points, const Texts& alphas, const Texts& betas, const Texts& res) {
  for (const auto& alpha : alphas) {
    for (const auto& beta : betas) {
      for (const auto& re : res) points.push_back({alpha, beta == "alpha" ? alpha : beta, re, "0"});
    }
  }
}

void add_hard_points(Points& points) {
  add_small_order(points);
  add_scaled_error_function(points);
  add_rays(points);
  // Very small order, and slowly decaying oscillation, at large |z|.
  add_all(points, {"0.05", "1.999"}, {"1", "alpha"}, {"-1e4", "-100", "-1"});
  // Poles of Gamma: the first terms of the series and of the asymptotic expansion vanish.
  add_all(points, {"0.5", "1", "1.5"}, {"0", "-1", "-2", "-5"}, {"-20", "-2", "-0.5", "0", "0.5", "2"});
  // Orders close to an integer, where a pole approaches the branch cut.
  add_all(points, {"0.99", "0.9999", "0.99999999", "1.00000001", "1.0001", "1.01"}, {"1", "alpha", "2"},
          {"-100", "-20", "-5", "-1", "1", "5"});
  add_all(points, {"1.99", "1.9999", "1.99999999", "2.00000001", "2.0001", "2.01"}, {"1", "alpha", "2"},
          {"-1000", "-100", "-10", "-1", "1", "10"});
}

void add_grid(Points& points) {
  const Texts alphas{"0.1", "0.25", "0.4", "0.5",  "0.6", "0.75", "0.9", "1",
                     "1.1", "1.25", "1.5", "1.75", "1.9", "2",    "3",   "5"};
  const std::vector<std::array<const char*, 2>> zs{
      {"-1000", "0"}, {"-100", "0"}, {"-20", "0"}, {"-10", "0"},   {"-5", "0"},     {"-2", "0"}, {"-1", "0"},
      {"-0.5", "0"},  {"-0.1", "0"}, {"0.1", "0"}, {"0.5", "0"},   {"1", "0"},      {"2", "0"},  {"5", "0"},
      {"10", "0"},    {"0", "0.5"},  {"0", "3"},   {"0.5", "0.5"}, {"-0.5", "0.5"}, {"3", "4"},  {"-3", "4"},
      {"-3", "-4"},   {"0", "20"},   {"30", "40"}, {"-30", "40"},  {"-60", "-80"}};
  for (const auto& alpha : alphas) {
    for (const auto& beta :
         {std::string("0.5"), std::string("1"), alpha, std::string("2"), std::string("-0.5")}) {
      for (const auto& [re, im] : zs) points.push_back({alpha, beta, re, im});
    }
  }
}

// Where |arg z| < alpha pi/2 the value grows like exp(z^(1/alpha)).
bool is_in_range(const MittagLefflerPoint& point) {
  constexpr double largest_exponent = 600.0;  // e^600 and its factor z^((1-beta)/alpha)/alpha are doubles
  const double alpha = std::stod(point.alpha);
  const std::complex z(std::stod(point.re), std::stod(point.im));
  const double angle = std::abs(std::arg(z)) / alpha;
  if (angle >= 0.5 * std::numbers::pi) return true;
  return std::pow(std::abs(z), 1.0 / alpha) * std::cos(angle) <= largest_exponent;
}

}  // namespace

const TableKind mittag_leffler_table{.id = "mittag_leffler",
                                     .folder = "",
                                     .identifying_column = "re_z",
                                     .facts = mittag_leffler_facts,
                                     .make = mittag_leffler_rows,
                                     .check = mittag_leffler_check};

std::vector<MittagLefflerPoint> mittag_leffler_points() {
  Points all, points;
  add_hard_points(all);
  add_grid(all);
  for (auto& point : all) {
    if (is_in_range(point) && std::ranges::find(points, point) == points.end())
      points.push_back(std::move(point));
  }
  return points;
}

}  // namespace fde::bench
