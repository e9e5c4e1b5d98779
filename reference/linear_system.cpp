#include "linear_system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "linear_solution.hpp"

namespace fde {
namespace {

constexpr const char* name = "linear system";
constexpr std::size_t most_components = 8;  // the determinant has up to 2^components terms

void require(bool holds, const char* message) {
  if (!holds) throw std::invalid_argument(fmt::format("{}: {}", name, message));
}

LinearSystem checked(LinearSystem system) {
  const std::size_t size = system.orders.size();
  if (size < 1 || size > most_components)
    throw std::invalid_argument(
        fmt::format("{}: {} components: must be 1 to {}", name, size, most_components));
  const auto rows = static_cast<Eigen::Index>(size);
  require(system.matrix.rows() == rows && system.matrix.cols() == rows,
          "the matrix has to have a row and a column for each order");
  require(system.matrix.allFinite(), "coefficients have to be finite");
  require(system.initial.size() == size, "a list of initial values is needed for each order");
  if (system.loads.empty()) system.loads.resize(size);
  require(system.loads.size() == size, "there have to be no loads, or a list of them for each order");
  for (std::size_t i = 0; i < size; ++i) {
    require(system.orders[i] > 0.0 && std::isfinite(system.orders[i]), "orders have to be above 0");
    require(system.initial[i].size() >= initial_count(system.orders[i]), "an initial value is missing");
    system.initial[i].resize(initial_count(system.orders[i]));
    require(std::ranges::all_of(system.initial[i], [](double value) { return std::isfinite(value); }),
            "initial values have to be finite");
    for (const auto& load : system.loads[i]) require(!fault_of(load), fault_of(load).value_or(""));
  }
  return system;
}

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
  explicit Expansion(const LinearSystem& system) : system_(system), size_(system.orders.size()) {
    for (std::size_t i = 0; i < size_; ++i) {
      orders_.push_back(exact_decimal(system.orders[i]));
      negative_.emplace_back();
      for (std::size_t j = 0; j < size_; ++j)
        negative_.back().push_back(
            -exact_decimal(system.matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j))));
    }
  }

  [[nodiscard]] LinearTransform transform() {
    transform_.generators = orders_;
    const unsigned all = (1U << size_) - 1U;
    transform_.characteristic = determinant(orders_, negative_, all);
    transform_.group_from(0, size_);
    for (std::size_t i = 0; i < size_; ++i) {
      for (std::size_t j = 0; j < size_; ++j) {
        RationalMatrix replaced = negative_;
        for (std::size_t row = 0; row < size_; ++row) replaced[row][i] = row == j ? 1 : 0;
        add_numerators(i, j, determinant(orders_, replaced, all & ~(1U << i)));
      }
    }
    return transform_;
  }

 private:
  void add_numerators(std::size_t i, std::size_t j, const GeneralizedPolynomial& cofactor) {
    const auto add = [&](const Rational& from, const Rational& exponent, const Coefficient& factor,
                         const Rational& value) {
      auto& numerator = transform_.group_from(from, size_).numerators[i];
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
  std::size_t size_;
  std::vector<Rational> orders_;
  RationalMatrix negative_;
  LinearTransform transform_;
};

}  // namespace

Exact exact_solution(const LinearSystem& system) {
  return exact_solution(name, [system = checked(system)] { return Expansion(system).transform(); });
}

}  // namespace fde
