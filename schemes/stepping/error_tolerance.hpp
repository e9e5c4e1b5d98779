// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/problem/archive.hpp"
#include "fdebench/schemes/problem/resolution.hpp"
#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

// The largest error allowed in each row of a step: atol + rtol |y|, but at most 1/100 of the largest |y| that
// the row has had since t = 0, and at least 50 eps times the terms of the row, and 1e-292.
class ErrorTolerance {
 public:
  explicit ErrorTolerance(const Tolerance& accuracy) : accuracy_(accuracy) {}

  // largest: the largest |y| of each row on the step; terms: the size of the terms that the row is a sum of.
  [[nodiscard]] Vec on_step(In largest, In terms) const { return on_step(largest, largest, terms); }

  // The error allowed at every time of a step on which least <= |y| <= largest. It is relative to `largest`
  // where atol is at most 1e-3 rtol, otherwise to `least`; then the rounding term counts `largest` only up to
  // 16 (atol / rtol + least).
  [[nodiscard]] Vec on_step(In least, In largest, In terms) const;

  // The allowed error without the bound by the largest |y| so far.
  [[nodiscard]] Vec from_tolerance(In largest, In terms) const;

  // Records an accepted step with the largest |y| of each row on it.
  void accept_step(In largest);

  void state(Archive& archive) { archive.resizable(largest_); }

 private:
  Tolerance accuracy_;
  Vec largest_;  // over all accepted steps; empty before the first
};

}  // namespace fde
