#include "symbol.hpp"

#include <vector>

#include "generating_function.hpp"

namespace fde {
namespace {

// The generating functions and step factors of one family in all rows; rows of equal order are evaluated
// once.
class Convolutions {
 public:
  Convolutions(const Problem& problem, WeightFamily family, double length) : factors_(problem.size()) {
    for (Eigen::Index i = 0; i < factors_.size(); ++i) {
      tables_.push_back({family, problem.components[static_cast<std::size_t>(i)].order});
      factors_[i] = step_factor(tables_.back(), length);
    }
  }

  [[nodiscard]] const Vec& step_factors() const { return factors_; }

  // The diagonal of K.
  [[nodiscard]] Eigen::VectorXcd at(ComplexValue log_zeta) const {
    Eigen::VectorXcd values(factors_.size());
    for (Eigen::Index i = 0; i < values.size(); ++i) {
      const auto row = static_cast<std::size_t>(i);
      const bool known = i > 0 && tables_[row] == tables_[row - 1];
      values[i] = known ? values[i - 1] / factors_[i - 1] : kernel(tables_[row], log_zeta);
      values[i] *= factors_[i];
    }
    return values;
  }

 private:
  static ComplexValue kernel(const WeightTable& table, ComplexValue log_zeta) {
    const ComplexValue value = generating_function(table, log_zeta);
    if (table.family != WeightFamily::l1) return value;
    return generating_function({WeightFamily::grunwald_letnikov, 1.0}, log_zeta) / value;
  }

  std::vector<WeightTable> tables_;
  Vec factors_;
};

}  // namespace

Symbol implicit_symbol(const Problem& problem, WeightFamily family, double length) {
  return [rule = Convolutions(problem, family, length),
          a = ComplexMatrix(problem.linear_part.value())](ComplexValue log_zeta) {
    const Eigen::VectorXcd k = rule.at(log_zeta);
    return ComplexMatrix(ComplexMatrix::Identity(a.rows(), a.cols()) - k.asDiagonal() * a);
  };
}

Symbol predictor_corrector_symbol(const Problem& problem, double length) {
  return [predictor = Convolutions(problem, WeightFamily::rectangle, length),
          corrector = Convolutions(problem, WeightFamily::trapezoid, length),
          a = ComplexMatrix(problem.linear_part.value())](ComplexValue log_zeta) {
    const Eigen::VectorXcd newest = corrector.step_factors().cast<ComplexValue>();
    const Eigen::VectorXcd past = corrector.at(log_zeta) - newest, b = predictor.at(log_zeta);
    const ComplexMatrix predicted = a * b.asDiagonal() * a;
    return ComplexMatrix(ComplexMatrix::Identity(a.rows(), a.cols()) - past.asDiagonal() * a -
                         newest.asDiagonal() * predicted);
  };
}

}  // namespace fde
