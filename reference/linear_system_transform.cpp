#include "linear_system_transform.hpp"

namespace fde {
namespace {

using RationalMatrix = std::vector<std::vector<Rational>>;

// Of the rows and columns of the mask, by elimination.
Rational principal_minor(const RationalMatrix& matrix, unsigned mask) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < matrix.size(); ++i)
    if ((mask >> i & 1U) != 0U) kept.push_back(i);
  RationalMatrix part;
  for (const std::size_t i : kept) {
    part.emplace_back();
    for (const std::size_t j : kept) part.back().push_back(matrix[i][j]);
  }
  Rational product(1);
  for (std::size_t k = 0; k < part.size(); ++k) {
    std::size_t pivot = k;
    while (pivot < part.size() && part[pivot][k] == 0) ++pivot;
    if (pivot == part.size()) return {0};
    if (pivot != k) {
      std::swap(part[pivot], part[k]);
      product = -product;
    }
    product *= part[k][k];
    for (std::size_t i = k + 1; i < part.size(); ++i) {
      if (part[i][k] == 0) continue;
      const Rational factor = part[i][k] / part[k][k];
      for (std::size_t j = k + 1; j < part.size(); ++j) part[i][j] -= factor * part[k][j];
    }
  }
  return product;
}

// det(diag(s^orders) + matrix), where the components outside the mask have no s on the diagonal:
//   sum over subsets S of the mask of s^(sum of orders in S) times the principal minor of what is not in S.
GeneralizedPolynomial determinant(const std::vector<Rational>& orders, const RationalMatrix& matrix,
                                  unsigned mask) {
  GeneralizedPolynomial sum;
  const unsigned all = (1U << orders.size()) - 1U;
  for (unsigned subset = 0; subset <= all; ++subset) {
    if ((subset & ~mask) != 0U) continue;
    Rational exponent(0);
    for (std::size_t i = 0; i < orders.size(); ++i)
      if ((subset >> i & 1U) != 0U) exponent += orders[i];
    add_term(sum, exponent, principal_minor(matrix, all & ~subset));
  }
  return sum;
}

// (diag(s^g) - A) X = R with R_j = sum_k s^(g_j-1-k) x_j^(k)(0) + sum of loads c Gamma(power+1)
// s^(-power-1) by Cramer's rule: X_i = sum_j R_j C_ij / P, where P is the determinant and C_ij is that with
// the j-th unit vector in column i.
class Expansion {
 public:
  Expansion(const LinearSystem& system, const std::vector<std::size_t>& outputs)
      : system_(system), outputs_(outputs), size_(system.orders.size()) {
    for (std::size_t i = 0; i < size_; ++i) {
      orders_.push_back(exact_decimal(system.orders[i]));
      negative_.emplace_back();
      for (std::size_t j = 0; j < size_; ++j) {
        negative_.back().push_back(
            -exact_decimal(system.matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j))));
      }
    }
  }

  [[nodiscard]] LinearTransform transform() {
    transform_.generators = orders_;
    const unsigned all = (1U << size_) - 1U;
    transform_.characteristic = determinant(orders_, negative_, all);
    transform_.group_from(0, outputs_.size());
    for (std::size_t output = 0; output < outputs_.size(); ++output) {
      const std::size_t i = outputs_[output];
      for (std::size_t j = 0; j < size_; ++j) {
        RationalMatrix replaced = negative_;
        for (std::size_t row = 0; row < size_; ++row) replaced[row][i] = row == j ? 1 : 0;
        add_numerators(output, j, determinant(orders_, replaced, all & ~(1U << i)));
      }
    }
    return transform_;
  }

 private:
  void add_numerators(std::size_t output, std::size_t j, const GeneralizedPolynomial& cofactor) {
    const auto add = [&](const Rational& from, const Rational& exponent, const Coefficient& factor,
                         const Rational& value) {
      auto& numerator = transform_.group_from(from, outputs_.size()).numerators[output];
      for (const auto& [order, coefficient] : cofactor)
        add_term(numerator, Rational(exponent + order), factor, Rational(value * fraction(coefficient)));
    };
    const Coefficient one{{Factor{}, Rational(1)}};
    for (std::size_t k = 0; k < system_.initial[j].size(); ++k)
      add(0, orders_[j] - 1 - k, one, exact_decimal(system_.initial[j][k]));
    for (const auto& [coefficient, power, from] : system_.loads[j]) {
      const Rational next = exact_decimal(power) + 1;
      add(exact_decimal(from), -next, coefficient_of_gamma(next), exact_decimal(coefficient));
    }
  }
  // A coefficient of a determinant is a single fraction.
  static const Rational& fraction(const Coefficient& coefficient) { return coefficient.begin()->second; }

  const LinearSystem& system_;
  const std::vector<std::size_t>& outputs_;
  std::size_t size_;
  std::vector<Rational> orders_;
  RationalMatrix negative_;
  LinearTransform transform_;
};

}  // namespace

LinearTransform transform_of(const LinearSystem& system, const std::vector<std::size_t>& outputs) {
  return Expansion(system, outputs).transform();
}

}  // namespace fde
