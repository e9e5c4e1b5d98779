#pragma once

#include <algorithm>

#include "checkpoint/archive.hpp"

namespace fde {

// When factors of a matrix that are kept from step to step are no longer worth it: once they have cost as
// many iterations more than a step takes with fresh ones as fresh ones cost themselves.
class Wear {
 public:
  // price: of fresh factors, in iterations.
  explicit Wear(int price) : price_(price) {}

  [[nodiscard]] bool worn() const { return worn_; }
  void wear_out() { worn_ = true; }
  void renew() {
    worn_ = false;
    steps_ = taken_ = fewest_ = 0;
  }
  // A step took so many iterations.
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
