#pragma once

#include <functional>
#include <string_view>

#include "equation_files/equation_text.hpp"
#include "equation_files/expressions.hpp"
#include "scenes/parameters.hpp"

namespace fde {

// What stands for the unknowns in a formula of a file.
struct FormulaVariables {
  bool time = true;  // whether t may stand there
  // The variable that is D^order of an unknown, order 0 being itself; throws std::invalid_argument where none
  // is. Empty: no unknown may stand there.
  std::function<Expression(std::size_t unknown, double order)> unknown{};
};

// Reads the formulas of a file with values of its parameters. Each function throws std::invalid_argument
// naming file, line and column, what is there and what is allowed. What is given must live as long.
class FileFormulas {
 public:
  FileFormulas(const EquationText& text, const Parameters& parameters, Numbers numbers)
      : text_(text), parameters_(parameters), all_(numbers) {}

  Expression read(const FormulaText& formula, const FormulaVariables& variables);
  // A formula of the parameters alone.
  double constant(const FormulaText& formula, std::string_view name, const Range& allowed);

  [[nodiscard]] Expressions& all() { return all_; }
  [[nodiscard]] const EquationText& text() const { return text_; }
  [[noreturn]] void reject(const FormulaText& formula, std::string_view what) const {
    reject_in(text_.file, formula, 0, what);
  }

 private:
  Expression derivative(std::string_view unknown, Expression order, const FormulaVariables& variables);

  const EquationText& text_;
  const Parameters& parameters_;
  Expressions all_;
};

}  // namespace fde
