// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/prabhakar_and_matrix/mittag_leffler_matrix_quick.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <boost/container/static_vector.hpp>
#include <cmath>
#include <complex>
#include <type_traits>
#include <utility>

#include "fdebench/reference/special_functions/mittag_leffler/quick_contours.hpp"
#include "fdebench/reference/special_functions/prabhakar_and_matrix/adjugate.hpp"

namespace fde::reference {
namespace {

using Long = long double;
using Value = std::complex<Long>;
template <class T>
using Small = boost::container::static_vector<T, std::size_t{max_quick_rows} * std::size_t{max_quick_rows}>;
template <class T>
using PerRow = boost::container::static_vector<T, max_quick_rows>;

// Error relative to |a| + |b|, not to the sum.
DoubleDouble quick_sum(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble sum = exact_sum(a.hi, b.hi);
  return exact_sum(sum.hi, sum.lo + (a.lo + b.lo));
}
DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble product = exact_product(a.hi, b.hi);
  return exact_sum(product.hi, product.lo + (a.hi * b.lo + a.lo * b.hi));
}
DoubleDouble operator-(const DoubleDouble& a) { return {-a.hi, -a.lo}; }
DoubleDouble divided(const DoubleDouble& a, double by) {
  const double quotient = a.hi / by;
  const DoubleDouble product = exact_product(quotient, by);
  return exact_sum(quotient, (((a.hi - product.hi) - product.lo) + a.lo) / by);
}

ComplexDoubleDouble quick_sum(const ComplexDoubleDouble& a, const ComplexDoubleDouble& b) {
  return {quick_sum(a.re, b.re), quick_sum(a.im, b.im)};
}
ComplexDoubleDouble operator*(const ComplexDoubleDouble& a, const ComplexDoubleDouble& b) {
  return {a.re * b.re + -(a.im * b.im), a.re * b.im + a.im * b.re};
}
ComplexDoubleDouble operator-(const ComplexDoubleDouble& a) { return {-a.re, -a.im}; }
ComplexDoubleDouble divided(const ComplexDoubleDouble& a, double by) {
  return {divided(a.re, by), divided(a.im, by)};
}

double magnitude(const DoubleDouble& a) { return std::abs(a.hi); }
double magnitude(const ComplexDoubleDouble& a) { return std::abs(a.re.hi) + std::abs(a.im.hi); }

ComplexDoubleDouble to_complex(const DoubleDouble& a) { return {a, {0.0, 0.0}}; }
ComplexDoubleDouble to_complex(const ComplexDoubleDouble& a) { return a; }

// A complex number that is a Number: its real part, if all numbers are real.
template <class Number>
Number as(const ComplexDoubleDouble& a) {
  if constexpr (std::is_same_v<Number, DoubleDouble>) {
    return a.re;
  } else {
    return a;
  }
}

template <class Number>
Number number_of(const std::complex<double>& x) {
  if constexpr (std::is_same_v<Number, DoubleDouble>) {
    return {x.real(), 0.0};
  } else {
    return {{x.real(), 0.0}, {x.imag(), 0.0}};
  }
}

// Numbers of the adjugate, real or complex.
template <class RealOrComplex>
struct QuickArithmetic {
  using Number = RealOrComplex;
  using Size = double;
  template <class T>
  using Entries = Small<T>;
  template <class T>
  using Rows = PerRow<T>;

