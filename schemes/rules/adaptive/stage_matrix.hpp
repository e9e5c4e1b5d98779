// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "fdebench/schemes/stepping/run.hpp"

namespace fde {

constexpr Eigen::Index stages = 3;

// For each component the matrix K (step size^order included): K times the values of a function at the stages
// of a step is its fractional integral over the step, at the stages. Zero in algebraic rows.
using StageWeights = std::vector<Eigen::Matrix<double, stages, stages>>;

// The iteration matrix of Newton's method for all stages of a step at once: 1 - K df/dy, with df/dy at one
// state, and -df/dy in algebraic rows. Vectors hold one stage after the other.
class StageMatrix {
 public:
  StageMatrix& operator=(StageMatrix&&) = delete;
  virtual ~StageMatrix() = default;

  // Computes and factorises the matrix at (t, y). f: f(t, y).
  virtual void factorise(Run& run, double t, In y, In f, const StageWeights& weights) = 0;

  // Replaces b, of stages * size() entries, by the solution x of M x = b; not finite where the matrix M is
  // singular.
  virtual void solve(Vec& b) const = 0;

  // The name of the sparse linear solver; empty: the matrix is dense or not yet factorised.
  [[nodiscard]] virtual std::string_view solver() const { return {}; }
};

// A matrix for the problem's kind of derivatives. The problem must outlive it.
std::unique_ptr<StageMatrix> make_stage_matrix(const Problem& problem);

}  // namespace fde
