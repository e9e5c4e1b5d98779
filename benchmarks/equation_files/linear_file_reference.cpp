// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/linear_file_reference.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>
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

std::optional<std::vector<reference::Load>> loads_of(Expression rhs, ExpressionPool& pool,
                                                     DecimalRounding& decimals) {
  const auto terms = time_terms(pool.without_variables(rhs, 1), pool);
  if (!terms) return std::nullopt;
  std::vector<reference::Load> loads;
  for (const auto& [coefficient, power, from] : *terms) {
    const auto size = pool.value(coefficient), exponent = pool.value(power);
    if (!size || !exponent) return std::nullopt;
    if (*size == 0.0L) continue;
    loads.push_back({.coefficient = decimals.take(*size), .power = decimals.take(*exponent)});
    if (from) loads.back().start_time = decimals.take(pool.value(*from).value());
    if (validation_error(loads.back())) return std::nullopt;
  }
  return loads;
}

// A single unknown: its terms, and its coefficients in the right-hand side.
std::optional<reference::Reference> single_equation_reference(const EquationSystem& system,
                                                              const std::vector<double>& orders,
                                                              ExpressionPool& pool,
                                                              DecimalRounding& decimals) {
  const auto& unknown = system.unknowns.front();
  const auto& chain = *unknown.chain;
  reference::LinearEquation equation{.terms = {{chain.leading().coefficient, chain.leading().order}},
                                     .initial = chain.initial()};
  for (Eigen::Index i = 0; i < chain.size(); ++i) {
    const auto slope = pool.derivative(*unknown.rhs, static_cast<int>(i) + 1);
    const auto taken = pool.value(pool.without_variables(slope, 0));
    if (!taken) return std::nullopt;
    equation.terms.push_back({chain.coefficients()[i], chain.nodes()[static_cast<std::size_t>(i)]});
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
  const double difference = std::stod(fmt::format("{:.{}g}", upper - lower, digits));
  const auto units = [](double x) { return std::llround(static_cast<long double>(x) * places); };
  const bool is_exact = units(lower) + units(difference) == units(upper) &&
                        fmt::format("{}", lower).size() <= digits &&
                        fmt::format("{}", upper).size() <= digits;
  return is_exact ? std::optional(difference) : std::nullopt;
}

std::optional<reference::Reference> system_reference(const EquationSystem& system, const Problem& problem,
                                                     const std::vector<std::size_t>& outputs,
                                                     ExpressionPool& pool, DecimalRounding& decimals) {
  reference::LinearSystem rows{.orders = {}, .initial = {}, .matrix = {}, .outputs = outputs};
  rows.matrix = Matrix::Zero(problem.size(), problem.size());
  for (const auto& unknown : system.unknowns) {
    const auto nodes = unknown.chain ? unknown.chain->nodes() : std::vector{0.0};
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const double top = unknown.chain ? unknown.chain->leading().order : 0.0;
      const auto order = decimal_order(nodes[i], i + 1 < nodes.size() ? nodes[i + 1] : top);
      if (!order) return std::nullopt;
      rows.orders.push_back(*order);
    }
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

}  // namespace

std::optional<reference::Reference> linear_file_reference(const EquationSystem& system,
                                                          const Problem& problem, ExpressionPool& pool) {
  if (!is_linear(problem) || system.rows.size() > most_rows) return std::nullopt;
  std::vector<double> orders;
  std::vector<std::size_t> rows;
  for (const auto& column : columns_of(system)) {
    orders.push_back(column.order);
    rows.push_back(static_cast<std::size_t>(column.row));
  }
  const auto motion = [&](DecimalRounding& decimals) {
    const bool single = system.unknowns.size() == 1 && system.unknowns.front().chain;
    return single ? single_equation_reference(system, orders, pool, decimals)
                  : system_reference(system, problem, rows, pool, decimals);
  };
  constexpr double times = 1 << 20;
  DecimalRounding decimals, moved_decimals(times);
  try {
    auto known = motion(decimals);
    if (!known || decimals.all()) return known;
    const auto moved = motion(moved_decimals);
    return moved ? std::optional(with_decimal_error(std::move(*known), *moved, times)) : std::nullopt;
  } catch (const std::invalid_argument&) {  // e.g. if the algebraic rows do not determine every unknown
    return std::nullopt;
  }
}

}  // namespace fde::bench
