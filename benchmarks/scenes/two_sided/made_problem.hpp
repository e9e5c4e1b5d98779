#pragma once

#include <functional>
#include <vector>

#include "stepping/scheme.hpp"

namespace fde {

// One row of a problem that is made from its solution 1 + i/4 + s^power, s the time of the row: t, or what is
// left of it.
struct MadeRow {
  double order, power;
  Side side;
};

struct Made {
  Problem problem;
  std::function<Vec(double)> exact;
  Smoothness smoothness;
};

// D^g s^p = Gamma(p+1)/Gamma(p+1-g) s^(p-g), on both sides; each row is coupled to the two after it by
// N_i(y) = sin(y_(i+1)) y_(i+2) / 2 - y_i, and f_i = D^g s^p + N_i(y) - N_i(solution).
Made made_problem(const std::vector<MadeRow>& rows, double end);

// Six rows, three a side, with orders below, at and above 1; smooth.
Made smooth_two_sided();

}  // namespace fde
