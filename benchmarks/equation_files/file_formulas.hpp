// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string_view>

#include "fdebench/benchmarks/equation_files/equation_text.hpp"
#include "fdebench/benchmarks/expressions/expressions.hpp"
#include "fdebench/benchmarks/scenes/parameters.hpp"

namespace fde::bench {

// The variables of a formula of a file.
struct FormulaVariables {
  bool time = true;  // whether t is allowed
  // The variable of D^order of an unknown, order 0 being the unknown itself; throws std::invalid_argument if
  // there is none. Empty: unknowns are not allowed.
  std::function<Expression(std::size_t unknown, double order)> resolve_unknown{};
};

// Parses the formulas of a file for given values of its parameters. Each function throws
// std::invalid_argument naming file, line and column, the text there and what is allowed. `text` and
// `parameters` must outlive this object.
class FileFormulas {
 public:
  FileFormulas(const EquationText& text, const Parameters& parameters, NumberStorage numbers)
      : text_(text), parameters_(parameters), pool_(numbers) {}

  Expression read(const FormulaText& formula, const FormulaVariables& variables);
  // The value of a formula that contains parameters only.
  double constant(const FormulaText& formula, std::string_view name, const Range& allowed);

  [[nodiscard]] ExpressionPool& pool() { return pool_; }
  [[nodiscard]] const EquationText& text() const { return text_; }
  [[noreturn]] void reject(const FormulaText& formula, std::string_view what) const {
    reject_in(text_.file, formula, 0, what);
  }

 private:
  Expression derivative(std::string_view unknown, Expression order, const FormulaVariables& variables);

  const EquationText& text_;
  const Parameters& parameters_;
  ExpressionPool pool_;
};

}  // namespace fde::bench
