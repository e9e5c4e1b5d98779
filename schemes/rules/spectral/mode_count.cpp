// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/spectral/mode_count.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <vector>

#include "fdebench/schemes/history/symbols/generating_function.hpp"

namespace fde {
namespace {

// The largest |arg s| of a mode that counts as growing: undamped oscillations, on the imaginary axis, do not.
constexpr double widest_angle = 0.5 * std::numbers::pi - 1e-3;

// log det(1 - diag(s^-orders) jacobian), without the 1 in algebraic rows; s = e^log_s. For large |s| the
// determinant tends to 1, or to a power of s where there are algebraic rows.
ComplexValue log_characteristic(const Matrix& jacobian, const Vec& orders, ComplexValue log_s) {
  ComplexMatrix matrix = ComplexMatrix::Identity(orders.size(), orders.size());
  for (Eigen::Index i = 0; i < orders.size(); ++i)
    matrix.row(i) -= std::exp(-orders[i] * log_s) * jacobian.row(i);
  for (Eigen::Index i = 0; i < orders.size(); ++i) {
    if (orders[i] == 0.0) matrix(i, i) -= 1.0;
  }
  return log_determinant(matrix);
}

// The log |s| from which on the determinant is a power of s, judged by its slopes at two distances; NaN:
// none.
double power_from(const Matrix& jacobian, const Vec& orders, double log_s) {
  constexpr double straight = 0.02, most = 300.0;  // change of d log |det| / d log s; largest log s
  const auto slope = [&](double at) {
    return (log_characteristic(jacobian, orders, at + 1.0) - log_characteristic(jacobian, orders, at)).real();
  };
  for (; log_s < most; log_s += 1.0) {
    if (std::abs(slope(log_s + 2.0) - slope(log_s)) < straight) return log_s;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

// The path is an arc round 0 from the real axis, a ray next to the imaginary axis up to where the identity
// dominates the other entries of each row, or the determinant is a power of s, and an arc back to the real
// axis: at both ends the determinant is real. With its mirror image the path encloses the modes. Each of them
// adds a full turn to the argument of the determinant, half of it on this path. A step turns the powers of s
// of all rows by less than half a turn together.
bool block_grows_faster(const Matrix& jacobian, const Vec& orders, double rate) {
  using namespace std::complex_literals;
  // In a step, in radians: what a row turns, what all rows turn; times the other entries of a row.
  constexpr double turn = 0.3, turn_of_all = 2.5, clear = 1.01;
  constexpr double most_steps = 1e4;
  const double first = std::log(rate), largest = orders.maxCoeff();
  double last = first;
  for (Eigen::Index i = 0; i < orders.size(); ++i) {
    const double others = clear * jacobian.row(i).cwiseAbs().sum();
    if (others > 0.0 && orders[i] > 0.0) last = std::max(last, std::log(others) / orders[i]);
  }
  if (orders.minCoeff() == 0.0) last = power_from(jacobian, orders, last);
  if (last <= first) return false;
  const double per_length = std::max(largest / turn, orders.sum() / turn_of_all);
  if (!((last - first) * per_length < most_steps)) return true;
  auto before = log_characteristic(jacobian, orders, first);
  double turned = 0.0;
  const auto go = [&](ComplexValue from, ComplexValue to) {
    const auto steps = static_cast<int>(std::ceil(std::abs(to - from) * per_length));
    for (int k = 1; k <= steps; ++k) {
      const auto now =
          log_characteristic(jacobian, orders, from + (to - from) * (static_cast<double>(k) / steps));
      turned += std::arg(std::exp(now - before));
      before = now;
    }
  };
  const auto ray = 1i * widest_angle;
  go(first, first + ray);
  go(first + ray, last + ray);
  go(last + ray, last);
  return std::abs(turned) > 0.5 * std::numbers::pi;
}

// The unknowns of each irreducible block: those that depend on each other. The determinant is the product of
// those of the blocks.
std::vector<std::vector<Eigen::Index>> irreducible_blocks(const Matrix& jacobian) {
  const Eigen::Index size = jacobian.rows();
  Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic> reaches = jacobian.array() != 0.0;
  for (Eigen::Index k = 0; k < size; ++k) {
    for (Eigen::Index i = 0; i < size; ++i)
      if (reaches(i, k)) reaches.row(i) = reaches.row(i) || reaches.row(k);
  }
  std::vector<std::vector<Eigen::Index>> blocks;
  std::vector<bool> taken(static_cast<std::size_t>(size));
  for (Eigen::Index i = 0; i < size; ++i) {
    if (taken[static_cast<std::size_t>(i)]) continue;
    auto& block = blocks.emplace_back();
    for (Eigen::Index j = i; j < size; ++j) {
      if (j != i && !(reaches(i, j) && reaches(j, i))) continue;
      block.push_back(j);
      taken[static_cast<std::size_t>(j)] = true;
    }
  }
  return blocks;
}

// A norm of a matrix and its logarithmic norm, which bounds the real parts of the eigenvalues: the largest
// sum of the moduli of a row, or of a column if that is less; in the logarithmic norm the diagonal has its
// sign.
struct Norms {
  double norm, logarithmic;
};
Norms norms_of(const SparseMatrix& matrix) {
  Vec of_row = Vec::Zero(matrix.rows()), of_column = of_row, diagonal = of_row;
  for (Eigen::Index column = 0; column < matrix.outerSize(); ++column) {
    for (SparseMatrix::InnerIterator entry(matrix, column); entry; ++entry) {
      if (entry.row() == column) {
        diagonal[column] += entry.value();
      } else {
        of_row[entry.row()] += std::abs(entry.value());
        of_column[column] += std::abs(entry.value());
      }
    }
  }
  const auto least = [&](const Vec& of_diagonal) {
    return std::min((of_row + of_diagonal).maxCoeff(), (of_column + of_diagonal).maxCoeff());
  };
  return {least(diagonal.cwiseAbs()), least(diagonal)};
}

// An upper bound of the |s| of the zeros in the right half-plane.
double growth_rate_bound(const SparseMatrix& jacobian, double order) {
  const auto [norm, logarithmic_norm] = norms_of(jacobian);
  const bool symmetric = jacobian.isApprox(SparseMatrix(jacobian.transpose()), 0.0);
  if (order > 1.0 && !symmetric) return std::pow(norm, 1.0 / order);
  if (logarithmic_norm <= 0.0) return 0.0;
  const double aside = symmetric ? 1.0 : std::cos(widest_angle * order);
  return std::pow(std::min(norm, logarithmic_norm / aside), 1.0 / order);
}

}  // namespace

bool grows_faster(const Matrix& jacobian, const Vec& orders, double rate) {
  return std::ranges::any_of(irreducible_blocks(jacobian), [&](const auto& block) {
    return block_grows_faster(jacobian(block, block), orders(block), rate);
  });
}

bool grows_faster(const SparseMatrix& jacobian, double order, double rate) {
  constexpr Eigen::Index most_rows = 300;
  if (growth_rate_bound(jacobian, order) <= rate) return false;
  if (jacobian.rows() > most_rows) return true;
  const Matrix dense = jacobian;
  const auto eigenvalues = dense.eigenvalues();
  return std::ranges::any_of(eigenvalues, [&](ComplexValue lambda) {
    return std::abs(std::arg(lambda)) < widest_angle * order &&
           std::pow(std::abs(lambda), 1.0 / order) > rate;
  });
}

}  // namespace fde
