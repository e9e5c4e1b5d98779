#pragma once

#include <algorithm>

#include "checkpoint/archive.hpp"

namespace fde {

// Decides when factors that are reused from step to step are to be recomputed: once they have cost as many
// additional iterations, compared with fresh factors, as a new factorisation costs.
class Wear {
 public:
  // price: cost of a factorisation, in iterations.
  explicit Wear(int price) : price_(price) {}

  // Whether the factors are to be recomputed.
  [[nodiscard]] bool worn() const { return worn_; }
  void wear_out() { worn_ = true; }
  // The factors have been recomputed.
  void renew() {
    worn_ = false;
    steps_ = taken_ = fewest_ = 0;
  }
  // Records the number of iterations of a step.
  void count(long iterations) {
    fewest_ = steps_ == 0 ? iterations : std::min(fewest_, iterations);
    ++steps_;
    taken_ += iterations;
    if (taken_ - steps_ * fewest_ >= price_) worn_ = true;
  }

  void state(Archive& archive) { archive(steps_, taken_, fewest_, worn_); }

 private:
  int price_;
  long steps_ = 0, taken_ = 0, fewest_ = 0;
  bool worn_ = true;
};

}  // namespace fde
