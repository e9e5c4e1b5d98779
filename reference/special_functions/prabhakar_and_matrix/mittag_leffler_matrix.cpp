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
#include "fdebench/reference/special_functions/prabhakar_and_matrix/resolvent.hpp"
#include "fdebench/reference/special_functions/prabhakar_and_matrix/schur_form.hpp"

namespace fde::reference {
namespace {

using Long = long double;
using Point = EnclosingContour::Point;
using Node = EnclosingContour::Node;
using Disc = EnclosingContour::Disc;

constexpr int most_rows = 64;
constexpr const char* function_name = "mittag_leffler of a matrix";

struct MatrixArguments {
  BigReal alpha, beta;
  BigMatrix matrix;

  [[nodiscard]] bool real() const {
    return std::ranges::all_of(matrix.entries,
                               [](const BigComplex& x) { return imag_part<BigReal>(x) == 0; });
  }
};
using Read = std::function<MatrixArguments()>;

Long to_long(const BigReal& x) { return x.convert_to<Long>(); }

// Sizes beside which an entry of X = M^-1 whose terms cancel is small: the entries of |X| |M| |X|, which are
// 0 where an entry of X is 0 in every term, but at most the norm of X.
std::vector<Long> sizes_of_summands(const BigMatrix& inverse, const BigMatrix& matrix) {
  const auto sizes = [](const BigMatrix& of) {
    Eigen::Matrix<Long, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> result(of.size, of.size);
    for (int i = 0; i < of.size; ++i)
      for (int j = 0; j < of.size; ++j) result(i, j) = to_long(norm1(of(i, j)));
    return result;
  };
  const auto x = sizes(inverse);
  const Long norm = x.rowwise().sum().maxCoeff();
  const decltype(sizes(inverse)) product = (x * sizes(matrix) * x).cwiseMin(norm);
  return {product.data(), product.data() + product.size()};
}

// Adds weight s^(alpha-beta) (s^alpha - A)^-1 at a node.
void add_node(const MatrixArguments& x, const Node& node, std::vector<BoundedSum<BigReal>>& sums) {
  sums.resize(x.matrix.entries.size());
  const BigComplex s_alpha = exp(BigComplex(x.alpha * node.log_s));
  const BigComplex weight = node.weight * exp(BigComplex((x.alpha - x.beta) * node.log_s));
  BigMatrix shifted = x.matrix;
  for (auto& entry : shifted.entries) entry = -entry;
  for (int i = 0; i < shifted.size; ++i) shifted(i, i) += s_alpha;
  const BoundedInverse resolvent = bounded_inverse(shifted);
  const BigReal unit = epsilon<BigReal>(),
                ulps = 8 + 4 * norm1(node.s) + (4 * x.alpha + 4 * abs(x.beta)) * (1 + norm1(node.log_s));
  // a bound of the error of s^alpha
  const BigReal shift = (4 + 4 * x.alpha * (1 + norm1(node.log_s))) * unit * norm1(s_alpha);
  const BigReal size = norm1(weight),
                off = size * (resolvent.bound + 2 * shift * resolvent.norm * resolvent.norm);
  const auto summands = sizes_of_summands(resolvent.value, shifted);
  for (std::size_t i = 0; i < sums.size(); ++i) {
    const BigComplex term = weight * resolvent.value.entries[i];
    sums[i].add(term, norm1(term), BigReal(ulps * unit), BigReal(0));
    sums[i].error += off;
    sums[i].scale += size * summands[i];
  }
}

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
                              .real = x.real()};
  if (!(is_integer(x.alpha) && is_integer(x.beta) && power >= 0.0L))
    transform.singularities.emplace_back(0.0L);
  const SchurForm schur(x.matrix);
  for (const auto& logarithm : schur.log_eigenvalues()) {
    for (const auto& root : roots_on_sheet(alpha, logarithm)) transform.singularities.push_back(root.value);
  }
  transform.prepare = [read] {
    return
        [x = read()](const Node& node, std::vector<BoundedSum<BigReal>>& sums) { add_node(x, node, sums); };
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
    texts.push_back(to_decimal_complex(value, x.real(), digits));
  return texts;
}

}  // namespace fde::reference
