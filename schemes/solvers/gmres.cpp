// SPDX-License-Identifier: MIT
#include "fdebench/schemes/solvers/gmres.hpp"

#include <algorithm>
#include <unsupported/Eigen/IterativeSolvers>

#include "fdebench/schemes/problem/progress/progress.hpp"
#include "fdebench/schemes/solvers/unit_of.hpp"

namespace fde {
class LinearOperator;
}  // namespace fde

// Eigen accepts an operator as a matrix that has a size and a product.
template <>
struct Eigen::internal::traits<fde::LinearOperator> : Eigen::internal::traits<Eigen::SparseMatrix<double>> {};

namespace fde {

class LinearOperator : public Eigen::EigenBase<LinearOperator> {
 public:
  using Scalar = double;
  using RealScalar = double;
  using StorageIndex = Eigen::Index;
  static constexpr int ColsAtCompileTime = Eigen::Dynamic, MaxColsAtCompileTime = Eigen::Dynamic;
  static constexpr bool IsRowMajor = false;

  LinearOperator(const std::function<Vec(const Vec&)>& apply, Eigen::Index size)
      : apply_(apply), size_(size) {}
  [[nodiscard]] Eigen::Index rows() const { return size_; }
  [[nodiscard]] Eigen::Index cols() const { return size_; }
  [[nodiscard]] Vec applied(const Vec& x) const {
    report_progress(0);
    return apply_(x);
  }
  template <typename Right>
  Eigen::Product<LinearOperator, Right, Eigen::AliasFreeProduct> operator*(
      const Eigen::MatrixBase<Right>& x) const {
    return {*this, x.derived()};
  }

 private:
  const std::function<Vec(const Vec&)>& apply_;
  Eigen::Index size_;
};

}  // namespace fde

template <typename Right>
struct Eigen::internal::generic_product_impl<fde::LinearOperator, Right, Eigen::SparseShape,
                                             Eigen::DenseShape, Eigen::GemvProduct>
    : generic_product_impl_base<fde::LinearOperator, Right,
                                generic_product_impl<fde::LinearOperator, Right>> {
  template <typename Result>
  // NOLINTNEXTLINE(readability-identifier-naming): the name that Eigen calls
  static void scaleAndAddTo(Result& result, const fde::LinearOperator& left, const Right& right,
                            double factor) {
    result += factor * left.applied(right);
  }
};

namespace fde {

Vec gmres(const std::function<Vec(const Vec&)>& apply, const Vec& b, double tolerance, Eigen::Index most) {
  const LinearOperator matrix(apply, b.size());
  const double unit = unit_of(b);
  const Eigen::Index applications = std::min(most, b.size());
  // Eigen sets all its vectors to 0 before the first application, which can take longer than the solution:
  // few vectors are tried first.
  Eigen::Index vectors = std::min<Eigen::Index>(applications, 16);
  while (true) {
    Eigen::GMRES<LinearOperator, Eigen::IdentityPreconditioner> solver(matrix);
    solver.set_restart(vectors);
    solver.setMaxIterations(vectors);
    solver.setTolerance(tolerance);
    const Vec x = solver.solve(b / unit);
    if (vectors == applications || solver.info() == Eigen::Success) return unit * x;
    vectors = applications;
  }
}

Eigen::Index max_krylov_vectors(Eigen::Index length) {
  constexpr Eigen::Index most_values = 1 << 25;
  return std::min(length, std::clamp<Eigen::Index>(most_values / length, 20, 200));
}

}  // namespace fde
