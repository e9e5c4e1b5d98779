#pragma once

#include <span>
#include <vector>

#include "equation_files/expressions.hpp"
#include "problem/vectors.hpp"

namespace fde {

// Expressions of t, variable 0, and the y_i, variables i + 1, to be evaluated together in double: each part
// once, in the order of the formulas. May be called by several threads.
class Program {
 public:
  Program() = default;
  Program(const Expressions& all, const std::vector<Expression>& results, Eigen::Index size);

  // The values of the expressions, in their order.
  void evaluate(double t, In y, std::span<double> results) const;
  // That of the first.
  [[nodiscard]] double operator()(double t, In y) const;

 private:
  // A line of the program: its result stands behind those before it.
  struct Line {
    Operation operation;
    int a, b, c;  // places of the arguments
  };

  int inputs_ = 0;  // t and y
  std::vector<double> numbers_{};
  std::vector<Line> lines_{};
  std::vector<int> results_{};  // their places
};

}  // namespace fde
