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

namespace fde::reference {
namespace {

using Long = long double;
using Value = std::complex<Long>;
template <class T>
using Small = boost::container::static_vector<T, std::size_t{max_quick_rows} * std::size_t{max_quick_rows}>;

// Upper bound of the error of an operation in double-double, relative to the sizes of its operands.
constexpr double double_double_unit = 0x1p-98;

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

ComplexDoubleDouble operator+(const ComplexDoubleDouble& a, const ComplexDoubleDouble& b) {
  return {a.re + b.re, a.im + b.im};
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

template <class Number>
Number number_of(const std::complex<double>& x) {
  if constexpr (std::is_same_v<Number, DoubleDouble>) {
    return {x.real(), 0.0};
  } else {
    return {{x.real(), 0.0}, {x.imag(), 0.0}};
  }
}

// The N_j and the coefficients of p(x) = det(x - A), by ascending powers without the leading 1, with their
// errors.
struct Adjugate {
  int rows;
  std::vector<Small<ComplexDoubleDouble>> parts;
  std::vector<Small<double>> part_errors;
  std::vector<ComplexDoubleDouble> coefficients;
  std::vector<double> errors;
};

// N_{n-1} = I,  p_j = -tr(A N_j) / (n - j),  N_{j-1} = A N_j + p_j.
template <class Number>
Adjugate adjugate_of(const Eigen::MatrixXcd& matrix) {
  const auto n = static_cast<std::size_t>(matrix.rows());
  Small<Number> a, part;
  Small<double> sizes, error(n * n, 0.0);
  for (std::size_t i = 0; i < n * n; ++i) {
    const auto entry = matrix(static_cast<int>(i / n), static_cast<int>(i % n));
    a.push_back(number_of<Number>(entry));
    sizes.push_back(magnitude(a.back()));
    part.push_back(number_of<Number>(i % (n + 1) == 0 ? 1.0 : 0.0));
  }
  Adjugate result{static_cast<int>(n), std::vector<Small<ComplexDoubleDouble>>(n),
                  std::vector<Small<double>>(n), std::vector<ComplexDoubleDouble>(n), std::vector<double>(n)};
  for (std::size_t j = n; j-- > 0;) {
    for (const Number& entry : part) result.parts[j].push_back(to_complex(entry));
    result.part_errors[j] = error;
    Small<Number> product(n * n, number_of<Number>(0.0));
    Small<double> product_error(n * n, 0.0);
    auto trace = number_of<Number>(0.0);
    double trace_error = 0.0;
    for (std::size_t i = 0; i < n * n; ++i) {
      for (std::size_t k = 0; k < n; ++k) {
        const std::size_t left = i / n * n + k, right = k * n + i % n;
        if (sizes[left] == 0.0) continue;
        product[i] = product[i] + a[left] * part[right];
        product_error[i] += sizes[left] * (error[right] + double_double_unit * magnitude(part[right]));
      }
      if (i % (n + 1) != 0) continue;
      trace = trace + product[i];
      trace_error += product_error[i] + double_double_unit * magnitude(product[i]);
    }
    const auto by = static_cast<double>(n - j);
    const Number coefficient = -divided(trace, by);
    const double own = trace_error / by + double_double_unit * magnitude(coefficient);
    result.coefficients[j] = to_complex(coefficient);
    result.errors[j] = own;
    for (std::size_t i = 0; i < n * n; i += n + 1) {
      product[i] = product[i] + coefficient;
      product_error[i] += own + double_double_unit * magnitude(product[i]);
    }
    part = product;
    error = product_error;
  }
  return result;
}

// Zeros of x^2 + linear x + constant, the smaller one without cancellation.
std::vector<Value> zeros_of_square(const Value& constant, const Value& linear) {
  const Value mean = -0.5L * linear, off = std::sqrt(mean * mean - constant);
  const Value larger = std::real(std::conj(mean) * off) < 0.0L ? mean - off : mean + off;
  return {larger == 0.0L ? 0.0L : constant / larger, larger};
}

std::vector<Value> eigenvalues_by_qr(const Eigen::MatrixXcd& matrix) {
  const auto found = Eigen::ComplexEigenSolver<Eigen::MatrixXcd>(matrix, false).eigenvalues().eval();
  return {found.begin(), found.end()};
}

// Approximate eigenvalues by ascending modulus. Two Weierstrass (Durand-Kerner) steps on p improve those that
// are separated beyond the accuracy of the eigenvalue solver in double.
std::vector<Value> eigenvalues_of(const Eigen::MatrixXcd& matrix, const Adjugate& adjugate) {
  const auto n = static_cast<std::size_t>(matrix.rows());
  const auto& p = adjugate.coefficients;
  std::vector<Value> eigenvalues =
      n == 2 ? zeros_of_square(to_long(p[0]), to_long(p[1])) : eigenvalues_by_qr(matrix);
  const int steps = n == 2 ? 0 : 2;
  for (int step = 0; step < steps; ++step) {
    for (std::size_t i = 0; i < n; ++i) {
      Value value = 1.0L, others = 1.0L;
      for (std::size_t j = n; j-- > 0;) value = value * eigenvalues[i] + to_long(p[j]);
      for (std::size_t k = 0; k < n; ++k) others *= k == i ? 1.0L : eigenvalues[i] - eigenvalues[k];
      const Value moved = eigenvalues[i] - value / others;
      if (std::isfinite(moved.real()) && std::isfinite(moved.imag()) &&
          std::abs(moved - eigenvalues[i]) < 1e-6L * std::abs(eigenvalues[i]))
        eigenvalues[i] = moved;
    }
  }
  constexpr Long nothing = 1e-60L;  // 0 has no logarithm
  for (auto& eigenvalue : eigenvalues) {
    if (std::abs(eigenvalue) < nothing) eigenvalue = -nothing;
  }
  std::ranges::sort(eigenvalues, {}, [](const Value& x) { return std::abs(x); });
  return eigenvalues;
}

// Bounds of |p_j - q_j| for the polynomial q whose zeros are the approximate eigenvalues.
std::vector<Long> distances(const Adjugate& adjugate, const std::vector<Value>& eigenvalues) {
  const std::size_t n = eigenvalues.size();
  std::vector<Value> known{1.0L};  // by ascending powers
  std::vector<Long> sizes{1.0L};
  for (const Value& eigenvalue : eigenvalues) {
    known.insert(known.begin(), 0.0L);
    sizes.insert(sizes.begin(), 0.0L);
    for (std::size_t j = 0; j + 1 < known.size(); ++j) {
      known[j] -= eigenvalue * known[j + 1];
      sizes[j] += std::abs(eigenvalue) * sizes[j + 1];
    }
  }
  std::vector<Long> off;
  for (std::size_t j = 0; j < n; ++j) {
    off.push_back(std::abs(known[j] - to_long(adjugate.coefficients[j])) + adjugate.errors[j] +
                  few_ulps * sizes[j]);
  }
  return off;
}

// Bounds for p on a contour, from its approximate zeros.
class Spectrum {
 public:
  Spectrum(double alpha, const Adjugate& adjugate, std::vector<Value> eigenvalues)
      : alpha_(alpha), eigenvalues_(std::move(eigenvalues)), off_(distances(adjugate, eigenvalues_)) {
    for (const Value& eigenvalue : eigenvalues_)
      roots_.emplace_back(alpha, std::complex<double>(std::log(eigenvalue)), -max_sheet);
    for (const SingularityRoots& root : roots_) factors_.push_back(root.factor(1.0));
  }

  [[nodiscard]] double growth() const {
    double growth = 0.0;
    for (const SingularityRoots& root : roots_) growth = std::max(growth, root.growth());
    return growth;
  }

  // log of a bound of the discretisation error for s^exponent x^j / p(x), for every j; nullopt where there is
  // none.
  [[nodiscard]] std::optional<double> log_bound(const ShiftedContour& contour, double exponent) const {
    const double more = alpha_ * (static_cast<double>(eigenvalues_.size()) - 1.0);
    const auto strip = contour.strip.bound_for(
        {.exponent = exponent, .alpha = alpha_, .factors = factors_, .exponent_range = more});
    if (!strip || strip->outside || !is_near(*strip)) return std::nullopt;
    return strip->log_bound + std::log(2.0);  // |p| >= |q| / 2, and the bound is for q
  }

 private:
  // Whether |p| >= |q| / 2 in the strip and right of it: with v_i = max(|z_i|, least |x|) and the clearance c
  //   |x|^j <= prod_i max(|x|, |z_i|) / prod of the n - j largest v_i
  //         <= |q| / (c prod of the n - j largest v_i).
  [[nodiscard]] bool is_near(const SingularityFreeStrip::Result& strip) const {
    const Long least = std::pow(static_cast<Long>(strip.least_size), static_cast<Long>(alpha_));
    Long sum = 0.0L, product = 1.0L;
    for (std::size_t j = eigenvalues_.size(); j-- > 0;) {
      product *= std::max(std::abs(eigenvalues_[j]), least);
      sum += off_[j] / product;
    }
    return sum <= 0.5L * std::exp(static_cast<Long>(strip.log_clearance));
  }

  double alpha_;
  std::vector<Value> eigenvalues_;  // by ascending modulus
  std::vector<Long> off_;
  std::vector<SingularityRoots> roots_;
  std::vector<SingularityFreeStrip::Factor> factors_;
};

// sum_j N_j c_j
std::vector<QuickValue> combined(const Adjugate& adjugate, const std::array<QuotientSum, max_degree>& sums,
                                 Long neglected) {
  const auto n = static_cast<std::size_t>(adjugate.rows);
  std::vector<QuickValue> entries;
  for (std::size_t i = 0; i < n * n; ++i) {
    ComplexDoubleDouble value{{0.0, 0.0}, {0.0, 0.0}};
    Long error = 0.0L;
    for (std::size_t j = 0; j < n; ++j) {
      const ComplexDoubleDouble& part = adjugate.parts[j][i];
      const Long part_size = magnitude(part) + adjugate.part_errors[j][i];
      value = value + part * sums[j].value;
      error += part_size * (sums[j].error + neglected) +
               (adjugate.part_errors[j][i] + double_double_unit * part_size) * magnitude(sums[j].value);
    }
    entries.push_back({to_long(value), error + few_ulps * magnitude(value)});
  }
  return entries;
}

double log_of_largest_part(const Adjugate& adjugate) {
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

}  // namespace

std::optional<std::vector<QuickValue>> mittag_leffler_matrix_quick(double alpha, double beta,
                                                                   const Eigen::MatrixXcd& matrix) {
  constexpr double most_beta = 40.0;
  if (matrix.rows() == 1) return of_one_row(alpha, beta, matrix(0, 0));
  if (matrix.rows() > max_quick_rows || std::abs(beta) > most_beta || !is_moderate(matrix))
    return std::nullopt;
  const bool real = (matrix.imag().array() == 0.0).all();
  const Adjugate adjugate =
      real ? adjugate_of<DoubleDouble>(matrix) : adjugate_of<ComplexDoubleDouble>(matrix);
  const Spectrum spectrum(alpha, adjugate, eigenvalues_of(matrix, adjugate));
  const double most_log = max_log_error + spectrum.growth() - log_of_largest_part(adjugate);
  const DoubleDouble exponent = exact_sum(alpha, -beta);
  for (const ShiftedContour& contour : shifted_contours()) {
    const auto log_bound = spectrum.log_bound(contour, exponent.hi);
    if (!log_bound || *log_bound > most_log) continue;
    const auto sums = sum_over_nodes(
        contour.nodes, PolynomialQuotient{alpha, exponent, adjugate.coefficients, adjugate.errors});
    auto entries = combined(adjugate, sums, std::exp(static_cast<Long>(*log_bound)));
    if (all_meet_tolerance(entries)) return entries;
  }
  return std::nullopt;
}

}  // namespace fde::reference
