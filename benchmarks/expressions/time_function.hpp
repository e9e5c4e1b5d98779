// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "fdebench/benchmarks/expressions/expressions.hpp"
#include "fdebench/benchmarks/expressions/program.hpp"

namespace fde::bench {

struct SignedPiece {
  double from, to, sign;
};

// An expression of t alone, with its derivative where that is known (see ExpressionPool::derivative) and no
// step or sign makes the expression jump.
class TimeFunction {
 public:
  // Precondition: the expression has no variable but t.
  TimeFunction(Expression of, ExpressionPool& pool);

  [[nodiscard]] double operator()(double t) const { return value_(t, Vec()); }

  // The interval [from, to] as pieces on which the sign is -1, 0 or 1, increasing; pieces on which it is not
  // a number are left out. Values up to `negligible` are 0 or have the sign of their neighbours. The interval
  // is divided, the longest piece first, until interval arithmetic shows that a piece has no zero or that the
  // function is monotone there, so that no zero is missed: up to 2^16 pieces, of which the last are compared
  // at their ends only. A zero is located to the last bit: the first number with the later sign.
  [[nodiscard]] std::vector<SignedPiece> signs(double from, double to, double negligible = 0.0) const;

  // A bound of its values in [from, to] that is finite; 0 if none is known.
  [[nodiscard]] double largest(double from, double to) const;

 private:
  // The sign of all values on a piece, up to negligible ones; nullopt if their range does not show it.
  [[nodiscard]] std::optional<double> sign_on(double from, double to, double negligible) const;
  [[nodiscard]] bool is_monotone_on(double from, double to) const;
  void add_by_ends(double from, double to, std::vector<SignedPiece>& found) const;

  Program value_;
  std::optional<Program> slope_{};
};

}  // namespace fde::bench
