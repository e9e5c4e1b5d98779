// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/expressions/expressions.hpp"
#include "fdebench/benchmarks/expressions/machine_code.hpp"
#include "fdebench/schemes/problem/vectors.hpp"

namespace fde::bench {

// Compiled expressions of t (variable 0) and y_i (variable i + 1), evaluated together in double. The first
// evaluations interpret a list of instructions; then it is translated to machine code. Copies share both.
// Thread-safe.
class Program {
 public:
  Program() = default;
  Program(const ExpressionPool& pool, const std::vector<Expression>& results, Eigen::Index size);
  // evaluate writes expression i to results[places[i]].
  Program(const ExpressionPool& pool, const std::vector<Expression>& results,
          const std::vector<Eigen::Index>& places, Eigen::Index size);

  // The values of the expressions, in the order of the constructor. Precondition: y and results do not
  // overlap.
  void evaluate(double t, In y, std::span<double> results) const {
    if (!shared_) return;
    if (auto* const function = shared_->function.load(std::memory_order_acquire)) {
      function(t, y.data(), results.data());
    } else {
      shared_->interpret_or_translate(t, y.data(), results);
    }
  }
  void operator()(double t, In y, Out results) const {
    evaluate(t, y, {results.data(), static_cast<std::size_t>(results.size())});
  }
  // The value of the only expression.
  [[nodiscard]] double operator()(double t, In y) const {
    double result = 0.0;
    evaluate(t, y, {&result, 1});
    return result;
  }

  // Intervals that contain the values at all t and y of the given intervals, written as by evaluate.
  void enclose(const Interval& t, std::span<const Interval> y, std::span<Interval> results) const {
    if (shared_) interpret(shared_->list, t, y.data(), results);
  }
  [[nodiscard]] Interval range(const Interval& t) const {
    Interval result;
    enclose(t, {}, {&result, 1});
    return result;
  }

  // The expressions as formulas, as texts_of() writes them.
  [[nodiscard]] std::vector<std::string> texts() const;

  // The number of evaluations after which a list is translated. Translating takes about as long as these: up
  // to 1 us for each instruction of a list of hundreds, more of a longer one, and 0.1 ms for the first list
  // of a process, however short.
  static constexpr int interpreted_evaluations(std::size_t instructions) {
    return 256 + static_cast<int>(instructions / 4 + 16384 / (instructions + 1));
  }

 private:
  struct Shared {
    explicit Shared(InstructionList of) : list(std::move(of)) {}
    void interpret_or_translate(double t, const double* y, std::span<double> results);

    const InstructionList list;
    std::atomic<MachineFunction*> function{nullptr};  // nullptr: interpreted
    std::atomic<int> evaluations{0};
    std::shared_ptr<MachineFunction> code{};  // owns `function`
  };

  std::shared_ptr<Shared> shared_{};
};

}  // namespace fde::bench
