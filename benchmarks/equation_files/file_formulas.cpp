// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/file_formulas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>

#include "fdebench/benchmarks/expressions/formula.hpp"
#include "fdebench/benchmarks/expressions/formula_text.hpp"
#include "fdebench/benchmarks/expressions/program.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"

namespace fde::bench {
namespace {

// Stands for an unknown or a derivative that the system does not have.
constexpr int absent_variable = 1'000'000'000;
constexpr int first_parameter = 500'000'000;  // the variables of parameters

// The vector of this name; nullptr if there is none.
const VectorText* vector_named(const EquationText& text, std::string_view name) {
  const auto found = std::ranges::find(text.vectors, name, &VectorText::name);
  return found == text.vectors.end() ? nullptr : &*found;
}

// A component "u[3]" by its vector and its index; nullopt for another name.
std::optional<std::pair<const VectorText*, int>> component_named(const EquationText& text,
                                                                 std::string_view name) {
  const auto bracket = name.find('[');
  const auto* vector =
      bracket == std::string_view::npos ? nullptr : vector_named(text, name.substr(0, bracket));
  if (vector == nullptr) return std::nullopt;
  int index = 0;
  std::from_chars(name.data() + bracket + 1, name.data() + name.size(), index);
  return std::pair(vector, index);
}

bool contains(const VectorText& vector, int index) { return index >= 1 && index <= vector.size; }

std::optional<std::size_t> unknown_named(const EquationText& text, std::string_view name) {
  if (const auto component = component_named(text, name)) {
    const auto& [vector, index] = *component;
    return contains(*vector, index) ? std::optional(vector->first + static_cast<std::size_t>(index) - 1)
                                    : std::nullopt;
  }
  const auto found = std::ranges::find(text.unknowns, name, &UnknownText::name);
  if (found == text.unknowns.end()) return std::nullopt;
  return static_cast<std::size_t>(found - text.unknowns.begin());
}

const OutputText* output_named(const EquationText& text, std::string_view name) {
  const auto found = std::ranges::find(text.outputs, name, &OutputText::name);
  return found == text.outputs.end() ? nullptr : &*found;
}

bool is_left_out(const EquationText& text, std::string_view name) {
  return std::ranges::find(text.absent_unknowns, name) != text.absent_unknowns.end();
}

}  // namespace

// First with a variable for what is absent. If the value depends on it, the second reading throws where the
// formula names it.
Expression FileFormulas::read(const FormulaText& formula, const FormulaVariables& variables) {
  const auto value = read(formula, variables, Absent::is_a_variable);
  if (!pool_.depends_on(value, absent_variable)) return value;
  return read(formula, variables, Absent::is_an_error);
}

Expression FileFormulas::read(const FormulaText& formula, const FormulaVariables& variables, Absent absent) {
  FormulaNames names{.accepted_names = variables.other_names};
  if (variables.time) names.accepted_names.emplace_back("t");
  for (const auto& parameter : text_.parameters) names.accepted_names.emplace_back(parameter.declared.name);
  if (variables.resolve_unknown) {
    for (const auto& unknown : text_.unknowns)
      if (!unknown.is_implied && !unknown.size) names.accepted_names.emplace_back(unknown.name);
    for (const auto& vector : text_.vectors) names.accepted_names.emplace_back(vector.name);
    for (const auto& output : text_.outputs) names.accepted_names.emplace_back(output.name);
    names.derivative = [&, absent](std::string_view unknown, Expression order, bool is_decimal) {
      return derivative(unknown, order, is_decimal, variables, absent);
    };
  }
  if (variables.resolve_unknown) {
    names.component = [&, absent](std::string_view vector, int index) {
      return component(vector, index, variables, absent);
    };
  }
  if (variables.time && variables.resolve_unknown)
    names.time_derivative = [&](Expression of, Expression order) { return time_derivative(of, order); };
  if (variables.earlier) {
    names.earlier = [&](Expression of, Expression time) { return earlier(of, time, variables); };
  }
  names.tables = text_.tables;
  if (!variables.is_before_start) {
    names.on_sampled = [&](Expression value, std::size_t byte) {
      if (std::ranges::find(sampled_values_, value, &SampledValue::value) == sampled_values_.end())
        sampled_values_.push_back({value, formula, byte});
    };
  }
  names.resolve = [&, absent](std::string_view name) -> std::optional<Expression> {
    if (name == "t" && variables.time) return time();
    if (formula.size > 0 && name == "i") return pool_.number(formula.index);
    if (formula.size > 0 && name == "size") return pool_.number(formula.size);
    for (const auto& known : text_.parameters)
      if (known.declared.name == name) return parameter(known);
    if (variables.resolve_unknown) {
      if (const auto unknown = unknown_named(text_, name)) return variables.resolve_unknown(*unknown, 0.0);
      if (const auto* output = output_named(text_, name)) return this->output(*output, 0.0, variables);
      if (vector_named(text_, name) != nullptr)
        throw std::invalid_argument(fmt::format("{0}: must have an index, as {0}[1]", name));
      if (absent == Absent::is_a_variable && is_left_out(text_, name)) return pool_.variable(absent_variable);
    }
    return variables.resolve_other ? variables.resolve_other(name) : std::nullopt;
  };
  try {
    return read_formula(formula.text, names, pool_);
  } catch (const FileError&) {  // in another formula, which this one names
    throw;
  } catch (const FormulaError& fault) {
    reject_in(text_.file, formula, fault.byte_offset, fault.what());
  } catch (const std::invalid_argument& fault) {
    reject(formula, fault.what());
  }
}

// A number; of a derived one without a given value its formula, in parameters above it in the file.
Expression FileFormulas::parameter(const ParameterText& known) {
  const std::string& name = known.declared.name;
  if (!known.declared.choices.empty())
    throw std::invalid_argument(fmt::format("{}: is a word, must be a number", name));
  if (as_ == ParametersAs::variables && known.declared.default_formula.empty())
    return pool_.variable(first_parameter + static_cast<int>(&known - text_.parameters.data()));
  const auto given = parameters_.explicit_value(name);
  if (given) return pool_.number(fmt::format("{}", *given));
  FormulaNames names;
  names.resolve = [&](std::string_view other) -> std::optional<Expression> {
    for (const auto& above : text_.parameters) {
      if (above.declared.name == name) break;
      if (above.declared.name == other) return parameter(above);
    }
    return std::nullopt;
  };
  for (const auto& above : text_.parameters) {
    if (above.declared.name == name) break;
    names.accepted_names.emplace_back(above.declared.name);
  }
  try {
    return read_formula(known.declared.default_formula, names, pool_);
  } catch (const FormulaError& fault) {
    reject_in(text_.file, known.formula, fault.byte_offset, fault.what());
  }
}

// t as users know it. The equations of mechanics are shown with it as it is.
Expression FileFormulas::time() {
  if (!text_.start || as_ == ParametersAs::variables) return pool_.variable(0);
  return pool_.make_expression(Operation::add, pool_.variable(0), read(*text_.start, {.time = false}));
}

// Of a whole order; others are rows (implied_rows.hpp).
Expression FileFormulas::time_derivative(Expression of, Expression order) {
  const auto refuse = [](std::string_view why) {
    throw std::invalid_argument(fmt::format("D of a formula: {}", why));
  };
  constexpr int most = 10;
  const auto is_of_time = [](int variable) { return variable == 0 || variable >= first_parameter; };
  if (!std::ranges::all_of(pool_.variables_in(of), is_of_time))
    refuse("must be of t and the parameters; of an unknown write D(x, 0.5)");
  const auto value = this->value(order);
  if (!value || *value < 0.0L || *value > most || *value != std::floor(*value))
    refuse(fmt::format("its order must be in [0, {}], and whole but in right-hand sides", most));
  const auto depends_on_time = [&](Expression one) { return pool_.depends_on(one, 0); };
  if (std::ranges::any_of(pool_.arguments({of}, jumps), depends_on_time))
    refuse("must not contain the sign, step or floor of t, or a table that jumps, which have no derivative");
  if (*value > 1.0L && std::ranges::any_of(pool_.arguments({of}, has_kink), depends_on_time))
    refuse("must not contain abs, min or max of t, or a table with kinks, which have no second derivative");
  Expression derivative = of;
  for (int i = 0; i < static_cast<int>(*value); ++i) derivative = pool_.derivative(derivative, 0);
  return derivative;
}

Expression FileFormulas::derivative(std::string_view unknown, Expression order, bool is_decimal,
                                    const FormulaVariables& variables, Absent absent) {
  const auto found = unknown_named(text_, unknown);
  const bool may_be_absent = absent == Absent::is_a_variable;
  if (!found && may_be_absent && is_left_out(text_, unknown.substr(0, unknown.find('['))))
    return pool_.variable(absent_variable);
  if (const auto of_vector = component_named(text_, unknown); of_vector && !found) {
    const auto value = outside(*of_vector->first, of_vector->second);
    const bool is_constant = !pool_.depends_on(value, 0);
    return is_constant && this->value(order) > 0.0L ? pool_.number(0) : time_derivative(value, order);
  }
  const auto* output = output_named(text_, unknown);
  if (!found && output == nullptr)
    throw std::invalid_argument(fmt::format("{}: must be an unknown, as in D(x, 0.5)", unknown));
  const auto value = this->value(order);
  if (!value || !std::isfinite(static_cast<double>(*value)))
    throw std::invalid_argument("D: its order must be a formula of the parameters");
  if (as_ == ParametersAs::variables) {
    order_texts_[static_cast<double>(*value)] =
        formula_text(pool_, order, [&](int variable) { return parameter_name(variable); });
  }
  with_exact(order, static_cast<double>(*value));
  const bool is_formula = !is_decimal && variables.resolve_formula_order;
  const auto& resolve = is_formula ? variables.resolve_formula_order : variables.resolve_unknown;
  try {
    if (!found) return this->output(*output, static_cast<double>(*value), variables);
    return resolve(*found, static_cast<double>(*value));
  } catch (const std::invalid_argument&) {
    if (!may_be_absent) throw;
    return pool_.variable(absent_variable);
  }
}

Expression FileFormulas::component(std::string_view name, int index, const FormulaVariables& variables,
                                   Absent absent) {
  const auto* vector = vector_named(text_, name);
  if (vector == nullptr) {
    if (absent == Absent::is_a_variable && is_left_out(text_, name)) return pool_.variable(absent_variable);
    throw std::invalid_argument(fmt::format("{}: must be a vector, an unknown with size", name));
  }
  if (!contains(*vector, index)) return outside(*vector, index);
  return variables.resolve_unknown(vector->first + static_cast<std::size_t>(index) - 1, 0.0);
}

// The value of a component beyond the first or the last one.
Expression FileFormulas::outside(const VectorText& vector, int index) {
  if (!vector.outside) {
    throw std::invalid_argument(
        fmt::format("{}[{}]: must have an index from 1 to {}; for another one {} must have the key outside, "
                    "as outside = \"0\"",
                    vector.name, index, vector.size, vector.name));
  }
  FormulaText value = *vector.outside;
  value.index = index;
  value.size = vector.size;
  return read(value, {});
}

Expression FileFormulas::earlier(Expression of, Expression time, const FormulaVariables& variables) {
  const auto rate = pool_.depends_on_unknowns(time) ? std::nullopt : value(pool_.derivative(time, 0));
  const auto before_now = pool_.make_expression(Operation::subtract, this->time(), time);
  const auto lag = value(pool_.without_variables(before_now, 0));
  // sign, step and floor have the derivative 0.
  const bool may_jump = !pool_.arguments({time}, jumps).empty();
  if (rate != 1.0L || may_jump || !lag || !(*lag > 0.0L))
    throw std::invalid_argument("its time must be t - tau, tau a formula of the parameters above 0");
  if (of == pool_.variable(absent_variable)) return of;
  const auto since_start = pool_.make_expression(Operation::subtract, pool_.variable(0), before_now);
  if (!pool_.depends_on_unknowns(of)) {  // outside of a vector: a formula of t
    return pool_.substituted(
        {of}, [&](int variable) { return variable == 0 ? since_start : pool_.variable(variable); })[0];
  }
  return variables.earlier(of, static_cast<double>(*lag));
}

// D^order of the output: the state and its derivatives are 0 at the start, so that orders add up.
Expression FileFormulas::output(const OutputText& of, double order, const FormulaVariables& variables) {
  if (variables.resolve_output) {
    const auto known =
        order == 0.0 ? variables.resolve_output(of.weighted ? of.weighted->name : of.name) : std::nullopt;
    if (!known)
      throw std::invalid_argument(fmt::format("D({}, {}): must be a column of the scene", of.name, order));
    if (!of.weighted) return *known;
    if (!variables.time)
      throw std::invalid_argument(fmt::format("{}: must not occur here, it is infinite at t = 0", of.name));
    return (Operand{&pool_, *known} * Operand{&pool_, read(of.weighted->scale, {})}).value;
  }
  if (of.of_time && order != 0.0) {
    throw std::invalid_argument(
        fmt::format("D({}, {}): is not supported where a Riemann-Liouville derivative makes {} infinite at 0",
                    of.name, order, of.name));
  }
  const auto state = unknown_named(text_, of.state).value();
  Operand sum{&pool_, of.of_time ? read(*of.of_time, {}) : pool_.number(0)};
  for (const auto& term : of.terms) {
    const Operand coefficient{&pool_, read(term.coefficient, {.time = false})};
    const double own_order = constant(term.order, "order", any_number);
    sum = sum + coefficient * Operand{&pool_, variables.resolve_unknown(state, own_order + order)};
  }
  return sum.value;
}

std::optional<long double> FileFormulas::value(Expression of) {
  if (as_ == ParametersAs::values) return pool_.value(of);
  return pool_.value(pool_.substituted({of}, [&](int variable) {
    const auto name = parameter_name(variable);
    return name.empty() ? pool_.variable(variable) : pool_.number(fmt::format("{}", parameters_[name]));
  })[0]);
}

std::string FileFormulas::parameter_name(int variable) const {
  const auto number = static_cast<std::size_t>(variable) - first_parameter;
  return variable >= first_parameter && number < text_.parameters.size()
             ? text_.parameters[number].declared.name
             : "";
}

std::string FileFormulas::order_text(double order) const {
  const auto found = order_texts_.find(order);
  return found == order_texts_.end() ? fmt::format("{}", order) : found->second;
}

double FileFormulas::constant(const FormulaText& formula, std::string_view name, const Range& allowed) {
  const auto known = read(formula, {.time = false});
  return with_exact(known, require_in(allowed, static_cast<double>(value(known).value()), formula, name));
}

double FileFormulas::start() { return text_.start ? constant(*text_.start, "start", not_negative) : 0.0; }

double FileFormulas::end() { return time_after_start(text_.end, "end", valid_end_times); }

double FileFormulas::time_after_start(const FormulaText& formula, std::string_view name,
                                      const Range& allowed) {
  const double time = constant(formula, name, allowed);
  if (!text_.start) return time;
  if (!(time > start()))
    reject(formula, fmt::format("{} = {}: must be above start = {}", name, time, start()));
  const auto after = pool_.make_expression(Operation::subtract, read(formula, {.time = false}),
                                           read(*text_.start, {.time = false}));
  return with_exact(after, static_cast<double>(value(after).value()));
}

double FileFormulas::with_exact(Expression exact, double value) {
  if (pool_.has_fractions()) pool_.add_constant(value, exact);
  return value;
}

double FileFormulas::constant_in_double(const FormulaText& formula, std::string_view name,
                                        const Range& allowed) {
  FileFormulas unfolded(text_, parameters_, NumberStorage::decimals);
  const auto written = unfolded.read(formula, {.time = false});
  const double value = Program(unfolded.pool(), {written}, 0)(0.0, Vec());
  return with_exact(read(formula, {.time = false}), require_in(allowed, value, formula, name));
}

double FileFormulas::require_in(const Range& allowed, double value, const FormulaText& formula,
                                std::string_view name) const {
  if (!allowed.contains(value))
    reject(formula, fmt::format("{} = {}: must be {}", name, value, allowed.text()));
  return value;
}

void FileFormulas::require_parameters() {
  using Condition = RequirementText::Condition;
  for (const auto& [name, allowed, condition, formula, unless] : text_.requirements) {
    const auto value = pool_.value(read(formula, {.time = false})).value();
    const bool holds = condition == Condition::not_zero      ? value != 0
                       : condition == Condition::is_positive ? value > 0
                                                             : value >= 0;
    if (!holds) fde::bench::reject(name, parameters_.value(name), allowed);
  }
}

}  // namespace fde::bench
