// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/equation_files/equation_text.hpp"
#include "fdebench/benchmarks/expressions/expressions.hpp"
#include "fdebench/benchmarks/scenes/parameters.hpp"

namespace fde::bench {

// The variables of a formula of a file.
struct FormulaVariables {
  bool time = true;              // whether t is allowed
  bool is_before_start = false;  // whether t is below 0
  // The variable of D^order of an unknown, order 0 being the unknown itself; throws std::invalid_argument if
  // there is none. Empty: unknowns are not allowed.
  std::function<Expression(std::size_t unknown, double order)> resolve_unknown{};
  // D^order of an unknown whose order is a formula rather than a number; empty: as resolve_unknown.
  std::function<Expression(std::size_t unknown, double order)> resolve_formula_order{};
  // The variable of an unknown or derivative at the time t - lag, lag > 0; throws std::invalid_argument if
  // there is none. Empty: earlier values are not allowed.
  std::function<Expression(Expression of, double lag)> earlier{};
  // The value of an output, where it is not the sum of the derivatives of its state; empty: it is everywhere.
  std::function<std::optional<Expression>(std::string_view name)> resolve_output{};
  // The value of a further name; nullopt if there is none.
  std::function<std::optional<Expression>(std::string_view name)> resolve_other{};
  std::vector<std::string_view> other_names{};  // those of them that messages list
};

// The value of a table in a formula, and the place of its name there.
struct SampledValue {
  Expression value;
  FormulaText formula;
  std::size_t byte;
};

// Parses the formulas of a file for given values of its parameters. Each function throws
// std::invalid_argument naming file, line and column, the text there and what is allowed. `text` and
// `parameters` must outlive this object.
class FileFormulas {
 public:
  // The parameters in formulas: their values, or variables that parameter_name() names, which only the orders
  // of derivatives take by value.
  enum class ParametersAs { values, variables };

  FileFormulas(const EquationText& text, const Parameters& parameters, NumberStorage numbers,
               ParametersAs as = ParametersAs::values)
      : text_(text), parameters_(parameters), as_(as), pool_(numbers) {}

  // An unknown or a derivative that the system does not have may be multiplied by 0.
  Expression read(const FormulaText& formula, const FormulaVariables& variables);
  // The value of a formula that contains parameters only; a pool of fractions keeps what it is exactly.
  double constant(const FormulaText& formula, std::string_view name, const Range& allowed);
  // The same evaluated in double, operation by operation, as code would be.
  double constant_in_double(const FormulaText& formula, std::string_view name, const Range& allowed);

  // The time at which the problem begins, 0 or the key start; the end, counted from there, and the time of a
  // formula, which must be later.
  double start();
  double end();
  double time_after_start(const FormulaText& formula, std::string_view name, const Range& allowed);
  // t as users know it.
  Expression time();

  // With parameters as variables: the name of such a variable, empty for another one; and the formula of an
  // order that occurred, its value otherwise.
  [[nodiscard]] std::string parameter_name(int variable) const;
  [[nodiscard]] std::string order_text(double order) const;

  // Throws std::invalid_argument "NAME = VALUE: must be ..." if a requirement of the file does not hold.
  void require_parameters();

  // The values of tables in the formulas that were read, each once, but not in those of t < 0.
  [[nodiscard]] const std::vector<SampledValue>& sampled_values() const { return sampled_values_; }

  [[nodiscard]] ExpressionPool& pool() { return pool_; }
  [[nodiscard]] const EquationText& text() const { return text_; }
  [[nodiscard]] const Parameters& parameters() const { return parameters_; }
  [[noreturn]] void reject(const FormulaText& formula, std::string_view what) const {
    reject_in(text_.file, formula, 0, what);
  }

 private:
  enum class Absent { is_a_variable, is_an_error };

  Expression read(const FormulaText& formula, const FormulaVariables& variables, Absent absent);
  Expression parameter(const ParameterText& known);
  Expression component(std::string_view name, int index, const FormulaVariables& variables, Absent absent);
  Expression outside(const VectorText& vector, int index);
  [[nodiscard]] double require_in(const Range& allowed, double value, const FormulaText& formula,
                                  std::string_view name) const;
  // The value, which stands for this expression in a pool of fractions.
  double with_exact(Expression exact, double value);
  // The value of an expression without variables other than parameters.
  std::optional<long double> value(Expression of);
  Expression earlier(Expression of, Expression time, const FormulaVariables& variables);
  Expression output(const OutputText& of, double order, const FormulaVariables& variables);
  Expression time_derivative(Expression of, Expression order);
  Expression derivative(std::string_view unknown, Expression order, bool is_decimal,
                        const FormulaVariables& variables, Absent absent);

  const EquationText& text_;
  const Parameters& parameters_;
  ParametersAs as_;
  ExpressionPool pool_;
  std::map<double, std::string> order_texts_{};
  std::vector<SampledValue> sampled_values_{};
};

}  // namespace fde::bench
