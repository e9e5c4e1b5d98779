// SPDX-License-Identifier: MIT
#include "fdebench/reference/nonlinear/march/implicit_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace fde::reference {

namespace {

Vec masses(const Problem& problem) {
  Vec mass = Vec::Ones(problem.size());
  mass(algebraic_rows(problem)).setZero();
  return mass;
}

Matrix newton_matrix(const Vec& mass, const std::vector<Matrix>& weights,
                     const std::vector<Matrix>& jacobians) {
  const auto nodes = std::ssize(jacobians), size = std::ssize(weights);
  Matrix matrix = Matrix::Zero(nodes * size, nodes * size);
  for (Eigen::Index i = 0; i < size; ++i) matrix.diagonal().segment(i * nodes, nodes).setConstant(mass[i]);
  for (Eigen::Index k = 0; k < nodes; ++k) {
    const Matrix& jacobian = jacobians[static_cast<std::size_t>(k)];
    for (Eigen::Index i = 0; i < size; ++i) {
      for (Eigen::Index l = 0; l < size; ++l) {
        if (jacobian(i, l) != 0.0) {
          matrix.block(i * nodes, l * nodes + k, nodes, 1) -=
              jacobian(i, l) * weights[static_cast<std::size_t>(i)].col(k);
        }
      }
    }
  }
  return matrix;
}

}  // namespace

LinearisedStep::LinearisedStep(const Problem& problem, const std::vector<Matrix>& weights,
                               std::vector<Matrix> of_nodes)
    : jacobians(std::move(of_nodes)),
      newton(newton_matrix(masses(problem), weights, jacobians)),
      mass(masses(problem)) {}

Matrix LinearisedStep::solve(const Matrix& residual) const {
  return newton.solve(residual.reshaped()).reshaped(residual.rows(), residual.cols());
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
