#pragma once

#include <array>
#include <memory>
#include <string_view>

#include "stepping/run.hpp"

namespace fde {

constexpr Eigen::Index stages = 3;

// What values of a function at the stages of a step make of its fractional integral there: of each row,
// in units of its own. Zero in algebraic rows.
using StageWeights = std::vector<Eigen::Matrix<double, stages, stages>>;

// The matrix that Newton's method solves with for all stages of a step at once: 1 - K df/dy, with df/dy at
// one state, and -df/dy in algebraic rows. Rows of a stage stand together.
class StageMatrix {
 public:
  StageMatrix() = default;
  StageMatrix(const StageMatrix&) = delete;
  StageMatrix& operator=(const StageMatrix&) = delete;
  virtual ~StageMatrix() = default;

  // Becomes the factorised matrix at y, where f is f(t, y).
  virtual void factorise(Run& run, double t, In y, In f, const StageWeights& weights) = 0;

  // b becomes the solution x of (the matrix) x = b; not finite where it is singular.
  virtual void solve(Vec& b) const = 0;

  // The name of the method, of sparse derivatives; empty: it says none.
  [[nodiscard]] virtual std::string_view solver() const { return {}; }
};

// Of the kind of the problem's derivatives.
std::unique_ptr<StageMatrix> make_stage_matrix(const Problem& problem);

}  // namespace fde
