// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/start_weights/multistep_scheme.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "fdebench/schemes/history/history.hpp"
#include "fdebench/schemes/history/parallel_for_rows.hpp"
#include "fdebench/schemes/history/symbols/rule_symbols.hpp"
#include "fdebench/schemes/history/weights/weights.hpp"
#include "fdebench/schemes/rules/implicit/implicit_rule.hpp"
#include "fdebench/schemes/rules/implicit/newton_stepper.hpp"
#include "fdebench/schemes/rules/start_weights/start_correction.hpp"
#include "fdebench/schemes/rules/start_weights/starting_procedure.hpp"
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

class MultistepStepper final : public NewtonStepper<MultistepStepper> {
 public:
  MultistepStepper(const WeightFamily& family, const Problem& problem, const Grid& grid,
                   const Options& options)
      : NewtonStepper(problem, grid, options),
        tables_(weight_tables(problem, family)),
        kappa_(StepFactors(tables_).at(grid.step())),
        correction_(tables_, starting_powers(family, problem).for_steps(grid.steps), grid.steps),
        taylor_part_(problem),
        known_(y_.size()),
        convolved_(y_.size()) {
    run_.cost().starting_weights = first_steps() + 1;
  }

  StepOutcome start() {
    if (first_steps() == 0) return {0.0};
    const auto first_order = [&](const Grid& steps, const Options& exact) {
      return solve_implicit(problem_, steps, exact, integral_rule(problem_, families::grunwald_letnikov));
    };
    SolveStatus ending{};
    auto equations = first_equations(problem_, grid(), kappa_, correction_, first_steps());
    first_ = StartingProcedure(problem_, grid(), std::move(equations), first_order)
                 .solve(run_, options_.newton_tolerance, ending);
    return {grid().time(1), ending};
  }

  SolveStatus step() {
    const Vec& f = rhs_before();
    history().push(before(), f);
    correction_.push(f);
    if (n() <= first_steps()) {
      y_ = first_.col(n() - 1);
      if (n() == first_steps()) first_.resize(0, 0);
      return SolveStatus::finished;
    }
    history_->convolve(t(), 0, convolved_);
    correction_.add(n(), convolved_);
    taylor_part_.at(t(), known_);
    for_each_row(known_.size(), [&](Eigen::Index i) { known_[i] += kappa_[i] * convolved_[i]; });
    return solve(kappa_, known_);
  }

  void rule_state(Archive& archive) {
    NewtonStepper::rule_state(archive);
    archive(history(), correction_);
    archive.resizable(first_);
  }

 private:
  [[nodiscard]] int first_steps() const { return static_cast<int>(correction_.count()) - 1; }

  // Made after the first steps, whose work space is then free again.
  History& history() {
    if (!history_) {
      history_ = make_history(options_.history, {tables_}, step_plan(grid()), options_.newton_tolerance);
      record_history(history_->bytes() + correction_.bytes(), history_->chosen());
    }
    return *history_;
  }

  const std::vector<WeightTable> tables_;
  const Vec kappa_;
  StartingCorrection correction_;
  const TaylorPart taylor_part_;
  std::unique_ptr<History> history_{};
  Matrix first_{};  // the first steps that are still to come, one column each
  Vec known_, convolved_;
};

Trajectory solve_multistep(const WeightFamily& family, const Problem& problem, const Grid& grid,
                           const Options& options) {
  return integrate(MultistepStepper(family, problem, grid, options));
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
