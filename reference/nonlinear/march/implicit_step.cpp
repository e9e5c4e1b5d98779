// SPDX-License-Identifier: MIT
#include "fdebench/reference/nonlinear/march/implicit_step.hpp"

#include <Eigen/LU>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace fde::reference {

namespace {

Vec masses(const Problem& problem) {
  Vec mass = Vec::Ones(problem.size());
  mass(algebraic_rows(problem)).setZero();
  return mass;
}

// Calls entry(row, column, value) for the entries of mass - W df/dy that are not 0 by the structure of df/dy,
// column by column.
template <class Entry>
void for_each_entry(const LinearisedStep& step, const std::vector<Matrix>& weights, const Entry& entry) {
  const auto nodes = std::ssize(step.jacobians), size = step.mass.size();
  for (Eigen::Index l = 0; l < size; ++l) {
    for (Eigen::Index k = 0; k < nodes; ++k) {
      const auto column = step.jacobians[static_cast<std::size_t>(k)].col(l);
      for (Eigen::Index i = 0; i < size; ++i) {
        if (column[i] == 0.0 && i != l) continue;
        const auto weight = weights[static_cast<std::size_t>(i)].col(k);
        for (Eigen::Index m = 0; m < nodes; ++m) {
          const double mass = i == l && m == k ? step.mass[i] : 0.0;
          entry(i * nodes + m, l * nodes + k, mass - column[i] * weight[m]);
        }
      }
    }
  }
}

// The largest number of entries of df/dy that are not 0, over all nodes.
Eigen::Index couplings(const std::vector<Matrix>& jacobians) {
  Eigen::Index most = 0;
  for (const Matrix& jacobian : jacobians) most = std::max(most, (jacobian.array() != 0.0).count());
  return most;
}

std::function<Vec(const Vec&)> dense_inverse(const LinearisedStep& step, const std::vector<Matrix>& weights) {
  const auto unknowns = std::ssize(step.jacobians) * step.mass.size();
  Matrix matrix = Matrix::Zero(unknowns, unknowns);
  for_each_entry(step, weights, [&](auto row, auto column, double value) { matrix(row, column) = value; });
  return [lu = Eigen::PartialPivLU<Matrix>(matrix)](const Vec& right) -> Vec { return lu.solve(right); };
}

std::function<Vec(const Vec&)> sparse_inverse(const LinearisedStep& step,
                                              const std::vector<Matrix>& weights) {
  const auto nodes = std::ssize(step.jacobians), unknowns = nodes * step.mass.size();
  Eigen::SparseMatrix<double> matrix(unknowns, unknowns);
  matrix.reserve((couplings(step.jacobians) + step.mass.size()) * nodes * nodes);
  Eigen::Index begun = -1;
  for_each_entry(step, weights, [&](auto row, auto column, double value) {
    for (; begun < column; ++begun) matrix.startVec(begun + 1);
    matrix.insertBack(row, column) = value;
  });
  matrix.finalize();
  const auto lu = std::make_shared<Eigen::SparseLU<Eigen::SparseMatrix<double>>>(matrix);
  if (lu->info() != Eigen::Success) {
    return [](const Vec& right) -> Vec {
      return Vec::Constant(right.size(), std::numeric_limits<double>::quiet_NaN());
    };
  }
  return [lu](const Vec& right) -> Vec { return lu->solve(right); };
}

}  // namespace

LinearisedStep::LinearisedStep(const Problem& problem, const std::vector<Matrix>& weights,
                               std::vector<Matrix> of_nodes)
    : jacobians(std::move(of_nodes)), mass(masses(problem)) {
  constexpr Eigen::Index many = 10;  // components, from which on elimination of sparse matrices is quicker
  const bool is_sparse = mass.size() >= many && 4 * couplings(jacobians) < mass.size() * mass.size();
  inverse = is_sparse ? sparse_inverse(*this, weights) : dense_inverse(*this, weights);
}

Matrix LinearisedStep::solve(const Matrix& residual) const {
  return inverse(residual.reshaped()).reshaped(residual.rows(), residual.cols());
}

Matrix LinearisedStep::terms_of(const Matrix& y_size) const {
  Matrix terms(y_size.rows(), y_size.cols());
  for (Eigen::Index k = 0; k < y_size.rows(); ++k) {
    terms.row(k) = y_size.row(k) * jacobians[static_cast<std::size_t>(k)].cwiseAbs().transpose();
  }
  return terms;
}

Matrix residual_of(const Problem& problem, const Matrix& next, const Matrix& y, const Matrix& rhs) {
  Matrix residual = next - y;
  for (const auto i : algebraic_rows(problem)) residual.col(i) = rhs.col(i);
  return residual;
}

Noise propagated_noise(const LinearisedStep& step, const std::function<Matrix(const Matrix& rhs)>& integral,
                       const Matrix& y, const Matrix& rhs, In further,
                       Matrix (*with_signs)(const Matrix& sizes)) {
  constexpr double rounding = std::numeric_limits<double>::epsilon();
  const Matrix y_size = y.cwiseAbs();
  const Matrix rhs_size = (rhs.cwiseAbs() + step.terms_of(y_size)).rowwise() + further.transpose();
  const Matrix of_rhs = with_signs(rounding * rhs_size);
  const Matrix of_y =
      step.solve(with_signs(rounding * y_size) * step.mass.asDiagonal() + integral(of_rhs)).cwiseAbs();
  return {of_y.colwise().maxCoeff(), (of_rhs.cwiseAbs() + step.terms_of(of_y)).colwise().maxCoeff()};
}

double first_part(const Problem& problem, const std::vector<Matrix>& weights, const Matrix& jacobian) {
  constexpr double small = 0.1;
  double change = 0.0;
  for (Eigen::Index i = 0; i < jacobian.rows(); ++i) {
    if (problem.is_algebraic(i)) continue;
    const Matrix& weight = weights[static_cast<std::size_t>(i)];
    change =
        std::max(change, jacobian.row(i).cwiseAbs().sum() * weight.cwiseAbs().rowwise().sum().maxCoeff());
  }
  if (!(change > small) || !std::isfinite(change)) return 1.0;
  return std::exp2(-std::ceil(std::log2(change / small)));
}

std::vector<Matrix> reduced(const Problem& problem, std::vector<Matrix> weights, double part) {
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (!is_algebraic(problem.components[i])) weights[i] *= part;
  return weights;
}

Vec unit_increment(const Problem& problem, double length) {
  Vec increment(problem.size());
  for (Eigen::Index i = 0; i < problem.size(); ++i) {
    const double order = problem.component(i).order;
    increment[i] = std::pow(length, order) / std::tgamma(order + 1.0);
  }
  return increment;
}

}  // namespace fde::reference
