// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "fdebench/benchmarks/expressions/expressions.hpp"
#include "fdebench/schemes/problem/interval.hpp"
#include "fdebench/schemes/problem/vectors.hpp"

namespace fde::bench {

// One operation and the slots of its arguments; the function of a table, which the list owns.
struct Instruction {
  Operation operation;
  int a, b, c;
  const SampledFunction* function;
};

// Expressions of t (variable 0) and y_i (variable i + 1) as operations in the order of their evaluation. The
// slots are those of t, the y_i, the numbers, and then one of each instruction.
struct InstructionList {
  int inputs = 0;  // t and y
  std::vector<double> numbers{};
  std::vector<Instruction> instructions{};
  std::vector<int> results{};          // slots of the results
  std::vector<Eigen::Index> places{};  // result i is element places[i] of what is written
  std::vector<std::shared_ptr<const SampledFunction>> functions{};

  [[nodiscard]] int first() const { return inputs + static_cast<int>(numbers.size()); }
  [[nodiscard]] std::size_t slots() const { return static_cast<std::size_t>(first()) + instructions.size(); }
};

// Each common part of the expressions is one instruction. Precondition: one place for each expression.
InstructionList instructions_of(const ExpressionPool& pool, const std::vector<Expression>& results,
                                const std::vector<Eigen::Index>& places, Eigen::Index size);

// Evaluates one instruction after the other, in double. Only the places of results are written.
void interpret(const InstructionList& list, double t, const double* y, std::span<double> results);

// The same in intervals: each result contains the values at all t and y of the given intervals.
void interpret(const InstructionList& list, const Interval& t, const Interval* y,
               std::span<Interval> results);

// A number as an operand of such a formula.
std::string formula_number(double value);

// The results as formulas of t and y1, y2, ..., in their order, as ProblemText has them. Common parts are
// repeated. Empty if they are together longer than a megabyte or contain a table or a number that is not
// finite.
std::vector<std::string> texts_of(const InstructionList& list);

}  // namespace fde::bench
