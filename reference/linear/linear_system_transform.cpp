// SPDX-License-Identifier: MIT
#include "fdebench/reference/linear/linear_system_transform.hpp"

#include "fdebench/reference/linear/transfer_functions/determinant.hpp"

namespace fde::reference {
namespace {

// The matrix diag(s^g) - A of (diag(s^g) - A) X = R, R_j = sum_k s^(g_j-1-k) x_j^(k)(0) + sum of loads c
// Gamma(power+1) s^(-power-1). By Cramer's rule X_i = N_i / P, where P is the determinant and N_i the
// determinant with R in column i.
PolynomialMatrix matrix_of(const ExactLinearSystem& system) {
  const std::size_t size = system.orders.size();
  PolynomialMatrix matrix(size, std::vector<GeneralizedPolynomial>(size));
  for (std::size_t i = 0; i < size; ++i) {
    add_term(matrix[i][i], system.orders[i], Rational(1));
    for (std::size_t j = 0; j < size; ++j) add_term(matrix[i][j], 0, Rational(-system.matrix[i][j]));
  }
  return matrix;
}

// R for each time at which a load starts, 0 first.
struct RightSide {
  Rational from;
  std::vector<GeneralizedPolynomial> rows;
};

std::vector<RightSide> right_sides(const ExactLinearSystem& system) {
  const std::size_t size = system.orders.size();
  std::vector<RightSide> sides{{0, std::vector<GeneralizedPolynomial>(size)}};
  for (std::size_t j = 0; j < size; ++j) {
    for (std::size_t k = 0; k < system.initial[j].size(); ++k)
      add_term(sides.front().rows[j], Rational(system.orders[j] - 1 - k), system.initial[j][k]);
    for (const auto& [coefficient, power, from, over_gamma] : system.loads[j]) {
      const Rational next = power + 1;
      auto side = std::ranges::find(sides, from, &RightSide::from);
      if (side == sides.end()) side = sides.insert(side, {from, std::vector<GeneralizedPolynomial>(size)});
      add_term(side->rows[j], Rational(-next), coefficient_of_gamma(over_gamma ? Rational(1) : next),
               coefficient);
    }
  }
  return sides;
}

}  // namespace

LinearTransform transform_of(const ExactLinearSystem& system) {
  const PolynomialMatrix matrix = matrix_of(system);
  LinearTransform transform;
  transform.generators = system.orders;
  transform.characteristic = determinant(matrix);
  for (const auto& [from, rows] : right_sides(system)) {
    auto& numerators = transform.group_at(from, system.outputs.size()).numerators;
    for (std::size_t k = 0; k < system.outputs.size(); ++k) {
      PolynomialMatrix replaced = matrix;
      for (std::size_t j = 0; j < rows.size(); ++j) replaced[j][system.outputs[k]] = rows[j];
      numerators[k] = determinant(replaced);
    }
  }
  return transform;
}

bool is_regular(const ExactLinearSystem& system) { return !determinant(matrix_of(system)).empty(); }

}  // namespace fde::reference
