// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/implicit/newton_matrix.hpp"

#include "fdebench/schemes/rules/implicit/dense_newton_matrix.hpp"
#include "fdebench/schemes/rules/implicit/sparse_newton_matrix.hpp"

namespace fde {

std::unique_ptr<NewtonMatrix> make_newton_matrix(const Problem& problem) {
  if (has_sparse_jacobian(problem)) return std::make_unique<SparseNewtonMatrix>(problem);
  return std::make_unique<DenseNewtonMatrix>(problem);
}

}  // namespace fde
