// SPDX-License-Identifier: MIT
// Problems with right derivatives that several tests solve.
#pragma once

#include <cmath>
#include <utility>

#include "fdebench/schemes/problem/problem.hpp"

namespace fde::bench {

// The problem with time reversed: left rows are right rows.
inline Problem mirrored(Problem problem) {
  for (auto& component : problem.components)
    component.side = component.side == Side::left ? Side::right : Side::left;
  problem.rhs = [rhs = std::move(problem.rhs), end = problem.end](double t, In y, Out f) {
    rhs(end - t, y, f);
  };
  return problem;
}

// D^0.6 y = -y + r, right D^0.8 r = -r / 2 - z with z = y^2 + sin r: z substituted, or as an algebraic row
// before the others, where z(0), which depends on r(0), is determined by a condition.
struct DefinedUnknown {
  static double z(In y) { return y[0] * y[0] + std::sin(y[1]); }
  Problem eliminated{.components = {{0.6, {1.0}}, {0.8, {0.5}, Side::right}},
                     .rhs = [](double, In y, Out f) { f << -y[0] + y[1], -y[1] / 2 - z(y); }};
  Problem whole{
      .components = {{0.0, {}}, {0.6, {1.0}}, {0.8, {0.5}, Side::right}},
      .rhs = [](double, In y, Out f) { f << y[0] - z(y.tail(2)), -y[1] + y[2], -y[2] / 2 - y[0]; },
      .conditions = [](In at_start, In, Out residual) { residual[0] = at_start[0] - z(at_start.tail(2)); }};
};

}  // namespace fde::bench
