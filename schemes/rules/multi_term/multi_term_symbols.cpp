// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/multi_term/multi_term_symbols.hpp"

#include <Eigen/LU>
#include <vector>

#include "fdebench/schemes/history/symbols/generating_function.hpp"
#include "fdebench/schemes/rules/multi_term/integrated_equations.hpp"

namespace fde {
namespace {

// kappa_v of the integrals of order L - v on equal steps, and K_v (1-zeta)^L.
class Integrals {
 public:
  Integrals(const Chain& chain, const WeightFamily& family, double length)
      : nodes_(chain.nodes()), leading_(chain.leading().order), newest_(chain.size()) {
    for (Eigen::Index i = 0; i < newest_.size(); ++i) {
      tables_.push_back({&family, leading_ - nodes_[static_cast<std::size_t>(i)]});
      newest_[i] = step_factor(tables_.back(), length);
    }
  }
  [[nodiscard]] const Vec& newest() const { return newest_; }
  [[nodiscard]] ComplexValue leading_power(ComplexValue log_zeta) const {
    return difference_power(leading_, log_zeta);
  }
  [[nodiscard]] Eigen::VectorXcd at(ComplexValue log_zeta) const {
    Eigen::VectorXcd values(newest_.size());
    for (std::size_t i = 0; i < tables_.size(); ++i) {
      values[static_cast<Eigen::Index>(i)] = newest_[static_cast<Eigen::Index>(i)] *
                                             difference_power(nodes_[i], log_zeta) *
                                             regular_part(tables_[i], log_zeta);
    }
    return values;
  }

 private:
  std::vector<double> nodes_;
  double leading_;
  std::vector<WeightTable> tables_;
  Vec newest_;
};

// The linear equations of a problem.
class LinearEquations {
 public:
  LinearEquations(const Problem& problem, const WeightFamily& family, double length)
      : rows_(integrated_rows(problem)) {
    for (const auto& chain : chains_of(problem)) {
      integrals_.emplace_back(chain, family, length);
      ratios_.emplace_back(chain.coefficients() / chain.leading().coefficient);
      first_.push_back(chain.first_row());
    }
  }

  [[nodiscard]] Eigen::Index size() const { return std::ssize(integrals_); }

  // D (1-zeta)^L of every equation, and (1-zeta)^L.
  [[nodiscard]] Eigen::VectorXcd denominators(ComplexValue log_zeta) const {
    Eigen::VectorXcd values = leading_powers(log_zeta);
    for (Eigen::Index e = 0; e < size(); ++e)
      values[e] += ratios(e).cast<ComplexValue>().dot(integrals(e).at(log_zeta));
    return values;
  }
  [[nodiscard]] Eigen::VectorXcd leading_powers(ComplexValue log_zeta) const {
    Eigen::VectorXcd values(size());
    for (Eigen::Index e = 0; e < size(); ++e) values[e] = integrals(e).leading_power(log_zeta);
    return values;
  }
  // sum_v B_v K_v (1-zeta)^L, and sum_v B_v kappa_v.
  [[nodiscard]] ComplexMatrix jacobian_times_integrals(ComplexValue log_zeta) const {
    ComplexMatrix result(size(), size());
    for (Eigen::Index e = 0; e < size(); ++e) result.col(e) = block(e) * integrals(e).at(log_zeta);
    return result;
  }
  [[nodiscard]] ComplexMatrix newest() const {
    ComplexMatrix result(size(), size());
    for (Eigen::Index e = 0; e < size(); ++e)
      result.col(e) = block(e) * integrals(e).newest().cast<ComplexValue>();
    return result;
  }
  // 1 + sum_k c_k/a kappa_k
  [[nodiscard]] Eigen::VectorXcd newest_denominators() const {
    Eigen::VectorXcd values(size());
    for (Eigen::Index e = 0; e < size(); ++e) values[e] = 1.0 + ratios(e).dot(integrals(e).newest());
    return values;
  }

 private:
  // The derivatives of g / a, a row an equation.
  static Matrix integrated_rows(const Problem& problem) {
    Matrix all(problem.size(), problem.size());
    const Problem rows = integrated_problem(problem);
    evaluate_jacobian(rows, 0.0, Vec::Zero(problem.size()), all);
    Matrix firsts(std::ssize(problem.equations), problem.size());
    for (Eigen::Index e = 0; e < firsts.rows(); ++e)
      firsts.row(e) = all.row(problem.equations[static_cast<std::size_t>(e)].first_row);
    return firsts;
  }
  [[nodiscard]] const Integrals& integrals(Eigen::Index e) const {
    return integrals_[static_cast<std::size_t>(e)];
  }
  [[nodiscard]] const Vec& ratios(Eigen::Index e) const { return ratios_[static_cast<std::size_t>(e)]; }
  [[nodiscard]] ComplexMatrix block(Eigen::Index e) const {
    return rows_.middleCols(first_[static_cast<std::size_t>(e)], ratios(e).size()).cast<ComplexValue>();
  }

  Matrix rows_;
  std::vector<Integrals> integrals_;
  std::vector<Vec> ratios_;
  std::vector<Eigen::Index> first_;
};

}  // namespace

Symbol implicit_multi_term_symbol(const Problem& problem, const WeightFamily& family, double length) {
  return [equations = LinearEquations(problem, family, length)](ComplexValue log_zeta) {
    ComplexMatrix s = -equations.jacobian_times_integrals(log_zeta);
    s.diagonal() += equations.denominators(log_zeta);
    return s;
  };
}

Symbol predicted_multi_term_symbol(const Problem& problem, double length) {
  const LinearEquations equations(problem, families::trapezoid, length);
  const ComplexMatrix newest = equations.newest();
  const ComplexMatrix unit = ComplexMatrix::Identity(newest.rows(), newest.cols());
  const ComplexMatrix b = newest * equations.newest_denominators().cwiseInverse().asDiagonal();
  return [=](ComplexValue log_zeta) {
    const ComplexValue zeta = std::exp(log_zeta);
    const Eigen::VectorXcd own = equations.denominators(log_zeta),
                           powers = equations.leading_powers(log_zeta);
    // C times 1 + b, as C and b commute.
    const ComplexMatrix predicted = unit + zeta * (2.0 - zeta) * b;
    ComplexMatrix s = newest * powers.asDiagonal() - equations.jacobian_times_integrals(log_zeta);
    s.diagonal() += own;
    s *= unit + b;
    if (own.size() == 1) return ComplexMatrix(s - newest * predicted * powers.asDiagonal());
    const ComplexMatrix corrected = (unit + b).partialPivLu().solve(predicted);
    s -= newest * powers.cwiseQuotient(own).asDiagonal() * corrected * own.asDiagonal() * (unit + b);
    return s;
  };
}

}  // namespace fde
