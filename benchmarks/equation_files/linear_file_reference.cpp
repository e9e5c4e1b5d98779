// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/linear_file_reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/expressions/time_terms.hpp"
#include "fdebench/reference/linear/linear_equation.hpp"
#include "fdebench/reference/linear/linear_system.hpp"

namespace fde::bench {
namespace {

constexpr std::size_t most_rows = 12;

// Converts long double numbers to doubles and records whether each equals the shortest decimal of its double.
// With a nonzero `times`, each number is perturbed by `times` the difference to its decimal.
class DecimalRounding {
 public:
  explicit DecimalRounding(double times = 0.0) : times_(times) {}

  double take(long double value) {
    constexpr long double few_ulps = 8.0L * std::numeric_limits<long double>::epsilon();
    const auto nearest = static_cast<double>(value);
    const auto text = fmt::format("{}", nearest);
    long double named = 0.0L;
    std::from_chars(text.data(), text.data() + text.size(), named);
    all_ = all_ && std::abs(named - value) <= few_ulps * std::abs(value);
    return times_ == 0.0 ? nearest : static_cast<double>(value + times_ * (value - named));
  }
  [[nodiscard]] bool all() const { return all_; }

 private:
  double times_;
  bool all_ = true;
};

// The number, if the expression is one.
std::optional<double> decimal_of(Expression e, const ExpressionPool& pool) {
  if (pool[e].operation != Operation::number) return std::nullopt;
  return static_cast<double>(pool[e].value);
}

// The factors of a product, without 1 and powers of 1.
std::vector<Expression> factors_of(Expression e, const ExpressionPool& pool) {
  const auto& [first, second, third] = pool[e].arguments;
  if (pool[e].operation == Operation::multiply) {
    auto factors = factors_of(first, pool);
    for (const auto factor : factors_of(second, pool)) factors.push_back(factor);
    return factors;
  }
  const bool is_one = decimal_of(e, pool) == 1.0;
  const bool is_power_of_one = pool[e].operation == Operation::power && decimal_of(first, pool) == 1.0;
  return is_one || is_power_of_one ? std::vector<Expression>{} : std::vector{e};
}

// c/gamma(p + 1): the c.
std::optional<double> over_gamma(Expression coefficient, long double power, const ExpressionPool& pool) {
  constexpr long double few_ulps = 8.0L * std::numeric_limits<long double>::epsilon();
  const auto factors = factors_of(coefficient, pool);
  if (factors.empty() || factors.size() > 2) return std::nullopt;
  const auto& [one, of_gamma, third] = pool[factors.back()].arguments;
  if (pool[factors.back()].operation != Operation::divide || decimal_of(one, pool) != 1.0)
    return std::nullopt;
  if (pool[of_gamma].operation != Operation::gamma) return std::nullopt;
  const auto argument = pool.value(pool[of_gamma].arguments[0]).value();
  if (std::abs(argument - power - 1.0L) > few_ulps * argument) return std::nullopt;
  return factors.size() == 1 ? 1.0 : decimal_of(factors.front(), pool);
}

std::optional<std::vector<reference::Load>> loads_of(Expression rhs, ExpressionPool& pool,
                                                     DecimalRounding& decimals) {
  const auto terms = time_terms(pool.without_variables(rhs, 1), pool);
  if (!terms) return std::nullopt;
  std::vector<reference::Load> loads;
  for (const auto& [coefficient, power, from] : *terms) {
    const auto size = pool.value(coefficient), exponent = pool.value(power);
    if (!size || !exponent) return std::nullopt;
    if (*size == 0.0L) continue;
    const auto divided = over_gamma(coefficient, *exponent, pool);
    loads.push_back({.coefficient = divided ? *divided : decimals.take(*size),
                     .power = decimals.take(*exponent),
                     .over_gamma = divided.has_value()});
    if (from) loads.back().start_time = decimals.take(pool.value(*from).value());
    if (validation_error(loads.back())) return std::nullopt;
  }
  return loads;
}

// tau, if the factors are tau^order: tau itself, tau*tau, or a power.
std::optional<double> base_of_power(std::span<const Expression> factors, double order,
                                    const ExpressionPool& pool) {
  if (factors.empty()) return 1.0;
  const auto& [base, exponent, third] = pool[factors[0]].arguments;
  if (pool[factors[0]].operation == Operation::power) {
    const bool is_order = factors.size() == 1 && static_cast<double>(pool.value(exponent).value()) == order;
    return is_order ? decimal_of(base, pool) : std::nullopt;
  }
  const bool all_same = std::ranges::all_of(factors, [&](Expression e) { return e == factors[0]; });
  return all_same && order == static_cast<double>(factors.size()) ? decimal_of(factors[0], pool)
                                                                  : std::nullopt;
}

// The term c D^q u, with c as a decimal, or as a product c tau^q of two.
reference::LinearTerm term_of(Expression coefficient, double order, const ExpressionPool& pool,
                              DecimalRounding& decimals) {
  if (const auto number = decimal_of(coefficient, pool)) return {*number, order};
  const auto factors = factors_of(coefficient, pool);
  const std::span all(factors);
  const auto whole = base_of_power(all, order, pool);
  if (whole && *whole > 0.0) return {1.0, order, *whole};
  const auto size = all.empty() ? std::nullopt : decimal_of(all.front(), pool);
  const auto scale = all.empty() ? std::nullopt : base_of_power(all.subspan(1), order, pool);
  if (size && scale && *scale > 0.0) return {*size, order, *scale};
  return {decimals.take(pool.value(coefficient).value()), order};
}

// A single unknown: its terms, and its coefficients in the right-hand side.
std::optional<reference::Reference> single_equation_reference(const EquationSystem& system,
                                                              const UnknownText& text, FileFormulas& formulas,
                                                              const std::vector<double>& orders,
                                                              DecimalRounding& decimals) {
  auto& pool = formulas.pool();
  const auto& unknown = system.unknowns.front();
  const auto& chain = *unknown.chain;
  reference::LinearEquation equation{.terms = {}, .initial = chain.initial()};
  for (std::size_t k = 0; k < text.terms.size(); ++k) {
    const double order = formulas.constant(text.terms[k].order, "order", any_number);
    equation.terms.push_back(term_of(unknown.coefficients[k], order, pool, decimals));
  }
  for (Eigen::Index i = 0; i < chain.size(); ++i) {
    const auto slope = pool.derivative(*unknown.rhs, static_cast<int>(i) + 1);
    const auto taken = pool.value(pool.without_variables(slope, 0));
    if (!taken) return std::nullopt;
    equation.terms.push_back({-decimals.take(*taken), chain.nodes()[static_cast<std::size_t>(i)]});
  }
  auto loads = loads_of(*unknown.rhs, pool, decimals);
  if (!loads) return std::nullopt;
  equation.loads = std::move(*loads);
  return reference::linear_reference(equation, orders);
}

// The order of a component, a difference of two nodes of a chain, without rounding; nullopt if it is not a
// decimal of at most 15 digits.
std::optional<double> decimal_order(double lower, double upper) {
  constexpr int digits = 15;
  constexpr double places = 1e15;
  if (lower == 0.0) return upper;
  const double difference = std::stod(fmt::format("{:.{}g}", upper - lower, digits));
  const auto units = [](double x) { return std::llround(static_cast<long double>(x) * places); };
  const bool is_exact = units(lower) + units(difference) == units(upper) &&
                        fmt::format("{}", lower).size() <= digits &&
                        fmt::format("{}", upper).size() <= digits;
  return is_exact ? std::optional(difference) : std::nullopt;
}

std::optional<reference::Reference> system_reference(const LinearRows& system, ExpressionPool& pool,
                                                     DecimalRounding& decimals) {
  const auto size = std::ssize(system.rows);
  reference::LinearSystem rows{
      .orders = {}, .initial = {}, .matrix = Matrix::Zero(size, size), .outputs = system.outputs};
  for (const auto& [lower, upper] : system.orders) {
    const auto order = decimal_order(lower, upper);
    if (!order) return std::nullopt;
    rows.orders.push_back(*order);
  }
  for (std::size_t i = 0; i < system.rows.size(); ++i) {
    const auto& component = system.components[i];
    rows.initial.push_back(is_algebraic(component) ? std::vector<double>{} : component.initial);
    auto loads = loads_of(system.rows[i], pool, decimals);
    if (!loads) return std::nullopt;
    rows.loads.push_back(std::move(*loads));
    for (std::size_t j = 0; j < system.rows.size(); ++j) {
      const auto slope = pool.derivative(system.rows[i], static_cast<int>(j) + 1);
      const auto value = pool.value(pool.without_variables(slope, 0));
      if (!value) return std::nullopt;
      const bool own = i == j && is_algebraic(component);  // 0 = f is written as x = x + f
      rows.matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) =
          decimals.take(*value + (own ? 1.0L : 0.0L));
    }
  }
  return reference::linear_reference(rows);
}

LinearRows rows_of(const EquationSystem& system, const std::vector<std::size_t>& outputs) {
  LinearRows rows{.orders = {}, .components = system.components, .rows = system.rows, .outputs = outputs};
  for (const auto& unknown : system.unknowns) {
    const auto nodes = unknown.chain ? unknown.chain->nodes() : std::vector{0.0};
    const double top = unknown.chain ? unknown.chain->leading().order : 0.0;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      rows.orders.emplace_back(nodes[i], i + 1 < nodes.size() ? nodes[i + 1] : top);
  }
  return rows;
}

// Adds to the bound the effect of replacing numbers by decimals. In `moved` each number is perturbed by
// `times` its difference to the decimal, so the error of `moved` is `times` that of the reference, to first
// order.
reference::Reference with_decimal_error(reference::Reference decimal, const reference::Reference& moved,
                                        double times) {
  constexpr double second_order = 1.01;
  decimal.at = [at = decimal.at, moved = moved.at, times](double t) {
    reference::ReferenceValue known = at(t);
    const reference::ReferenceValue other = moved(t);
    known.bound +=
        second_order / times * ((other.value - known.value).cwiseAbs() + other.bound + known.bound);
    return known;
  };
  decimal.digits = {};
  return decimal;
}

// The reference that `motion` makes with numbers as decimals, with the effect of this in its bound.
template <class Motion>
std::optional<reference::Reference> with_decimals(const Motion& motion) {
  constexpr double times = 1 << 20;
  DecimalRounding decimals, moved_decimals(times);
  try {
    std::optional<reference::Reference> known = motion(decimals);
    if (!known || decimals.all()) return known;
    const std::optional<reference::Reference> moved = motion(moved_decimals);
    return moved ? std::optional(with_decimal_error(std::move(*known), *moved, times)) : std::nullopt;
  } catch (const std::invalid_argument&) {  // e.g. if the algebraic rows do not determine every unknown
    return std::nullopt;
  }
}

}  // namespace

std::optional<reference::Reference> linear_rows_reference(const LinearRows& rows, ExpressionPool& pool) {
  if (rows.rows.size() > most_rows) return std::nullopt;
  return with_decimals([&](DecimalRounding& decimals) { return system_reference(rows, pool, decimals); });
}

std::optional<reference::Reference> linear_file_reference(const EquationText& text,
                                                          const Parameters& parameters,
                                                          const Problem& problem,
                                                          const std::vector<SystemColumn>& columns) {
  if (!is_linear(problem) || static_cast<std::size_t>(problem.size()) > most_rows) return std::nullopt;
  FileFormulas formulas(text, parameters, NumberStorage::decimals);
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
  return with_decimals([&](DecimalRounding& decimals) {
    return single_equation_reference(system, text.unknowns.front(), formulas, orders, decimals);
  });
}

}  // namespace fde::bench
