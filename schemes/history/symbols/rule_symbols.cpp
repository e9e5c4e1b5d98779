// SPDX-License-Identifier: MIT
#include "fdebench/schemes/history/symbols/rule_symbols.hpp"

#include <Eigen/LU>
#include <cmath>
#include <functional>
#include <vector>

#include "fdebench/schemes/history/symbols/delayed_part.hpp"
#include "fdebench/schemes/history/symbols/generating_function.hpp"
#include "fdebench/schemes/problem/delays.hpp"

namespace fde {
namespace {

// (1-zeta)^g K of all rows for one step size; consecutive rows of equal order are evaluated once.
class Convolutions {
 public:
  Convolutions(const Problem& problem, const std::function<Kernel(double order)>& kernel_of, double length)
      : powers_(problem.size()) {
    for (const auto& component : problem.components) {
      const auto row = std::ssize(orders_);
      const bool known = row > 0 && component.order == orders_.back();
      orders_.push_back(component.order);
      kernels_.push_back(known ? kernels_.back() : kernel_of(component.order));
      powers_[row] = std::pow(length, component.order);
    }
  }

  // The diagonal of K, each entry times (1-zeta)^g_i.
  [[nodiscard]] Eigen::VectorXcd at(ComplexValue log_zeta) const {
    const auto values = by_order([&](std::size_t row) { return kernels_[row](log_zeta); });
    return values.cwiseProduct(powers_.cast<ComplexValue>());
  }

  // (1-zeta)^g_i
  [[nodiscard]] Eigen::VectorXcd difference_powers(ComplexValue log_zeta) const {
    return by_order([&](std::size_t row) { return difference_power(orders_[row], log_zeta); });
  }

 private:
  template <class Value>
  [[nodiscard]] Eigen::VectorXcd by_order(const Value& value) const {
    Eigen::VectorXcd values(powers_.size());
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      const auto row = static_cast<std::size_t>(i);
      const bool known = i > 0 && orders_[row] == orders_[row - 1];
      values[i] = known ? values[i - 1] : value(row);
    }
    return values;
  }

  std::vector<double> orders_;
  std::vector<Kernel> kernels_;
  Vec powers_;  // length^g
};

std::function<Kernel(double order)> kernels_of(const WeightFamily& family) {
  return [&family](double order) -> Kernel {
    const WeightTable table{&family, order};
    return [table, factor = step_factor(table, 1.0)](ComplexValue log_zeta) {
      return factor * regular_part(table, log_zeta);
    };
  };
}

// The step factor kappa of every row.
Vec step_factors(const Problem& problem, const WeightFamily& family, double length) {
  return Vec::NullaryExpr(problem.size(), [&](Eigen::Index i) {
    return step_factor({&family, problem.component(i).order}, length);
  });
}

// The part of the problem that looks back, with all matrices changed by `change`.
template <class Change>
DelayedPart delayed_part(const Problem& problem, double length, const Vec& offsets, const Change& change) {
  const Vec zero = Vec::Zero(problem.size());
  auto factors = delayed_jacobians_at(problem, 0.0, zero, [](double, Out y) { y.setZero(); });
  for (auto& one : factors) one = change(one);
  return {problem.delays.lags, factors, length, offsets};
}

ComplexMatrix linear_part(const Problem& problem) {
  Matrix a(problem.size(), problem.size());
  evaluate_jacobian(problem, 0.0, Vec::Zero(problem.size()), a);
  return a.cast<ComplexValue>();
}

}  // namespace

Symbol implicit_symbol(const Problem& problem, const WeightFamily& family, double length) {
  return implicit_symbol(problem, kernels_of(family), length);
}

Symbol implicit_symbol(const Problem& problem, const std::function<Kernel(double order)>& kernel_of,
                       double length, const std::function<double(double order)>& offset_of) {
  const Vec offsets = orders_of(problem).unaryExpr(offset_of);
  return [=, rule = Convolutions(problem, kernel_of, length), a = linear_part(problem),
          delayed = delayed_part(problem, length, offsets, std::identity{})](ComplexValue log_zeta) {
    const Eigen::VectorXcd lines = offsets.unaryExpr(
        [zeta = std::exp(log_zeta)](double offset) { return offset + (1.0 - offset) * zeta; });
    ComplexMatrix s = (-lines).asDiagonal() * a;
    if (!delayed.is_empty()) s -= delayed.at(log_zeta);
    s *= rule.at(log_zeta).asDiagonal();
    s.diagonal() += rule.difference_powers(log_zeta);
    return s;
  };
}

Symbol predictor_corrector_symbol(const Problem& problem, double length) {
  const Convolutions corrector(problem, kernels_of(families::trapezoid), length);
  const ComplexMatrix a = linear_part(problem);
  const Eigen::VectorXcd kappa = step_factors(problem, families::trapezoid, length).cast<ComplexValue>();
  const ComplexMatrix weighted = kappa.asDiagonal() * a;
  // A k A, which does not depend on zeta.
  const ComplexMatrix corrected = a * weighted;
  const Matrix left = Matrix::Identity(a.rows(), a.cols()) + (a * kappa.asDiagonal()).real(),
               right = Matrix::Identity(a.rows(), a.cols()) + weighted.real();
  const DelayedPart delayed =
      delayed_part(problem, length, Vec::Ones(problem.size()), [&](const Matrix& factors) -> Matrix {
        return left * right.transpose().partialPivLu().solve(factors.transpose()).transpose();
      });
  return
      [=, predictor = Convolutions(problem, kernels_of(families::rectangle), length)](ComplexValue log_zeta) {
        const Eigen::VectorXcd powers = corrector.difference_powers(log_zeta);
        const Eigen::VectorXcd newest = kappa.cwiseProduct(powers);
        const Eigen::VectorXcd all = corrector.at(log_zeta), first = predictor.at(log_zeta);
        ComplexMatrix s = -a * (all - newest).asDiagonal() - corrected * first.asDiagonal();
        s.diagonal() += powers;
        if (delayed.is_empty()) return s;
        ComplexMatrix sums = weighted * first.asDiagonal();
        sums.diagonal() += all;
        return ComplexMatrix(s - delayed.at(log_zeta) * sums);
      };
}

}  // namespace fde
