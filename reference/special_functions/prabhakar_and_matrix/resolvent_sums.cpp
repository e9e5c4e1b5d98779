// SPDX-License-Identifier: MIT
#include "fdebench/reference/special_functions/prabhakar_and_matrix/resolvent_sums.hpp"

#include <memory>
#include <utility>

#include "fdebench/reference/special_functions/prabhakar_and_matrix/adjugate.hpp"
#include "fdebench/schemes/problem/progress/progress.hpp"

namespace fde::reference {
namespace {

using Node = EnclosingContour::Node;
using Sums = EnclosedTransform::Sums;

BigReal size_of(const BigReal& x) { return abs(x); }
BigReal size_of(const BigComplex& x) { return norm1(x); }

// Numbers of the adjugate, real or complex.
template <class RealOrComplex>
struct BigArithmetic {
  using Number = RealOrComplex;
  using Size = BigReal;
  template <class T>
  using Entries = std::vector<T>;
  template <class T>
  using Rows = std::vector<T>;

  static BigReal unit() { return 8 * epsilon<BigReal>(); }
  static Number number(double x) { return Number(x); }
  static BigReal size(const Number& x) { return size_of(x); }
  static Number sum(const Number& a, const Number& b) { return a + b; }
  static Number product(const Number& a, const Number& b) { return a * b; }
  static Number quotient(const Number& a, double by) { return a / BigReal(by); }
  static Number negative(const Number& a) { return -a; }
};

// A number with a bound of its error.
struct Uncertain {
  BigComplex value;
  BigReal error;
};

// Sizes of entries relative to the largest one, which is returned beside them.
std::pair<std::vector<BigReal>, BigReal> relative_sizes(const std::vector<BigReal>& sizes) {
  const BigReal largest = *std::ranges::max_element(sizes);
  std::vector<BigReal> relative = sizes;
  if (largest > 0)
    for (BigReal& x : relative) x /= largest;
  return {relative, largest};
}

std::vector<BigReal> product(const std::vector<BigReal>& a, const std::vector<BigReal>& b, std::size_t n) {
  std::vector<BigReal> result(n * n, BigReal(0));
  for (std::size_t i = 0; i < n * n; ++i) {
    for (std::size_t k = 0; k < n; ++k) {
      const BigReal &left = a[i / n * n + k], &right = b[k * n + i % n];
      if (left != 0 && right != 0) result[i] += left * right;
    }
  }
  return result;
}

template <class Number>
class ResolventSums {
 public:
  ResolventSums(BigReal alpha, BigReal beta, std::size_t n, const std::vector<Number>& matrix)
      : alpha_(std::move(alpha)), beta_(std::move(beta)), adjugate_(n, matrix) {
    for (const Number& entry : matrix) sizes_.push_back(size_of(entry));
  }

  // Adds weight s^(alpha-beta) x^j / p(x) for every j.
  void add(const Node& node, Sums& sums) const {
    const std::size_t n = adjugate_.rows;
    sums.resize(n);
    const BigReal unit = epsilon<BigReal>(), log_size = 1 + norm1(node.log_s);
    const BigReal power_error = (4 + 4 * alpha_ * log_size) * unit;  // relative, of x
    const BigComplex x = exp(BigComplex(alpha_ * node.log_s));
    const Uncertain p = polynomial(x, BigReal(power_error * norm1(x)));
    // |p| >= norm1(p) / 1.5, and 1 / (1 - r) <= 2 for r <= 1/2
    const BigReal loss = 3 * p.error / norm1(p.value);
    const bool lost = !(loss < 0.5);
    BigComplex term = node.weight * exp(BigComplex((alpha_ - beta_) * node.log_s)) / p.value;
    BigReal relative = loss + (8 + 4 * norm1(node.s) + (4 * alpha_ + 4 * abs(beta_)) * log_size) * unit;
    for (std::size_t j = 0; j < n; ++j) {
      sums[j].add(term, relative, BigReal(0));
      if (lost) sums[j].error = std::numeric_limits<double>::infinity();
      term *= x;
      relative += power_error + 4 * unit;
    }
  }

  // sum_j N_j sums_j
  [[nodiscard]] Sums finish(const Sums& sums) const {
    const std::size_t n = adjugate_.rows;
    const BigReal unit = BigArithmetic<Number>::unit();
    Sums entries(n * n);
    for (std::size_t i = 0; i < n * n; ++i) {
      report_progress(i, n * n);
      for (std::size_t j = 0; j < n; ++j) {
        const BigReal &own = adjugate_.part_errors[j][i], size = size_of(adjugate_.parts[j][i]);
        if (size == 0 && own == 0) continue;
        entries[i].value += adjugate_.parts[j][i] * sums[j].value;
        entries[i].error += (size + own) * sums[j].error + (own + unit * size) * norm1(sums[j].value);
      }
    }
    set_scales(entries);
    return entries;
  }

 private:
  // p(x) by Horner's rule, for x with an error below `off`.
  [[nodiscard]] Uncertain polynomial(const BigComplex& x, const BigReal& off) const {
    const BigReal unit = 4 * epsilon<BigReal>(), size = norm1(x);
    Uncertain sum{BigComplex(1), BigReal(0)};
    for (std::size_t j = adjugate_.rows; j-- > 0;) {
      const BigComplex product = sum.value * x;
      sum.error = sum.error * (size + off) + norm1(sum.value) * off + adjugate_.errors[j] +
                  unit * (norm1(product) + size_of(adjugate_.coefficients[j]));
      sum.value = product + adjugate_.coefficients[j];
    }
    return sum;
  }

  // |f(A)| (|A| + 1) |f(A)|, with f(A) and A relative to their largest entries, times that of f(A).
  void set_scales(Sums& entries) const {
    const std::size_t n = adjugate_.rows;
    std::vector<BigReal> sizes;
    for (const auto& entry : entries) sizes.push_back(norm1(entry.value));
    const auto [values, largest] = relative_sizes(sizes);
    std::vector<BigReal> between = relative_sizes(sizes_).first;
    for (std::size_t i = 0; i < n * n; i += n + 1) between[i] += 1;
    const std::vector<BigReal> scales = product(product(values, between, n), values, n);
    for (std::size_t i = 0; i < n * n; ++i) entries[i].scale = largest * scales[i];
  }

  BigReal alpha_, beta_;
  Adjugate<BigArithmetic<Number>> adjugate_;
  std::vector<BigReal> sizes_;
};

template <class Number>
EnclosedTransform::Evaluation evaluation_of(const BigReal& alpha, const BigReal& beta,
                                            const BigMatrix& matrix, const std::vector<Number>& entries) {
  const auto sums = std::make_shared<const ResolventSums<Number>>(
      alpha, beta, static_cast<std::size_t>(matrix.size), entries);
  return {.add = [sums](const Node& node, Sums& to) { sums->add(node, to); },
          .finish = [sums](const Sums& of) { return sums->finish(of); }};
}

}  // namespace

EnclosedTransform::Evaluation resolvent_sums(const BigReal& alpha, const BigReal& beta,
                                             const BigMatrix& matrix) {
  if (!matrix.real()) return evaluation_of(alpha, beta, matrix, matrix.entries);
  std::vector<BigReal> entries;
  for (const BigComplex& entry : matrix.entries) entries.push_back(real_part<BigReal>(entry));
  return evaluation_of(alpha, beta, matrix, entries);
}

}  // namespace fde::reference
