// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "fdebench/benchmarks/equation_files/equation_system.hpp"
#include "fdebench/benchmarks/expressions/expression_problem.hpp"
#include "fdebench/benchmarks/expressions/program.hpp"
#include "fdebench/schemes/problem/multipliers.hpp"

namespace fde::bench {
namespace {

std::size_t unknown_of_row(const EquationSystem& system, Eigen::Index row) {
  const auto after = std::ranges::upper_bound(system.unknowns, row, {}, &EquationSystem::Unknown::first);
  return static_cast<std::size_t>(after - system.unknowns.begin()) - 1;
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
  require_start_on_constraints(system, problem, formulas);
  for (const auto& unknown : system.unknowns) {
    if (!unknown.chain || unknown.chain->size() == 1) continue;
    const auto& chain = *unknown.chain;
    const Program force(pool, {*unknown.rhs}, size);
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
