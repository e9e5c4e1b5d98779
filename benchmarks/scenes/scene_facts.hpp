// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace fde::bench {

// A parameter in which the solution is not continuous at its present value; `limit` says, in words, what a
// term of the equation tends to as the parameter tends to this value.
struct Discontinuity {
  std::string parameter, limit;

  bool operator==(const Discontinuity&) const = default;
};

// An equation for display only: two formulas, in which D(x, a) and J(x, a) are the left derivative and
// integral of order a, D_right and J_right the right ones, and sum(k, x) is a sum over k.
struct DisplayEquation {
  std::string left, right;

  bool operator==(const DisplayEquation&) const = default;
};

// An equation as text, from a file or for display: sum of coefficient D^order unknown = rhs, as formulas.
struct EquationFormula {
  struct Term {
    std::string coefficient, order;
  };
  std::string unknown;
  std::vector<Term> terms;
  std::string rhs;
  std::vector<std::string> initial;
  std::vector<std::pair<std::string, std::string>> final{};  // columns and their values at the end
};

// The terms on the left; 0 = rhs where all have order 0.
DisplayEquation displayed(const EquationFormula& equation);

}  // namespace fde::bench
