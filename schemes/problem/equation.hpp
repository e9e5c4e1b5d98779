// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "fdebench/schemes/problem/vectors.hpp"

namespace fde {

// One term coefficient * D^order u of a multi-term equation.
struct Term {
  double coefficient;
  double order;
};

// A multi-term equation of a problem for an unknown u,
//   a D^leading u + factor(t, y) sum_k c_k D^(a_k) u = force(t, y)        (Yin, Liu & Anh 2007, eq. 1.1)
// where y is the state of the whole problem. The rows first_row, first_row + 1, ... of the problem are the
// chain of this equation: u and its derivatives of orders below the leading one (chain.hpp).
struct Equation {
  Eigen::Index first_row;
  Term leading;
  std::vector<Term> terms;  // by increasing order, each order once; no coefficient is 0
  std::function<double(double t, In y)> force, factor;
  // The force as a formula, as ProblemText has them; empty: not known, or there is a factor.
  std::function<std::string()> force_text{};
};

}  // namespace fde
