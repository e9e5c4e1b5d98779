// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/linear_file_reference.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/equation_files/rounded_values.hpp"
#include "fdebench/benchmarks/expressions/expressions.hpp"
#include "fdebench/benchmarks/expressions/time_terms.hpp"
#include "fdebench/reference/linear/linear_equation.hpp"
#include "fdebench/reference/linear/linear_system.hpp"
#include "fdebench/reference/linear/values_at_end.hpp"
#include "fdebench/reference/special_functions/numbers/rational.hpp"

namespace fde::bench {

namespace {

// A number as a fraction: itself, or, as for sqrt(2), a fraction so near to it that no double shows the
// difference.
struct ExactNumber {
  reference::Rational value;
  bool is_exact;
};

// The value of an expression without variables. Precondition: the pool has fractions. nullopt if it contains
// a variable or is not finite.
std::optional<ExactNumber> exact_number(Expression of, const ExpressionPool& pool) {
  // More digits than the exponents of doubles have: cancellation of numbers of any size leaves a double.
  constexpr int digits = 700;
  const auto& node = pool[of];
  if (node.operation == Operation::number && !node.text.empty())
    return ExactNumber{reference::Rational(node.text), true};
  if (const auto about = pool.value(of); !about || !std::isfinite(*about)) return std::nullopt;
  const reference::Precision precision(digits);
  const auto [value, size] = rounded_values(pool, {of}, reference::BigReal(0)).front();
  if (!isfinite(value)) return std::nullopt;
  if (value == 0 && size == 0) return ExactNumber{reference::Rational(0), true};  // 0/gamma(x), for example
  const auto rounding = reference::BigReal(reference::closed_form_rounding_factor *
                                           reference::epsilon<reference::BigReal>() * size);
  return ExactNumber{abs(value) <= rounding ? reference::Rational(0) : reference::fraction_of(value), false};
}

constexpr std::size_t most_rows = 12;

using reference::Rational;

// Thrown where a coefficient depends on a variable or is not finite: the equations are of another kind.
struct NoNumber {};

// Reads numbers and records whether each is a fraction.
class ExactNumbers {
 public:
  explicit ExactNumbers(ExpressionPool& pool) : pool_(pool) {}

  Rational of(Expression e) {
    const auto number = exact_number(e, pool_);
    if (!number) throw NoNumber{};
    all_exact_ = all_exact_ && number->is_exact;
    return number->value;
  }
  Rational of(double nearest) { return of(pool_.number(nearest)); }
  // A time that a reference takes as its shortest decimal.
  void require_decimal(double time) {
    all_exact_ = all_exact_ && of(time) == reference::shortest_decimal(time);
  }
  [[nodiscard]] bool all_exact() const { return all_exact_; }

