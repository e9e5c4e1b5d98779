// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "fdebench/benchmarks/equation_files/equation_system.hpp"
#include "fdebench/benchmarks/expressions/expression_problem.hpp"
#include "fdebench/benchmarks/expressions/formula_text.hpp"
#include "fdebench/benchmarks/expressions/program.hpp"
#include "fdebench/benchmarks/expressions/values_at_start.hpp"
#include "fdebench/schemes/problem/multipliers.hpp"

namespace fde::bench {
namespace {

std::size_t unknown_of_row(const EquationSystem& system, Eigen::Index row) {
  const auto after = std::ranges::upper_bound(system.unknowns, row, {}, &EquationSystem::Unknown::first);
  return static_cast<std::size_t>(after - system.unknowns.begin()) - 1;
}

// t, or D^order of an unknown.
std::string name_of(int variable, const EquationSystem& system) {
  for (const auto& column : columns_of(system))
    if (column.row == variable - 1) return column.name;
  return "t";
}

// A violated constraint would require a jump of the unknowns at t = 0.
void require_start_on_constraints(const EquationSystem& system, const Problem& problem,
                                  const FileFormulas& formulas) {
  const auto row = inconsistent_initial_row(problem);
  if (!row) return;
  Vec f(problem.size());
  problem.rhs(0.0, taylor_part(problem, 0.0), f);
  formulas.reject(formulas.text().unknowns[unknown_of_row(system, *row)].rhs,
                  fmt::format("is {:.6g} at t = 0: must be 0 with these initial values", f[*row]));
}

// A right-hand side that is no number at t = 0, nor next to it, is a mistake in the formula: the root of a
// negative number, or 0 times infinity.
void require_numbers_at_start(const EquationSystem& system, const Problem& problem, FileFormulas& formulas) {
  constexpr double next_to_start = 1e-9;
  const auto& pool = formulas.pool();
  const auto rows = with_limits_at_start(system.rows, formulas.pool());
  const Vec start = taylor_part(problem, 0.0);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto part = not_a_number(rows[i], 0.0, start, pool);
    if (!part || !not_a_number(rows[i], next_to_start * system.end, start, pool)) continue;
    std::vector<std::string> values;
    for (const double y : start) values.push_back(fmt::format("{:.6g}", y));
    const auto row = static_cast<Eigen::Index>(i);
    formulas.reject(
        formulas.text().unknowns[unknown_of_row(system, row)].rhs,
        fmt::format("{} is not a number at t = 0 with the initial values {}: must be one",
                    formula_text(pool, *part, [&](int variable) { return name_of(variable, system); }),
                    fmt::join(values, ", ")));
  }
}

std::string only_text(const Program& program) {
  const auto texts = program.texts();
  return texts.empty() ? "" : texts.front();
}

std::function<double(double t, In y)> factor_of(const EquationSystem::Unknown& unknown,
                                                const ExpressionPool& pool, Eigen::Index size) {
  if (!unknown.factor) return [](double, In) { return 1.0; };
  return Program(pool, {*unknown.factor}, size);
}

}  // namespace

Problem problem_of(const EquationSystem& system, FileFormulas& formulas) {
  const auto size = system.size();
  auto& pool = formulas.pool();
  Problem problem = [&] {
    try {
      return expression_problem(system.components, system.rows, system.end, pool);
    } catch (const DerivativeError& none) {
      formulas.reject(formulas.text().unknowns[unknown_of_row(system, none.row)].rhs, none.what());
    }
  }();
  require_numbers_at_start(system, problem, formulas);
  require_start_on_constraints(system, problem, formulas);
  for (const auto& unknown : system.unknowns) {
    if (!unknown.chain || unknown.chain->size() == 1) continue;
    const auto& chain = *unknown.chain;
    const Program force(pool, with_limits_at_start({*unknown.rhs}, pool), size);
    problem.equations.push_back({.first_row = chain.first_row(),
                                 .leading = chain.leading(),
                                 .terms = chain.terms(),
                                 .force = force,
                                 .factor = factor_of(unknown, pool, size)});
    if (!unknown.factor) problem.equations.back().force_text = [force] { return only_text(force); };
  }
  return problem;
}

}  // namespace fde::bench
