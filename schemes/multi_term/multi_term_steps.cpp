#include "multi_term/multi_term_steps.hpp"

#include <algorithm>
#include <utility>

#include "implicit/newton.hpp"
#include "multi_term/integrated_equations.hpp"
#include "stepping/run.hpp"

namespace fde {

Trajectory step_equations_implicitly(const Problem& problem, const Grid& grid, const Options& options,
                                     const WeightFamily& family) {
  const Problem stepped = integrated(problem);
  Run run(stepped, options, grid.steps);
  NewtonSolver newton(stepped, options.tolerance);
  IntegratedEquations equations(problem, family, grid, options);
  run.cost().history_bytes = equations.bytes();

  Vec y = run.start();
  double t = 0.0;
  for (int n = 1; n <= grid.steps; ++n) {
    equations.push(t, y, run.rhs(t, y));
    t = grid.time(n);
    Ending ending = Ending::outran_growth;
    if (equations.step_to(n)) ending = newton.solve(run, {t, equations.kappa(), equations.past()}, y);
    if (ending != Ending::finished) {
      run.fail(ending, t);
      break;
    }
    if (!run.accept(t, y)) break;
  }
  return run.finish();
}

Trajectory step_equations_with_start_weights(const Problem& problem, const Grid& grid, const Options& options,
                                             const WeightFamily& family) {
  auto powers = start_powers_of_equations(family, problem).powers;
  powers.resize(std::min(powers.size(), static_cast<std::size_t>(grid.steps) + 1));
  const auto first_steps = static_cast<int>(powers.size()) - 1;
  const Problem stepped = integrated(problem);
  Run run(stepped, options, grid.steps);
  NewtonSolver newton(stepped, options.tolerance);
  IntegratedEquations equations(problem, family, grid, options, powers);
  run.cost().history_bytes = equations.bytes();
  run.cost().start_weights = first_steps + 1;

  Matrix first;
  Ending ending = Ending::finished;
  if (first_steps > 0) {
    if (auto system = equations.first_equations()) {
      const auto first_order = [&](const Grid& steps, const Options& exact) {
        return step_equations_implicitly(problem, steps, exact, families::grunwald_letnikov);
      };
      first =
          FirstSteps(stepped, grid, std::move(*system), first_order).solve(run, options.tolerance, ending);
    } else {
      ending = Ending::outran_growth;
    }
    if (ending != Ending::finished) {
      run.fail(ending, grid.time(1));
      return run.finish();
    }
  }
  Vec y = run.start();
  double t = 0.0;
  for (int n = 1; n <= grid.steps; ++n) {
    equations.push(t, y, run.rhs(t, y));
    t = grid.time(n);
    if (n <= first_steps) {
      y = first.col(n - 1);
    } else {
      ending = Ending::outran_growth;
      if (equations.step_to(n)) ending = newton.solve(run, {t, equations.kappa(), equations.past()}, y);
    }
    if (ending != Ending::finished) {
      run.fail(ending, t);
      break;
    }
    if (!run.accept(t, y)) break;
  }
  return run.finish();
}

Trajectory predict_and_correct_equations(const Problem& problem, const Grid& grid, const Options& options) {
  const Problem stepped = integrated(problem);
  Run run(stepped, options, grid.steps);
  IntegratedEquations equations(problem, families::trapezoid, grid, options);
  run.cost().history_bytes = equations.bytes();

  Vec y = run.start(), f(y.size()), before(y.size());
  double t = 0.0;
  for (int n = 1; n <= grid.steps; ++n) {
    before = f;
    f = run.rhs(t, y);
    equations.push(t, y, f);
    t = grid.time(n);
    if (!equations.step_to(n)) {
      run.fail(Ending::outran_growth, t);
      break;
    }
    const double ratio = n == 1 ? 0.0 : grid.step(n) / grid.step(n - 1);
    if (n == 1) before = f;
    y = equations.past() + equations.kappa().cwiseProduct(f + ratio * (f - before));
    for (int correction = 0; correction < options.corrections; ++correction)
      y = equations.past() + equations.kappa().cwiseProduct(run.rhs(t, y));
    if (!run.accept(t, y)) break;
  }
  return run.finish();
}

}  // namespace fde
