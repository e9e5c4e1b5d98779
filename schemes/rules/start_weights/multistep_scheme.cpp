// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/start_weights/multistep_scheme.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fdebench/schemes/history/history.hpp"
#include "fdebench/schemes/history/parallel_for_rows.hpp"
#include "fdebench/schemes/history/symbols/rule_symbols.hpp"
#include "fdebench/schemes/history/weights/weights.hpp"
#include "fdebench/schemes/rules/implicit/implicit_rule.hpp"
#include "fdebench/schemes/rules/start_weights/start_correction.hpp"
#include "fdebench/schemes/rules/start_weights/starting_procedure.hpp"
#include "fdebench/schemes/stepping/grid_jumps.hpp"
#include "fdebench/schemes/stepping/rates.hpp"

namespace fde {
namespace {

// y_n = T_n + kappa (sum_{0<=j<=n} w(n-j) f_j + sum_{j<s} W(n, j) f_j) for n < s.
StartingEquations first_equations(const Problem& problem, const Grid& grid, const Vec& kappa,
                                  const StartingCorrection& correction, int steps) {
  const TaylorPart taylor(problem);
  StartingEquations equations{{}, correction.tables_of_rows(), Matrix(problem.size(), steps)};
  for (int n = 1; n <= steps; ++n) taylor.at(grid.time(n), equations.known.col(n - 1));
  for (std::size_t i = 0; i < equations.of_row.size(); ++i) {
    if (equations.of_row[i] < equations.weights.size()) continue;
    const double factor = kappa[static_cast<Eigen::Index>(i)];
    equations.weights.emplace_back(factor * correction.first_weights(equations.of_row[i]));
  }
  return equations;
}

Trajectory solve_multistep(const WeightFamily& family, const Problem& problem, const Grid& grid,
                           const Options& options) {
  const auto powers = starting_powers(family, problem).for_steps(grid.steps);
  const auto first_steps = static_cast<int>(powers.size()) - 1;
  const auto of_rows = weight_tables(problem, family);
  const Vec kappa = StepFactors(of_rows).at(grid.step());
  StartingCorrection correction(of_rows, powers, grid.steps);
  const TaylorPart taylor(problem);
  NewtonSolver newton(problem, options.newton_tolerance);
  const GridJumps jumps(problem, grid);
  Run run(problem, options, grid.steps);
  run.cost().starting_weights = first_steps + 1;

  Matrix first;
  Vec y = run.start(), known(y.size()), convolved(y.size());
  double t = 0.0;
  int n = 1;
  // Made after the first steps, whose work space is then free again.
  std::unique_ptr<History> history;
  const auto begin_history = [&] {
    history = make_history(options.history, {of_rows}, step_plan(grid), options.newton_tolerance);
    run.cost().history_bytes = history->bytes() + correction.bytes();
    run.cost().history = name(history->kind());
  };
  const StateArchiver state = [&](Archive& archive) {
    if (!history) begin_history();
    archive.count(n, 1, grid.steps);
    archive(t, y, *history, correction, newton);
    archive.resizable(first);
  };
  if (!run.resume_from_checkpoint(state) && first_steps > 0) {
    SolveStatus ending{};
    const auto first_order = [&](const Grid& steps, const Options& exact) {
      return solve_implicit(problem, steps, exact, integral_rule(problem, families::grunwald_letnikov));
    };
    auto equations = first_equations(problem, grid, kappa, correction, first_steps);
    first = StartingProcedure(problem, grid, std::move(equations), first_order)
                .solve(run, options.newton_tolerance, ending);
    if (ending != SolveStatus::finished) {
      run.fail(ending, grid.time(1));
      return run.finish();
    }
  }
  if (!history) begin_history();
  for (; n <= grid.steps; ++n) {
    run.offer_checkpoint(state);
    const Vec& f = newton.rhs_at_solution(run, t, y);
    history->push(t, f);
    correction.push(f);
    t = grid.time(n);
    if (n <= first_steps) {
      y = first.col(n - 1);
      if (n == first_steps) first.resize(0, 0);
    } else {
      history->convolve(t, 0, convolved);
      correction.add(n, convolved);
      taylor.at(t, known);
      for_each_row(known.size(), [&](Eigen::Index i) { known[i] += kappa[i] * convolved[i]; });
      if (const SolveStatus ending = newton.solve(run, {t, kappa, known, jumps.before(t)}, y);
          ending != SolveStatus::finished) {
        run.fail(ending, t);
        break;
      }
    }
    if (!run.accept(t, newton.delivered(y))) break;
  }
  run.cost().linear_solver = newton.linear_solver();
  return run.finish();
}

RateTheory theory_of(const MultistepRule& rule) {
  return {[rate = static_cast<double>(rule.rate)](double) { return rate; },
          [](double g, double p) { return 1.0 + p - g; }, [](double, double p) { return p; }};
}

}  // namespace

double multistep_rate(const WeightFamily& family, const StartingPowers& start, const Problem& problem,
                      const Smoothness& smoothness, double grading, Norm norm) {
  const double rate_of_rule = family.multistep->rate;
  Smoothness beside = smoothness;
  for (std::size_t i = 0; i < beside.powers.size(); ++i) {
    const double g = problem.components[i].order;
    auto& powers = beside.powers[i];
    std::erase_if(powers, [&](double p) {
      return std::ranges::any_of(start.powers,
                                 [=](double r) { return std::abs(p - g - r) < power_separation; });
    });
    // Lists of powers may end at order + 2; beyond, any sum of orders and integers may occur.
    const double first = start.next + g;
    const bool counts = start.next + 1.0 < rate_of_rule || first < rate_of_rule;
    if (powers.empty() || (counts && powers.front() > first)) powers.insert(powers.begin(), first);
  }
  return rate(theory_of(*family.multistep), problem, beside, grading, norm);
}

Scheme multistep_scheme(std::string_view id, std::string_view title, std::string_view source,
                        const WeightFamily& family) {
  return {.id = id,
          .title = title,
          .source = source,
          .capabilities = {.uniform_grid = true, .implicit = true, .checkpoints = true},
          .expected_rate =
              [&family](const Problem& problem, const Smoothness& smoothness, double grading, Norm norm) {
                return multistep_rate(family, starting_powers(family, problem), problem, smoothness, grading,
                                      norm);
              },
          .solve = on_grid([&family](const Problem& problem, const Grid& grid, const Options& options) {
            return solve_multistep(family, problem, grid, options);
          }),
          .unsupported_problem_reason = [&family](const Problem& problem) -> std::optional<std::string> {
            for (std::size_t i = 0; i < problem.components.size(); ++i) {
              const double order = problem.components[i].order;
              if (family.step_factor(order) > 0.0) continue;
              return fmt::format("is explicit at order {}, that of component {}", order, i);
            }
            return std::nullopt;
          },
          .symbol = [&family](const Problem& problem,
                              double length) { return implicit_symbol(problem, family, length); },
          .starting_powers =
              [&family](const Problem& problem) { return starting_powers(family, problem).powers; }};
}

}  // namespace fde
