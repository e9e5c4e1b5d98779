#pragma once

#include <optional>

#include "numbers/rational.hpp"
#include "reference.hpp"

namespace fde {

// a q' + b D^alpha q = C0, 0 < alpha < 3, with its coefficients and initial values as decimals, so that no
// product of them is rounded.
struct FractionalLine {
  double alpha, a, b, q0, q1, q2;
  std::optional<double> given;  // C0, where it is not what the constraint is at the start

  // a q'(0) where D^alpha q(0) = 0. At order 1 that is q'(0): (a + b) q'(0).
  [[nodiscard]] double constant_at_start() const { return (alpha == 1.0 ? a + b : a) * q1; }
  [[nodiscard]] double constant() const { return given.value_or(constant_at_start()); }
  [[nodiscard]] Rational exact_constant() const;
  // Whether C0 is what the constraint is at the start.
  [[nodiscard]] bool starts_smoothly() const;
  // Whether C0 determines q' without D^alpha q: q = q0 + q1 t.
  [[nodiscard]] bool uniform() const;
};

// q, q' and, for b != 0, D^alpha q.
Reference exact_columns(const FractionalLine& line);
// q''/a, the multiplier of the constraint; for a != 0.
Reference exact_multiplier(const FractionalLine& line);

}  // namespace fde