  static double unit() { return 0x1p-98; }
  static Number number(double x) { return number_of<Number>(x); }
  static double size(const Number& x) { return magnitude(x); }
  static Number sum(const Number& a, const Number& b) { return quick_sum(a, b); }
  static Number product(const Number& a, const Number& b) { return a * b; }
  static Number quotient(const Number& a, double by) { return divided(a, by); }
  static Number negative(const Number& a) { return -a; }
};
template <class Number>
using QuickAdjugate = Adjugate<QuickArithmetic<Number>>;

template <class Number>
QuickAdjugate<Number> adjugate_of(const Eigen::MatrixXcd& matrix) {
  Small<Number> entries;
  for (const auto& row : matrix.rowwise())
    for (const auto& entry : row) entries.push_back(number_of<Number>(entry));
  return {static_cast<std::size_t>(matrix.rows()), entries};
}

// Zeros of x^2 + linear x + constant, the smaller one without cancellation.
PerRow<Value> zeros_of_square(const Value& constant, const Value& linear) {
  const Value mean = -0.5L * linear, off = std::sqrt(mean * mean - constant);
  const Value larger = std::real(std::conj(mean) * off) < 0.0L ? mean - off : mean + off;
  return {larger == 0.0L ? 0.0L : constant / larger, larger};
}

using Eigenvalues = PerRow<Value>;

// The eigenvalues of a matrix without a heap: Scalar is real where the matrix is.
template <class Scalar, template <class> class Solver>
Eigenvalues eigenvalues_by_qr(const Eigen::MatrixXcd& matrix) {
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic, 0, max_quick_rows, max_quick_rows>;
  const auto entries = matrix.unaryExpr([](const std::complex<double>& x) {
    if constexpr (std::is_same_v<Scalar, double>) {
      return x.real();
    } else {
      return x;
    }
  });
  const auto found = Solver<Matrix>(Matrix(entries), false).eigenvalues().eval();
  return {found.begin(), found.end()};
}

// One Weierstrass (Durand-Kerner) step on p for each eigenvalue.
template <class Number>
void improve(Eigenvalues& eigenvalues, const PerRow<Number>& p) {
  for (std::size_t i = 0; i < eigenvalues.size(); ++i) {
    Value value = 1.0L, others = 1.0L;
    for (std::size_t j = p.size(); j-- > 0;) value = value * eigenvalues[i] + to_long(to_complex(p[j]));
    for (std::size_t k = 0; k < eigenvalues.size(); ++k)
      others *= k == i ? 1.0L : eigenvalues[i] - eigenvalues[k];
    const Value moved = eigenvalues[i] - value / others;
    if (std::isfinite(moved.real()) && std::isfinite(moved.imag()) &&
        std::abs(moved - eigenvalues[i]) < 1e-6L * std::abs(eigenvalues[i]))
      eigenvalues[i] = moved;
  }
}

void put_in_order(Eigenvalues& eigenvalues) {
  constexpr Long nothing = 1e-60L;  // 0 has no logarithm
  for (auto& eigenvalue : eigenvalues) {
    if (norm1(eigenvalue) < nothing) eigenvalue = -nothing;
  }
  std::ranges::sort(eigenvalues, {}, [](const Value& x) { return std::norm(x); });
}

// Bounds of |p_j - q_j| for the polynomial q whose zeros are the approximate eigenvalues.
template <class Number>
PerRow<double> distances(const QuickAdjugate<Number>& adjugate, const Eigenvalues& eigenvalues) {
  const std::size_t n = eigenvalues.size();
  std::array<Value, max_quick_rows + 1> known{1.0L};  // by descending powers
  std::array<Long, max_quick_rows + 1> sizes{1.0L};
  for (std::size_t i = 0; i < n; ++i) {
    const Value& eigenvalue = eigenvalues[i];
    const Long size = norm1(eigenvalue);
    for (std::size_t j = i + 1; j > 0; --j) {
      known[j] -= eigenvalue * known[j - 1];
      sizes[j] += size * sizes[j - 1];
    }
  }
  PerRow<double> off;
  for (std::size_t j = 0; j < n; ++j) {
    off.push_back(static_cast<double>(norm1(known[n - j] - to_long(to_complex(adjugate.coefficients[j]))) +
                                      adjugate.errors[j] + few_ulps * sizes[n - j]));
  }
  return off;
}

// sum_j distance_j / prod of the n - j largest v_i, v_i = max(|z_i|, least), for zeros z_i by ascending
// modulus.
double relative_distance(const PerRow<double>& distances, const Eigenvalues& zeros, double least) {
  double sum = 0.0, product = 1.0;
  for (std::size_t j = zeros.size(); j-- > 0;) {
    product *= std::max(std::abs(std::complex<double>(zeros[j])), least);
    sum += distances[j] / product;
  }
  return sum;
}

// Approximate eigenvalues by ascending modulus. The eigenvalue solver in double may be too inaccurate for
// small ones beside large ones.
template <class Number>
Eigenvalues eigenvalues_of(const Eigen::MatrixXcd& matrix, const QuickAdjugate<Number>& adjugate) {
  constexpr double near = 1e-11;  // below the clearances of the contours
  constexpr int most_steps = 2;
  const auto& p = adjugate.coefficients;
  if (adjugate.rows == 2) {
    Eigenvalues eigenvalues = zeros_of_square(to_long(to_complex(p[0])), to_long(to_complex(p[1])));
    put_in_order(eigenvalues);
    return eigenvalues;
  }
  Eigenvalues eigenvalues = std::is_same_v<Number, DoubleDouble>
                                ? eigenvalues_by_qr<double, Eigen::EigenSolver>(matrix)
                                : eigenvalues_by_qr<std::complex<double>, Eigen::ComplexEigenSolver>(matrix);
  put_in_order(eigenvalues);
  for (int step = 0;
       step < most_steps && relative_distance(distances(adjugate, eigenvalues), eigenvalues, 0.0) > near;
       ++step) {
    improve(eigenvalues, p);
    put_in_order(eigenvalues);
  }
  return eigenvalues;
}

// Bounds for p on a contour, from its approximate zeros.
class Spectrum {
 public:
  Spectrum(double alpha, Eigenvalues eigenvalues, PerRow<double> distances)
      : alpha_(alpha), eigenvalues_(std::move(eigenvalues)), distances_(std::move(distances)) {
    for (const Value& eigenvalue : eigenvalues_)
      roots_.emplace_back(alpha, std::log(std::complex<double>(eigenvalue)), -max_sheet);
    for (const SingularityRoots& root : roots_) factors_.push_back(root.factor(1.0));
  }

