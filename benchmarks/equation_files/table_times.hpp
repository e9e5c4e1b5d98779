// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "fdebench/benchmarks/equation_files/file_formulas.hpp"
#include "fdebench/benchmarks/expressions/expressions.hpp"
#include "fdebench/benchmarks/expressions/time_function.hpp"

namespace fde::bench {

// The times at which the argument of a table, a function of t alone, passes the samples at which the table or
// a derivative of it jumps.
class TableTimes {
 public:
  // Precondition: the expression is a table of an argument without unknowns.
  TableTimes(Expression value, ExpressionPool& pool);

  // Those in (0, end], each the first number behind which the table is another polynomial. Where the argument
  // is a + b t they are computed from a and b, otherwise by the interval arithmetic of TimeFunction::signs.
  [[nodiscard]] std::vector<double> until(double end) const;

 private:
  [[nodiscard]] double first_behind(double sample, double time) const;

  std::shared_ptr<const SampledFunction> table_;
  TimeFunction argument_;
  double start_ = 0.0, rate_ = 0.0;
  std::optional<TimeFunction> alternation_{};
};

// A function of the end T that throws FileError, at the place of the table in its formula, if an argument
// that depends on t alone leaves the samples for a t in [0, T]; of the formulas that were read up to now.
std::function<void(double end)> samples_check(FileFormulas& formulas);

}  // namespace fde::bench
