#include "implicit/newton_matrix.hpp"

#include <Eigen/SparseLU>
#include <algorithm>
#include <limits>

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
void solve_in_place(const Matrix& a, Vec& b) {
  switch (b.size()) {
    case 1:
      b /= a(0, 0);
      return;
    case 2:
      return solve_fixed<2>(a, b);
    case 3:
      return solve_fixed<3>(a, b);
    case 4:
      return solve_fixed<4>(a, b);
    default:
      b = a.partialPivLu().solve(b).eval();
  }
}

bool same_pattern(const SparseMatrix& a, const SparseMatrix& b) {
  return a.nonZeros() == b.nonZeros() && a.cols() == b.cols() &&
         std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.cols() + 1, b.outerIndexPtr()) &&
         std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
}

}  // namespace

void differentiate(Run& run, const Problem& problem, double t, In y, In f, In sizes, OutMatrix jacobian) {
  if (evaluate_jacobian(problem, t, y, jacobian)) return;
  forward_differences([&](const Vec& shifted) -> const Vec& { return run.rhs(t, shifted); }, y, f, sizes,
                      jacobian);
}

// The order of elimination depends on where the entries are and not on what they are: found once.
struct NewtonMatrix::Sparse {
  explicit Sparse(Eigen::Index size) : identity(size, size), derivatives(size, size) {
    identity.setIdentity();
  }

  void factorise() {
    if (!same_pattern(matrix, analysed)) {
      factors.analyzePattern(matrix);
      analysed = matrix;
    }
    factors.factorize(matrix);
  }

  void solve(Vec& b) const {
    if (factors.info() == Eigen::Success) {
      b = factors.solve(b).eval();
    } else {
      b.setConstant(std::numeric_limits<double>::quiet_NaN());
    }
  }

  SparseMatrix identity, derivatives, matrix, analysed;
  Eigen::SparseLU<SparseMatrix> factors;
};

NewtonMatrix::NewtonMatrix(const Problem& problem) : problem_(problem), mass_(Vec::Ones(problem.size())) {
  for (Eigen::Index i = 0; i < problem.size(); ++i) {
    if (!algebraic(problem.components[static_cast<std::size_t>(i)])) continue;
    algebraic_.push_back(i);
    mass_[i] = 0.0;
  }
  if (sparse(problem)) {
    sparse_ = std::make_unique<Sparse>(problem.size());
  } else {
    dense_.resize(problem.size(), problem.size());
  }
}

NewtonMatrix::~NewtonMatrix() = default;

void NewtonMatrix::update(Run& run, double t, In y, In f, In sizes, Vec& kappa) {
  if (sparse_) {
    std::get<SparseJacobian>(problem_.derivatives).at(t, y, sparse_->derivatives);
  } else {
    differentiate(run, problem_, t, y, f, sizes, dense_);
  }
  assemble(kappa);
}

void NewtonMatrix::update(Vec& kappa) {
  if (sparse_) {
    sparse_->derivatives = std::get<SparseLinearPart>(problem_.derivatives).matrix;
  } else {
    dense_ = std::get<DenseLinearPart>(problem_.derivatives).matrix;
  }
  assemble(kappa);
}

void NewtonMatrix::assemble(Vec& kappa) {
  if (sparse_) {
    sparse_->matrix = sparse_->identity - SparseMatrix(kappa.asDiagonal() * sparse_->derivatives);
    sparse_->matrix.makeCompressed();
    return;
  }
  for (const auto i : algebraic_) kappa[i] = 1.0 / dense_.row(i).lpNorm<Eigen::Infinity>();
  for (Eigen::Index j = 0; j < dense_.cols(); ++j) {
    for (Eigen::Index i = 0; i < dense_.rows(); ++i) dense_(i, j) *= -kappa[i];
    dense_(j, j) += mass_[j];
  }
}

void NewtonMatrix::add_to_diagonal(const Vec& values) {
  if (sparse_) {
    sparse_->matrix.diagonal() += values;
  } else {
    dense_.diagonal() += values;
  }
}

void NewtonMatrix::factorise() {
  if (sparse_) {
    sparse_->factorise();
  } else {
    factors_.compute(dense_);
  }
}

void NewtonMatrix::solve(Vec& b) const {
  if (sparse_) {
    sparse_->solve(b);
  } else {
    b = factors_.solve(b).eval();
  }
}

void NewtonMatrix::factorise_and_solve(Vec& b) {
  if (sparse_) {
    sparse_->factorise();
    sparse_->solve(b);
  } else {
    solve_in_place(dense_, b);
  }
}

bool NewtonMatrix::singular() const {
  constexpr double rounding = 1e-14;
  Matrix a = dense_;
  const Vec rows = a.rowwise().lpNorm<Eigen::Infinity>();
  a.array().colwise() /= rows.array();
  const Eigen::RowVectorXd columns = a.colwise().lpNorm<Eigen::Infinity>();
  a.array().rowwise() /= columns.array();
  Eigen::FullPivLU<Matrix> factors(a);
  factors.setThreshold(rounding);
  return !factors.isInvertible();
}

}  // namespace fde
