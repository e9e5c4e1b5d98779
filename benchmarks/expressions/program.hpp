// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "fdebench/benchmarks/expressions/expressions.hpp"
#include "fdebench/schemes/problem/vectors.hpp"

namespace fde::bench {

// Compiled expressions of t (variable 0) and y_i (variable i + 1), evaluated together in double. Each common
// part is evaluated once. Thread-safe.
class Program {
 public:
  Program() = default;
  Program(const ExpressionPool& pool, const std::vector<Expression>& results, Eigen::Index size);

  // The values of the expressions, in the order of the constructor.
  void evaluate(double t, In y, std::span<double> results) const;
  // The value of the first expression.
  [[nodiscard]] double operator()(double t, In y) const;

 private:
  // One operation; line i writes the slot after those of inputs, numbers and the previous lines.
  struct Instruction {
    Operation operation;
    int a, b, c;  // slots of the arguments
  };

  int inputs_ = 0;  // t and y
  std::vector<double> numbers_{};
  std::vector<Instruction> lines_{};
  std::vector<int> results_{};  // slots of the results
};

}  // namespace fde::bench
