// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <variant>

#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

// How a problem gives df/dy, a size() x size() matrix. With NoDerivatives implicit schemes use differences of
// the right-hand side. The sparse forms are for problems in which most entries are 0; precondition: all rows
// have left derivatives.
struct NoDerivatives {};
struct DenseJacobian {
  std::function<void(double t, In y, OutMatrix jacobian)> at;
};
struct SparseJacobian {
  std::function<void(double t, In y, SparseMatrix& jacobian)> at;
};
// The constant matrix A of f(t, y) = A y + b(t): a scheme factorises once.
struct DenseLinearPart {
  Matrix matrix;
};
struct SparseLinearPart {
  SparseMatrix matrix;
};

using Derivatives =
    std::variant<NoDerivatives, DenseJacobian, SparseJacobian, DenseLinearPart, SparseLinearPart>;

}  // namespace fde
