// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "fdebench/reference/reference.hpp"
#include "fdebench/reference/special_functions/numbers/rational.hpp"

namespace fde::bench {

// a q' + b D^alpha q = C0, 0 < alpha < 3. Coefficients and initial values are read as decimals: no product of
// them is rounded.
struct FractionalLine {
  double alpha, a, b, q0, q1, q2;
  std::optional<double> explicit_constant;  // C0; nullopt: constant_at_start()

  // a q'(0), the value of the constraint at t = 0 if D^alpha q(0) = 0; at order 1, (a + b) q'(0).
  [[nodiscard]] double constant_at_start() const { return (alpha == 1.0 ? a + b : a) * q1; }
  [[nodiscard]] double constant() const { return explicit_constant.value_or(constant_at_start()); }
  [[nodiscard]] reference::Rational exact_constant() const;
  // Whether C0 equals constant_at_start(), exactly.
  [[nodiscard]] bool is_consistent_at_start() const;
  // Whether q = q0 + q1 t.
  [[nodiscard]] bool is_uniform_motion() const;
};

// Columns q, q' and, for b != 0, D^alpha q.
reference::Reference exact_columns(const FractionalLine& line);
// The multiplier of the constraint, q''/a; requires a != 0.
reference::Reference exact_multiplier(const FractionalLine& line);

}  // namespace fde::bench