  [[nodiscard]] double growth() const {
    double growth = 0.0;
    for (const SingularityRoots& root : roots_) growth = std::max(growth, root.growth());
    return growth;
  }

  // log of a bound of the discretisation error for s^exponent x^j / p(x), for every j; nullopt where there is
  // none. Smaller ones than `sufficient` are not sought.
  [[nodiscard]] std::optional<double> log_bound(const ShiftedContour& contour, double exponent,
                                                double sufficient) const {
    const double more = alpha_ * (static_cast<double>(eigenvalues_.size()) - 1.0);
    const auto strip = contour.strip.bound_for({.exponent = exponent,
                                                .alpha = alpha_,
                                                .factors = {factors_.data(), factors_.size()},
                                                .exponent_range = more,
                                                .sufficient_log_bound = sufficient});
    if (!strip || strip->outside || !is_near(*strip)) return std::nullopt;
    return strip->log_bound + std::log(2.0);  // |p| >= |q| / 2, and the bound is for q
  }

 private:
  // Whether |p| >= |q| / 2 in the strip and right of it: with v_i = max(|z_i|, least |x|) and the clearance c
  //   |x|^j <= prod_i max(|x|, |z_i|) / prod of the n - j largest v_i
  //         <= |q| / (c prod of the n - j largest v_i).
  [[nodiscard]] bool is_near(const SingularityFreeStrip::Result& strip) const {
    const double least = std::pow(strip.least_size, alpha_);
    return relative_distance(distances_, eigenvalues_, least) <= 0.5 * std::exp(strip.log_clearance);
  }

