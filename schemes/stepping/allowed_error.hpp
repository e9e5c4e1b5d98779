#pragma once

#include "checkpoint/archive.hpp"
#include "problem/resolution.hpp"
#include "problem/vectors.hpp"

namespace fde {

// What may be wrong in each row of a step: the accuracy asked, but at most a hundredth of the largest that
// the row has been, and at least a little more than the rounding of the terms that it is the sum of, and than
// 1e-292.
class AllowedError {
 public:
  explicit AllowedError(const Accuracy& accuracy) : accuracy_(accuracy) {}

  // largest: the largest |y| of each row on the step; terms: of what it is the sum of.
  [[nodiscard]] Vec of(In largest, In terms) const { return of(largest, largest, terms); }

  // The same all over a step on which |y| is at least `least`: where next to no absolute error is asked,
  // relative to the largest, otherwise to the least, and rounding of a row that grows far beyond both is not
  // what has to be left to it.
  [[nodiscard]] Vec of(In least, In largest, In terms) const;

  // The same as if the row had been as large as any.
  [[nodiscard]] Vec of_accuracy(In largest, In terms) const;

  // Takes a step as passed on which rows were at most so large.
  void pass(In largest);

  void state(Archive& archive) { archive.grown(largest_); }

 private:
  Accuracy accuracy_;
  Vec largest_;  // so far; empty: no step has passed
};

}  // namespace fde
