// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/prabhakar_and_matrix/mittag_leffler_matrix.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "fdebench/reference/special_functions/laplace/enclosed_transform.hpp"
#include "fdebench/reference/special_functions/laplace/sheets.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/decimal_arguments.hpp"
#include "fdebench/reference/special_functions/numbers/bounded.hpp"
#include "fdebench/reference/special_functions/numbers/constants.hpp"
#include "fdebench/reference/special_functions/prabhakar_and_matrix/mittag_leffler_matrix_quick.hpp"
#include "fdebench/reference/special_functions/prabhakar_and_matrix/resolvent_sums.hpp"
#include "fdebench/reference/special_functions/prabhakar_and_matrix/schur_form.hpp"

namespace fde::reference {
namespace {

using Long = long double;
using Point = EnclosingContour::Point;
using Disc = EnclosingContour::Disc;

constexpr int most_rows = 64;
constexpr const char* function_name = "mittag_leffler of a matrix";

struct MatrixArguments {
  BigReal alpha, beta;
  BigMatrix matrix;
};
using Read = std::function<MatrixArguments()>;

Long to_long(const BigReal& x) { return x.convert_to<Long>(); }

// Majorant of |s^(alpha-beta)| |(s^alpha - A)^-1| on a disc.
EnclosingContour::Majorant majorant_of(const SchurForm& schur, Long alpha, Long power) {
  return [=](const Disc& disc) {
    const Long size = std::abs(disc.centre), nearest = size - disc.radius, farthest = size + disc.radius;
    const bool whole = is_integer(alpha);
    if (nearest <= 0.0L && (!whole || power < 0.0L)) return infinity_long;
    // a bound of |s^alpha - centre^alpha| on the disc; the allowance for rounding follows
    const Long moved = whole ? std::pow(farthest, alpha) - std::pow(size, alpha)
                             : std::pow(size, alpha) * std::expm1(-alpha * std::log1p(-disc.radius / size));
    const Point z = std::exp(alpha * std::log(disc.centre));
    const Long norm =
        schur.resolvent_norm(z, moved + 1e-17L * (1.0L + std::abs(std::log(size))) * std::abs(z));
    const Long log_power = power == 0.0L ? 0.0L : power * std::log(power < 0.0L ? nearest : farthest);
    return log_power + std::log(norm) + 1e-9L;
  };
}

// A bound of the logarithm to base 10 of
//   (|x| + |A|)^n / |p(x)|,  p(x) = product of x - eigenvalue,
// at the nodes, x = s^alpha, with a few digits for each row: by so much the terms of the adjugate and of p
// may exceed their sums.
int digits_lost_on(const EnclosingContour& contour, Long alpha, Long norm,
                   const std::vector<Point>& log_eigenvalues) {
  constexpr Long digits_of_row = 0.7L, least = 1e-300L;
  Long most = 0.0L;
  for (int k = -contour.count(); k <= contour.count(); ++k) {
    const Point x = std::exp(alpha * std::log(contour.node(k)));
    Long sum = 0.0L;
    for (const Point& logarithm : log_eigenvalues)
      sum += std::log10((std::abs(x) + norm) / std::max(least, std::abs(x - std::exp(logarithm))));
    most = std::max(most, sum);
  }
  return static_cast<int>(most + digits_of_row * static_cast<Long>(log_eigenvalues.size())) + 3;
}

Long row_norm(const BigMatrix& matrix) {
  Long largest = 0.0L;
  for (int i = 0; i < matrix.size; ++i) {
    Long row = 0.0L;
    for (int j = 0; j < matrix.size; ++j) row += to_long(norm1(matrix(i, j)));
    largest = std::max(largest, row);
  }
  return largest;
}

// Working digits for the eigenvalues, whose error is of the size of the last digit of the largest entry: at
// least 60 correct digits for eigenvalues of size 1.
int digits_of_eigenvalues(const Read& read) {
  constexpr int enough = 70, most = 1000;
  BigReal largest(1);
  for (const auto& entry : read().matrix.entries) largest = std::max(largest, norm1(entry));
  return enough + std::min(most, static_cast<int>(BigReal(log10(largest)).convert_to<double>()));
}

EnclosedTransform transform_of(const Read& read) {
  const Precision precision(digits_of_eigenvalues(read));
  const MatrixArguments x = read();
  const Long alpha = to_long(x.alpha), power = to_long(BigReal(x.alpha - x.beta));
  EnclosedTransform transform{.singularities = {},
                              .hints = {.order = static_cast<Long>(std::min(x.matrix.size, 4)),
                                        .growth = 1.0L + alpha + std::abs(power)},
                              .real = x.matrix.real()};
  if (!(is_integer(x.alpha) && is_integer(x.beta) && power >= 0.0L))
    transform.singularities.emplace_back(0.0L);
  const SchurForm schur(x.matrix);
  for (const auto& logarithm : schur.log_eigenvalues()) {
    for (const auto& root : roots_on_sheet(alpha, logarithm)) transform.singularities.push_back(root.value);
  }
  keep_right_of_saddle_point(transform, alpha - power);
  transform.prepare = [read] {
    const MatrixArguments now = read();
    return resolvent_sums(now.alpha, now.beta, now.matrix);
  };
  transform.lost_digits = [alpha, norm = row_norm(x.matrix),
                           eigenvalues = schur.log_eigenvalues()](const EnclosingContour& contour) {
    return digits_lost_on(contour, alpha, norm, eigenvalues);
  };
  transform.majorants = {majorant_of(schur, alpha, power)};
  return transform;
}

std::vector<Bounded<BigReal>> evaluate(const Read& read, int digits) {
  try {
    return invert(transform_of(read), digits);
  } catch (const std::runtime_error& error) {
    const MatrixArguments x = read();
    throw std::runtime_error(fmt::format("{} of {} rows, alpha = {:.6g}, beta = {:.6g}: {}", function_name,
                                         x.matrix.size, to_long(x.alpha), to_long(x.beta), error.what()));
  }
}

void require(bool holds, const std::string& message) {
  if (!holds) throw std::invalid_argument(fmt::format("{}: {}", function_name, message));
}

void require_size(std::size_t rows, std::size_t entries) {
  require(rows * rows == entries,
          fmt::format("a matrix of {} entries with {} rows has to be square", entries, rows));
  require(rows >= 1 && rows <= most_rows,
          fmt::format("the matrix has {} rows, but has to have 1 to {}", rows, most_rows));
}

BoundedDouble rounded(const QuickValue& x) { return to_double(x.value, x.error); }
BoundedDouble rounded(const Bounded<BigReal>& x) { return to_double(x); }

// Entries row by row.
template <class Entry>
MatrixValue evaluate_in_double(int size, const std::vector<Entry>& entries) {
  const BigMatrix shape{size, {}};
  MatrixValue result{Eigen::MatrixXcd(size, size), Eigen::MatrixXd(size, size)};
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j) {
      const auto [value, bound] = rounded(entries[shape.index(i, j)]);
      if (!std::isfinite(bound)) {
        throw std::runtime_error(
            fmt::format("mittag_leffler of a matrix: entry {} {} is beyond double", i + 1, j + 1));
      }
      result.value(i, j) = value + std::complex(0.0, 0.0);  // no -0
      result.bound(i, j) = bound;
    }
  }
  return result;
}

}  // namespace