  double alpha_;
  Eigenvalues eigenvalues_;  // by ascending modulus
  PerRow<double> distances_;
  PerRow<SingularityRoots> roots_;
  PerRow<SingularityFreeStrip::Factor> factors_;
};

// sum_j N_j c_j
template <class Number>
std::vector<QuickValue> combined(const QuickAdjugate<Number>& adjugate,
                                 const std::array<QuotientSum, max_degree>& sums, Long neglected) {
  const std::size_t n = adjugate.rows;
  const double unit = QuickArithmetic<Number>::unit();
  std::vector<QuickValue> entries;
  entries.reserve(n * n);
  for (std::size_t i = 0; i < n * n; ++i) {
    auto value = number_of<Number>(0.0);
    double error = 0.0;
    for (std::size_t j = 0; j < n; ++j) {
      const Number& part = adjugate.parts[j][i];
      const double part_size = magnitude(part) + adjugate.part_errors[j][i];
      value = quick_sum(value, part * as<Number>(sums[j].value));
      error += part_size * (sums[j].error + static_cast<double>(neglected)) +
               (adjugate.part_errors[j][i] + unit * part_size) * magnitude(sums[j].value);
    }
    entries.push_back({to_long(to_complex(value)), error + few_ulps * magnitude(value)});
  }
  return entries;
}

template <class Number>
double log_of_largest_part(const QuickAdjugate<Number>& adjugate) {
  double largest = 0.0;
  for (const auto& part : adjugate.parts) {
    for (const auto& entry : part) largest = std::max(largest, magnitude(entry));
  }
  return std::log(largest);
}

bool all_meet_tolerance(const std::vector<QuickValue>& entries) {
  return std::ranges::all_of(
      entries, [](const QuickValue& x) { return x.error <= quick_tolerance * std::abs(x.value); });
}

// Whether products of as many entries as there are rows neither overflow nor underflow.
bool is_moderate(const Eigen::MatrixXcd& matrix) {
  constexpr double largest = 1e30, smallest = 1e-30;
  const auto good = [](double x) { return x == 0.0 || (std::abs(x) > smallest && std::abs(x) < largest); };
  return std::all_of(matrix.data(), matrix.data() + matrix.size(),
                     [&](const std::complex<double>& x) { return good(x.real()) && good(x.imag()); });
}

std::optional<std::vector<QuickValue>> of_one_row(double alpha, double beta, const std::complex<double>& z) {
  const bool mirrored = z.imag() < 0.0;
  const auto value = mittag_leffler_quick(
      alpha, {beta, 0.0}, mirrored ? std::conj(z) : std::complex(z.real(), std::abs(z.imag())));
  if (!value) return std::nullopt;
  const std::vector<QuickValue> entries{{mirrored ? std::conj(value->value) : value->value, value->error}};
  return all_meet_tolerance(entries) ? std::optional(entries) : std::nullopt;
}

// Number is real where the matrix is.
template <class Number>
std::optional<std::vector<QuickValue>> on_contours(double alpha, double beta,
                                                   const Eigen::MatrixXcd& matrix) {
  constexpr double negligible = 10.0;  // log of max_log_error over a bound that no contour need improve on
  const auto adjugate = adjugate_of<Number>(matrix);
  const Eigenvalues eigenvalues = eigenvalues_of(matrix, adjugate);
  const Spectrum spectrum(alpha, eigenvalues, distances(adjugate, eigenvalues));
  const double most_log = max_log_error + spectrum.growth() - log_of_largest_part(adjugate);
  const DoubleDouble exponent = exact_sum(alpha, -beta);
  PerRow<ComplexDoubleDouble> coefficients;
  for (const Number& coefficient : adjugate.coefficients) coefficients.push_back(to_complex(coefficient));
  for (const ShiftedContour& contour : shifted_contours()) {
    const auto log_bound = spectrum.log_bound(contour, exponent.hi, most_log - negligible);
    if (!log_bound || *log_bound > most_log) continue;
    const auto sums = sum_over_nodes(
        contour.nodes,
        PolynomialQuotient{
            alpha, exponent, {coefficients.data(), adjugate.rows}, {adjugate.errors.data(), adjugate.rows}});
    auto entries = combined(adjugate, sums, std::exp(static_cast<Long>(*log_bound)));
    if (all_meet_tolerance(entries)) return entries;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::vector<QuickValue>> mittag_leffler_matrix_quick(double alpha, double beta,
                                                                   const Eigen::MatrixXcd& matrix) {
  constexpr double most_beta = 40.0;
  if (matrix.rows() == 1) return of_one_row(alpha, beta, matrix(0, 0));
  if (matrix.rows() > max_quick_rows || std::abs(beta) > most_beta || !is_moderate(matrix))
    return std::nullopt;
  return (matrix.imag().array() == 0.0).all() ? on_contours<DoubleDouble>(alpha, beta, matrix)
                                              : on_contours<ComplexDoubleDouble>(alpha, beta, matrix);
}

}  // namespace fde::reference
