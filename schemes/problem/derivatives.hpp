#pragma once

#include <functional>
#include <variant>

#include "problem/vectors.hpp"

namespace fde {

// What a problem tells of df/dy. Implicit schemes difference the right-hand side where it tells nothing. A
// sparse matrix fits where most entries are 0, in problems whose rows all have left derivatives.
struct NoDerivatives {};
struct DenseJacobian {
  std::function<void(double t, In y, OutMatrix jacobian)> at;
};
struct SparseJacobian {
  std::function<void(double t, In y, SparseMatrix& jacobian)> at;
};
// A, where f(t, y) = A y + b(t): a scheme solves with one factorisation.
struct DenseLinearPart {
  Matrix matrix;
};
struct SparseLinearPart {
  SparseMatrix matrix;
};

using Derivatives =
    std::variant<NoDerivatives, DenseJacobian, SparseJacobian, DenseLinearPart, SparseLinearPart>;

}  // namespace fde
