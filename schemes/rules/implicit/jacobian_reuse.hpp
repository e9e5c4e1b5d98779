// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "fdebench/schemes/problem/archive.hpp"

namespace fde {

// Decides when factors that are reused from step to step are to be recomputed: once they have cost as many
// additional iterations, compared with fresh factors, as a new factorisation costs.
class JacobianReuse {
 public:
  // price: cost of a factorisation, in iterations.
  explicit JacobianReuse(int price) : factorisation_cost_(price) {}

  // Whether the factors are to be recomputed.
  [[nodiscard]] bool is_stale() const { return stale_; }
  void mark_stale() { stale_ = true; }
  // The factors have been recomputed.
  void reset() {
    stale_ = false;
    steps_ = iterations_ = min_iterations_ = 0;
  }
  // Records the number of iterations of a step.
  void record_step(long iterations) {
    min_iterations_ = steps_ == 0 ? iterations : std::min(min_iterations_, iterations);
    ++steps_;
    iterations_ += iterations;
    if (iterations_ - steps_ * min_iterations_ >= factorisation_cost_) stale_ = true;
  }

  void state(Archive& archive) { archive(steps_, iterations_, min_iterations_, stale_); }

 private:
  int factorisation_cost_;
  long steps_ = 0, iterations_ = 0, min_iterations_ = 0;
  bool stale_ = true;
};

}  // namespace fde