 private:
  ExpressionPool& pool_;
  bool all_exact_ = true;
};

// The fraction, if the expression is one.
std::optional<Rational> fraction(Expression e, const ExpressionPool& pool) {
  if (pool[e].operation != Operation::number) return std::nullopt;
  return exact_number(e, pool)->value;
}

// The factors of a product, without 1 and powers of 1.
std::vector<Expression> factors_of(Expression e, const ExpressionPool& pool) {
  const auto& [first, second, third] = pool[e].arguments;
  if (pool[e].operation == Operation::multiply) {
    auto factors = factors_of(first, pool);
    for (const auto factor : factors_of(second, pool)) factors.push_back(factor);
    return factors;
  }
  const bool is_one = fraction(e, pool) == Rational(1);
  const bool is_power_of_one = pool[e].operation == Operation::power && fraction(first, pool) == Rational(1);
  return is_one || is_power_of_one ? std::vector<Expression>{} : std::vector{e};
}

// c/gamma(p + 1): the c.
std::optional<Rational> over_gamma(Expression coefficient, const Rational& power,
                                   const ExpressionPool& pool) {
  const auto factors = factors_of(coefficient, pool);
  if (factors.empty() || factors.size() > 2) return std::nullopt;
  const auto& [one, of_gamma, third] = pool[factors.back()].arguments;
  if (pool[factors.back()].operation != Operation::divide || fraction(one, pool) != Rational(1))
    return std::nullopt;
  if (pool[of_gamma].operation != Operation::gamma) return std::nullopt;
  if (fraction(pool[of_gamma].arguments[0], pool) != Rational(power + 1)) return std::nullopt;
  return factors.size() == 1 ? Rational(1) : fraction(factors.front(), pool);
}

std::optional<std::vector<reference::LoadOf<Rational>>> loads_of(Expression rhs, double end,
                                                                 ExpressionPool& pool,
                                                                 ExactNumbers& numbers) {
  const auto terms = time_terms(pool.without_variables(rhs, 1), pool, end);
  if (!terms) return std::nullopt;
  std::vector<reference::LoadOf<Rational>> loads;
  for (const auto& [coefficient, power, from] : *terms) {
    const auto exponent = fraction(power, pool);
    const Rational p = exponent ? *exponent : numbers.of(power);
    const auto divided = over_gamma(coefficient, p, pool);
    const Rational size = divided ? *divided : numbers.of(coefficient);
    if (size == 0) continue;
    if (p <= -1) return std::nullopt;
    loads.push_back({.coefficient = size, .power = p, .over_gamma = divided.has_value()});
    if (from) loads.back().start_time = numbers.of(*from);
  }
  return loads;
}

// tau, if the factors are tau^order: tau itself, tau*tau, or a power.
std::optional<Rational> base_of_power(std::span<const Expression> factors, const Rational& order,
                                      const ExpressionPool& pool) {
  if (factors.empty()) return Rational(1);
  const auto& [base, exponent, third] = pool[factors[0]].arguments;
  if (pool[factors[0]].operation == Operation::power) {
    const bool is_order = factors.size() == 1 && fraction(exponent, pool) == order;
    return is_order ? fraction(base, pool) : std::nullopt;
  }
  const bool all_same = std::ranges::all_of(factors, [&](Expression e) { return e == factors[0]; });
  return all_same && order == Rational(factors.size()) ? fraction(factors[0], pool) : std::nullopt;
}

// The term c D^q u, with c as a fraction, or as a product c tau^q of two.
reference::LinearTermOf<Rational> term_of(Expression coefficient, const Rational& order,
                                          const ExpressionPool& pool, ExactNumbers& numbers) {
  if (const auto number = fraction(coefficient, pool)) return {*number, order};
  const auto factors = factors_of(coefficient, pool);
  const std::span all(factors);
  const auto whole = base_of_power(all, order, pool);
  if (whole && *whole > 0) return {1, order, *whole};
  const auto size = all.empty() ? std::nullopt : fraction(all.front(), pool);
  const auto scale = all.empty() ? std::nullopt : base_of_power(all.subspan(1), order, pool);
  if (size && scale && *scale > 0) return {*size, order, *scale};
  return {numbers.of(coefficient), order};
}

// The outputs of a solution, by the values at the end where these are given.
reference::Reference with_ends(reference::SolutionByInitialValues solution,
                               const std::vector<ValueAtEnd>& final, double end, ExactNumbers& numbers) {
  if (final.empty()) return solution.outputs({});
  std::vector<Rational> values;
  for (const auto& [row, value] : final) values.push_back(numbers.of(value));
  numbers.require_decimal(end);
  return reference::with_values_at_end(std::move(solution), end, std::move(values));
}

// A single unknown: its terms, and its coefficients in the right-hand side.
std::optional<reference::Reference> single_equation_reference(const EquationSystem& system,
                                                              const UnknownText& text, FileFormulas& formulas,
                                                              const std::vector<double>& orders,
                                                              ExactNumbers& numbers) {
  auto& pool = formulas.pool();
  const auto& unknown = system.unknowns.front();
  const auto& chain = *unknown.chain;
  reference::LinearEquationOf<Rational> equation;
  for (const double value : chain.initial()) equation.initial.push_back(numbers.of(value));
  for (std::size_t k = 0; k < text.terms.size(); ++k) {
    const double order = formulas.constant(text.terms[k].order, "order", any_number);
    equation.terms.push_back(term_of(unknown.coefficients[k], numbers.of(order), pool, numbers));
  }
  for (Eigen::Index i = 0; i < chain.size(); ++i) {
    const auto slope = pool.derivative(*unknown.rhs, static_cast<int>(i) + 1);
    const Rational taken = numbers.of(pool.without_variables(slope, 0));
    equation.terms.push_back({Rational(-taken), numbers.of(chain.nodes()[static_cast<std::size_t>(i)])});
  }
  auto loads = loads_of(*unknown.rhs, system.end, pool, numbers);
  if (!loads) return std::nullopt;
  equation.loads = std::move(*loads);
  std::vector<Rational> wanted, given_at_end;
  for (const double order : orders) wanted.push_back(numbers.of(order));
  for (const auto& [row, value] : system.final)
    given_at_end.push_back(numbers.of(chain.nodes()[static_cast<std::size_t>(row)]));
  const auto solution = [&equation](const std::vector<Rational>& derivatives) {
    return [equation, derivatives](const std::vector<Rational>& missing) {
      auto complete = equation;
      std::ranges::copy(missing, std::back_inserter(complete.initial));
      return reference::exact_linear_reference(complete, derivatives);
    };
  };
  return with_ends({solution(wanted), solution(given_at_end)}, system.final, system.end, numbers);
}

// The rows of a system as a function of its unknown initial values.
std::function<reference::Reference(const std::vector<Rational>& unknown)> solution_of(
    reference::ExactLinearSystem rows, const std::vector<Component>& components,
    std::vector<std::size_t> outputs) {
  rows.outputs = std::move(outputs);
  return [rows, components](const std::vector<Rational>& unknown) {
    auto complete = rows;
    std::size_t next = 0;
    for (std::size_t i = 0; i < components.size(); ++i) {
      for (auto k = components[i].initial.size(); k < initial_count(components[i].order); ++k)
        complete.initial[i].push_back(unknown[next++]);
    }
    return reference::exact_linear_reference(complete);
  };
}

std::optional<reference::Reference> system_reference(const LinearRows& system, ExpressionPool& pool,
                                                     ExactNumbers& numbers) {
  reference::ExactLinearSystem rows;
  for (const auto& [lower, upper] : system.orders)
    rows.orders.push_back(Rational(numbers.of(upper) - numbers.of(lower)));
  for (std::size_t i = 0; i < system.rows.size(); ++i) {
    const auto& component = system.components[i];
    auto& initial = rows.initial.emplace_back();
    if (const auto computed = system.initial.find(i); computed != system.initial.end()) {
      initial.push_back(numbers.of(computed->second));
    } else if (!is_algebraic(component)) {
      for (const double value : component.initial) initial.push_back(numbers.of(value));
    }
    auto loads = loads_of(system.rows[i], system.end, pool, numbers);
    if (!loads) return std::nullopt;
    rows.loads.push_back(std::move(*loads));
    auto& row = rows.matrix.emplace_back();
    for (std::size_t j = 0; j < system.rows.size(); ++j) {
      const auto slope = pool.derivative(system.rows[i], static_cast<int>(j) + 1);
      const bool own = i == j && is_algebraic(component);  // 0 = f is written as x = x + f
      row.push_back(Rational(numbers.of(pool.without_variables(slope, 0)) + (own ? 1 : 0)));
    }
  }
  std::vector<std::size_t> given_at_end;
  for (const auto& [row, value] : system.final) given_at_end.push_back(static_cast<std::size_t>(row));
  return with_ends({solution_of(rows, system.components, system.outputs),
                    solution_of(rows, system.components, given_at_end)},
                   system.final, system.end, numbers);
}

LinearRows rows_of(const EquationSystem& system, const std::vector<std::size_t>& outputs) {
  LinearRows rows{.components = system.components,
                  .rows = system.rows,
                  .outputs = outputs,
                  .final = system.final,
                  .end = system.end};
  for (const auto& unknown : system.unknowns) {
    const auto nodes = unknown.chain ? unknown.chain->nodes() : std::vector{0.0};
    const double top = unknown.chain ? unknown.chain->leading().order : 0.0;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      rows.orders.emplace_back(nodes[i], i + 1 < nodes.size() ? nodes[i + 1] : top);
  }
  return rows;
}

// The reference that `motion` makes of exact numbers.
template <class Motion>
std::optional<reference::Reference> with_exact_numbers(ExpressionPool& pool, const Motion& motion) {
  ExactNumbers numbers(pool);
  try {
    std::optional<reference::Reference> known = motion(numbers);
    if (known && !numbers.all_exact()) known->digits = {};
    return known;
  } catch (const NoNumber&) {
    return std::nullopt;
  } catch (const std::invalid_argument&) {  // e.g. if the algebraic rows do not determine every unknown
    return std::nullopt;
  }
}

}  // namespace

std::optional<reference::Reference> linear_rows_reference(const LinearRows& rows, ExpressionPool& pool) {
  if (rows.rows.size() > most_rows) return std::nullopt;
  return with_exact_numbers(pool,
                            [&](ExactNumbers& numbers) { return system_reference(rows, pool, numbers); });
}

std::optional<reference::Reference> linear_file_reference(const EquationText& text,
                                                          const Parameters& parameters,
                                                          const Problem& problem,
                                                          const std::vector<SystemColumn>& columns) {
  if (!is_linear(problem)) return std::nullopt;
  FileFormulas formulas(text, parameters, NumberStorage::fractions);
  const EquationSystem system = read_system(formulas);
  const auto& first = system.unknowns.front();
  const bool single = system.unknowns.size() == 1 && first.chain && !first.factor;
  std::vector<double> orders;
  std::vector<std::size_t> rows;
  for (const auto& column : columns) {
    if (!single && column.row < 0) return std::nullopt;
    orders.push_back(column.order);
    rows.push_back(static_cast<std::size_t>(column.row));
  }
  if (!single) return linear_rows_reference(rows_of(system, rows), formulas.pool());
  return with_exact_numbers(formulas.pool(), [&](ExactNumbers& numbers) {
    return single_equation_reference(system, text.unknowns.front(), formulas, orders, numbers);
  });
}

}  // namespace fde::bench
