#include "implicit/dense_newton_matrix.hpp"

#include "implicit/differences.hpp"

namespace fde {
namespace {

// x with A x = b in place of b. Most problems have a few components, where a size known to the compiler saves
// most of the time.
template <int size>
void solve_fixed(const Matrix& a, Vec& b) {
  const Eigen::Map<const Eigen::Matrix<double, size, size>> fixed(a.data());
  Eigen::Map<Eigen::Matrix<double, size, 1>> x(b.data());
  x = fixed.partialPivLu().solve(x).eval();
}

}  // namespace

DenseNewtonMatrix::DenseNewtonMatrix(const Problem& problem)
    : problem_(problem), rows_(problem), matrix_(problem.size(), problem.size()) {}

void DenseNewtonMatrix::linearise(Run& run, const StepEquations& step, In y, In f) {
  if (!evaluate_jacobian(problem_, step.t, y, matrix_)) {
    const Vec sizes =
        step.past.cwiseAbs().cwiseMax(step.kappa.cwiseProduct(f).cwiseAbs()).cwiseProduct(rows_.mass);
    difference_rhs(run, step.t, y, f, sizes, matrix_);
  }
  assemble(step.kappa);
}

bool DenseNewtonMatrix::factorise_linear(const Vec& kappa) {
  matrix_ = std::get<DenseLinearPart>(problem_.derivatives).matrix;
  assemble(kappa);
  factorise();
  return rows_.algebraic.empty() || !singular();
}

int DenseNewtonMatrix::determinant_sign() {
  const double signs = factors_.matrixLU().diagonal().array().sign().prod();
  return static_cast<int>(signs) * static_cast<int>(factors_.permutationP().determinant());
}

void DenseNewtonMatrix::assemble(const Vec& kappa) {
  rows_.scale = kappa;
  for (const auto i : rows_.algebraic) rows_.scale[i] = 1.0 / matrix_.row(i).lpNorm<Eigen::Infinity>();
  for (Eigen::Index j = 0; j < matrix_.cols(); ++j) {
    for (Eigen::Index i = 0; i < matrix_.rows(); ++i) matrix_(i, j) *= -rows_.scale[i];
    matrix_(j, j) += rows_.mass[j];
  }
  for (const auto i : rows_.algebraic) rows_.weight[i] = matrix_.col(i).lpNorm<Eigen::Infinity>();
}

void DenseNewtonMatrix::factorise_and_solve(Vec& b) {
  switch (b.size()) {
    case 1:
      b /= matrix_(0, 0);
      return;
    case 2:
      return solve_fixed<2>(matrix_, b);
    case 3:
      return solve_fixed<3>(matrix_, b);
    case 4:
      return solve_fixed<4>(matrix_, b);
    default:
      b = matrix_.partialPivLu().solve(b).eval();
  }
}

void DenseNewtonMatrix::solve(Vec& b) const {
  b.applyOnTheLeft(factors_.permutationP());
  factors_.matrixLU().triangularView<Eigen::UnitLower>().solveInPlace(b);
  factors_.matrixLU().triangularView<Eigen::Upper>().solveInPlace(b);
}

bool DenseNewtonMatrix::singular() const {
  constexpr double rounding = 1e-14;
  Matrix a = matrix_;
  const Vec rows = a.rowwise().lpNorm<Eigen::Infinity>();
  a.array().colwise() /= rows.array();
  const Eigen::RowVectorXd columns = a.colwise().lpNorm<Eigen::Infinity>();
  a.array().rowwise() /= columns.array();
  Eigen::FullPivLU<Matrix> factors(a);
  factors.setThreshold(rounding);
  return !factors.isInvertible();
}

}  // namespace fde
