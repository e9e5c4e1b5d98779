#include "symbols/symbol.hpp"

#include <vector>

#include "symbols/generating_function.hpp"

namespace fde {
namespace {

// Regular parts and step factors of one family in all rows; rows of equal order are evaluated once.
class Convolutions {
 public:
  Convolutions(const Problem& problem, const WeightFamily& family, double length) : factors_(problem.size()) {
    for (Eigen::Index i = 0; i < factors_.size(); ++i) {
      tables_.push_back({&family, problem.components[static_cast<std::size_t>(i)].order});
      factors_[i] = step_factor(tables_.back(), length);
    }
  }

  [[nodiscard]] const Vec& step_factors() const { return factors_; }

  // The diagonal of K, each entry times (1-zeta)^g_i.
  [[nodiscard]] Eigen::VectorXcd at(ComplexValue log_zeta) const {
    const auto values = by_order([&](const WeightTable& table) { return regular_part(table, log_zeta); });
    return values.cwiseProduct(factors_.cast<ComplexValue>());
  }

  // (1-zeta)^g_i
  [[nodiscard]] Eigen::VectorXcd difference_powers(ComplexValue log_zeta) const {
    return by_order([&](const WeightTable& table) { return difference_power(table.order, log_zeta); });
  }

 private:
  template <class Value>
  [[nodiscard]] Eigen::VectorXcd by_order(const Value& value) const {
    Eigen::VectorXcd values(factors_.size());
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      const auto row = static_cast<std::size_t>(i);
      const bool known = i > 0 && tables_[row] == tables_[row - 1];
      values[i] = known ? values[i - 1] : value(tables_[row]);
    }
    return values;
  }

  std::vector<WeightTable> tables_;
  Vec factors_;
};

ComplexMatrix linear_part(const Problem& problem) {
  Matrix a(problem.size(), problem.size());
  evaluate_jacobian(problem, 0.0, Vec::Zero(problem.size()), a);
  return a.cast<ComplexValue>();
}

}  // namespace

Symbol implicit_symbol(const Problem& problem, const WeightFamily& family, double length) {
  return [rule = Convolutions(problem, family, length), a = linear_part(problem)](ComplexValue log_zeta) {
    ComplexMatrix s = -a * rule.at(log_zeta).asDiagonal();
    s.diagonal() += rule.difference_powers(log_zeta);
    return s;
  };
}

Symbol predictor_corrector_symbol(const Problem& problem, double length) {
  const Convolutions corrector(problem, families::trapezoid, length);
  const ComplexMatrix a = linear_part(problem);
  // A k A, the same at all points.
  const ComplexMatrix corrected = a * corrector.step_factors().cast<ComplexValue>().asDiagonal() * a;
  return [=, predictor = Convolutions(problem, families::rectangle, length)](ComplexValue log_zeta) {
    const Eigen::VectorXcd powers = corrector.difference_powers(log_zeta);
    const Eigen::VectorXcd newest = corrector.step_factors().cast<ComplexValue>().cwiseProduct(powers);
    const Eigen::VectorXcd past = corrector.at(log_zeta) - newest;
    ComplexMatrix s = -a * past.asDiagonal() - corrected * predictor.at(log_zeta).asDiagonal();
    s.diagonal() += powers;
    return s;
  };
}

}  // namespace fde
