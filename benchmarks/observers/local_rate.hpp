#pragma once

#include <functional>
#include <vector>

#include "problem/grid.hpp"
#include "problem/problem.hpp"

namespace fde {

// The rate of change at a step of a grid from the values at steps around it: d/dt = sum_k weights[k]
// value(steps[k]).
struct LocalRate {
  std::vector<int> steps;
  Vec weights;
};

// That of the polynomial through the five nearest steps, of order 4; of fewer where there are no more. Among
// the first steps no polynomial follows a value that leaves its start with t^p, p of these powers: there it
// is the rate of the sum 1, t^p1, t^p2, ... of the smallest powers through the same values. Needs 1 <= n <=
// grid.steps.
LocalRate local_rate(const Grid& grid, int n, const std::vector<double>& powers);

// The times around t > 0 at which rate_at(t, ...) asks for values, besides t; increasing, in (0, end].
std::vector<double> times_around(double t, double end);

// The rate of change at t of what is known at any time up to `end`: by polynomials of degree 4 through values
// at t and at distances d and 4 d, of d = t/16, t/64, ... those whose result the next closer ones change
// least. The closer, the better a polynomial follows, a start like t^p too, and the more do errors of the
// values count. At the end all times are before t.
Vec rate_at(double t, double end, const std::function<Vec(double)>& values);

}  // namespace fde