MatrixValue mittag_leffler(double alpha, double beta, const Eigen::MatrixXcd& matrix) {
  require_order(function_name, alpha);
  require_parameter(function_name, "beta", beta);
  require(matrix.rows() == matrix.cols(),
          fmt::format("a matrix of {} x {} has to be square", matrix.rows(), matrix.cols()));
  require_size(static_cast<std::size_t>(matrix.rows()), static_cast<std::size_t>(matrix.size()));
  require(matrix.allFinite(), "entries of the matrix have to be finite");
  const auto size = static_cast<int>(matrix.rows());
  if (const auto quick = mittag_leffler_matrix_quick(alpha, beta, matrix))
    return evaluate_in_double(size, *quick);
  const Read read = [&] {
    MatrixArguments x{BigReal(alpha), BigReal(beta), {size, {}}};
    for (int i = 0; i < size; ++i) {
      for (int j = 0; j < size; ++j) x.matrix.entries.emplace_back(matrix(i, j).real(), matrix(i, j).imag());
    }
    return x;
  };
  return evaluate_in_double(size, evaluate(read, double_digits));
}

MatrixValue mittag_leffler(double alpha, double beta, const Eigen::MatrixXd& matrix) {
  return mittag_leffler(alpha, beta, Eigen::MatrixXcd(matrix.cast<std::complex<double>>()));
}

std::vector<DecimalComplex> mittag_leffler(const std::string& alpha, const std::string& beta,
                                           const std::vector<DecimalComplex>& matrix, int digits) {
  require_digits(function_name, digits);
  const auto size = static_cast<int>(std::lround(std::sqrt(static_cast<double>(matrix.size()))));
  require_size(static_cast<std::size_t>(size), matrix.size());
  const Read read = [&] {
    MatrixArguments x{parse_argument(function_name, "alpha", alpha),
                      parse_argument(function_name, "beta", beta),
                      {size, {}}};
    for (const auto& entry : matrix) {
      x.matrix.entries.emplace_back(parse_argument(function_name, "entry", entry.re),
                                    parse_argument(function_name, "entry", entry.im));
    }
    return x;
  };
  const Precision precision(digits + 20);
  const MatrixArguments x = read();
  require_order(function_name, x.alpha);
  require_parameter(function_name, "beta", x.beta);
  std::vector<DecimalComplex> texts;
  for (const auto& value : evaluate(read, digits))
    texts.push_back(to_decimal_complex(value, x.matrix.real(), digits));
  return texts;
}

}  // namespace fde::reference
