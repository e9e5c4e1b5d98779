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
  [[nodiscard]] bool worn() const { return worn_; }
  void mark_stale() { worn_ = true; }
  // The factors have been recomputed.
  void renew() {
    worn_ = false;
    steps_ = iterations_ = min_iterations_ = 0;
  }
  // Records the number of iterations of a step.
  void count(long iterations) {
    min_iterations_ = steps_ == 0 ? iterations : std::min(min_iterations_, iterations);
    ++steps_;
    iterations_ += iterations;
    if (iterations_ - steps_ * min_iterations_ >= factorisation_cost_) worn_ = true;
  }

  void state(Archive& archive) { archive(steps_, iterations_, min_iterations_, worn_); }

 private:
  int factorisation_cost_;
  long steps_ = 0, iterations_ = 0, min_iterations_ = 0;
  bool worn_ = true;
};

}  // namespace fde
