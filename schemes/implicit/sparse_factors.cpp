#include "implicit/sparse_factors.hpp"

#include <Eigen/SparseCholesky>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <utility>

namespace fde {
namespace {

using Entries = SparseMatrix::InnerIterator;

class TridiagonalFactors final : public SparseFactors {
 public:
  static constexpr std::string_view id = "tridiagonal";

  explicit TridiagonalFactors(const SparseMatrix& /*matrix*/) {}

  static bool fits(const SparseMatrix& matrix) {
    for (Eigen::Index j = 0; j < matrix.outerSize(); ++j) {
      for (Entries entry(matrix, j); entry; ++entry)
        if (std::abs(entry.row() - j) > 1) return false;
    }
    return true;
  }

  bool factorise(const SparseMatrix& matrix) override {
    take(matrix);
    // No row has more beside its diagonal than there: the pivots are no smaller than what is left of that.
    if (!(inverse_.array().abs() >= below_.array().abs() + above_.array().abs()).all()) return false;
    sign_ = 1;
    for (Eigen::Index i = 0; i < inverse_.size(); ++i) {
      if (i > 0) {
        below_[i] *= inverse_[i - 1];
        inverse_[i] -= below_[i] * above_[i - 1];
      }
      if (inverse_[i] < 0.0) sign_ = -sign_;
      inverse_[i] = 1.0 / inverse_[i];
    }
    return inverse_.allFinite();
  }

  [[nodiscard]] int determinant_sign() override { return sign_; }

  void solve(Vec& b) const override {
    double last = 0.0;
    for (Eigen::Index i = 0; i < b.size(); ++i) b[i] = last = b[i] - below_[i] * last;
    last = 0.0;
    for (Eigen::Index i = b.size() - 1; i >= 0; --i) b[i] = last = (b[i] - above_[i] * last) * inverse_[i];
  }

  [[nodiscard]] std::string_view name() const override { return id; }

 private:
  void take(const SparseMatrix& matrix) {
    below_ = above_ = inverse_ = Vec::Zero(matrix.rows());
    for (Eigen::Index j = 0; j < matrix.outerSize(); ++j) {
      for (Entries entry(matrix, j); entry; ++entry) {
        Vec& line = entry.row() == j ? inverse_ : entry.row() < j ? above_ : below_;
        line[entry.row()] = entry.value();
      }
    }
  }

  Vec below_, above_, inverse_;  // multipliers, entries right of the diagonal, inverse pivots
  int sign_ = 1;
};

bool symmetric(const SparseMatrix& matrix) {
  const SparseMatrix other = matrix.transpose();
  const auto* const values = matrix.valuePtr();
  return std::equal(matrix.outerIndexPtr(), matrix.outerIndexPtr() + matrix.cols() + 1,
                    other.outerIndexPtr()) &&
         std::equal(matrix.innerIndexPtr(), matrix.innerIndexPtr() + matrix.nonZeros(),
                    other.innerIndexPtr()) &&
         std::equal(values, values + matrix.nonZeros(), other.valuePtr());
}

class CholeskyFactors final : public SparseFactors {
 public:
  static constexpr std::string_view id = "cholesky";

  explicit CholeskyFactors(const SparseMatrix& matrix) { factors_.analyzePattern(matrix); }

  static bool fits(const SparseMatrix& matrix) { return symmetric(matrix); }

  bool factorise(const SparseMatrix& matrix) override {
    if (!symmetric(matrix)) return false;
    factors_.factorize(matrix);
    return factors_.info() == Eigen::Success && (factors_.vectorD().array() > 0.0).all() &&
           factors_.vectorD().allFinite();
  }

  [[nodiscard]] int determinant_sign() override { return 1; }

  void solve(Vec& b) const override {
    ordered_ = factors_.permutationP() * b;
    factors_.matrixL().solveInPlace(ordered_);
    ordered_.array() /= factors_.vectorD().array();
    factors_.matrixU().solveInPlace(ordered_);
    b = factors_.permutationPinv() * ordered_;
  }

  [[nodiscard]] std::string_view name() const override { return id; }

 private:
  Eigen::SimplicialLDLT<SparseMatrix> factors_;
  mutable Vec ordered_;
};

class LuFactors final : public SparseFactors {
 public:
  static constexpr std::string_view id = "lu";

  explicit LuFactors(const SparseMatrix& matrix) { factors_.analyzePattern(matrix); }

  static bool fits(const SparseMatrix& /*matrix*/) { return true; }

  bool factorise(const SparseMatrix& matrix) override {
    if (!matrix.coeffs().allFinite()) return false;
    factors_.factorize(matrix);
    return factors_.info() == Eigen::Success;
  }

  [[nodiscard]] int determinant_sign() override { return static_cast<int>(factors_.signDeterminant()); }
  void solve(Vec& b) const override { b = factors_.solve(b).eval(); }
  [[nodiscard]] std::string_view name() const override { return id; }

 private:
  Eigen::SparseLU<SparseMatrix> factors_;
};

template <class Method>
std::unique_ptr<SparseFactors> factors_by(const SparseMatrix& matrix, std::string_view name) {
  if (!(name.empty() || name == Method::id) || !Method::fits(matrix)) return nullptr;
  auto factors = std::make_unique<Method>(matrix);
  return factors->factorise(matrix) ? std::move(factors) : nullptr;
}

}  // namespace

std::unique_ptr<SparseFactors> sparse_factors(const SparseMatrix& matrix, std::string_view name) {
  if (auto factors = factors_by<TridiagonalFactors>(matrix, name)) return factors;
  if (auto factors = factors_by<CholeskyFactors>(matrix, name)) return factors;
  return factors_by<LuFactors>(matrix, name);
}

}  // namespace fde
