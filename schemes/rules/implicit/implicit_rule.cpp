// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/implicit/implicit_rule.hpp"

#include "fdebench/schemes/history/history.hpp"
#include "fdebench/schemes/history/parallel_for_rows.hpp"
#include "fdebench/schemes/history/weights/weights.hpp"
#include "fdebench/schemes/problem/problem.hpp"
#include "fdebench/schemes/stepping/grid_jumps.hpp"

namespace fde {

namespace {

// The history of all rows but the algebraic ones.
class HistoryOfRows {
 public:
  HistoryOfRows(const Problem& problem, const std::vector<WeightTable>& tables, const Grid& grid,
                const Options& options) {
    std::vector<WeightTable> remembered;
    for (std::size_t i = 0; i < tables.size(); ++i) {
      if (is_algebraic(problem.components[i])) continue;
      rows_.push_back(static_cast<Eigen::Index>(i));
      remembered.push_back(tables[i]);
    }
    buffer_.resize(static_cast<Eigen::Index>(rows_.size()));
    history_ = make_history(options.history, {remembered}, step_plan(grid), options.newton_tolerance);
  }

  [[nodiscard]] std::size_t bytes() const { return history_->bytes(); }
  [[nodiscard]] HistoryKind kind() const { return history_->kind(); }

  void state(Archive& archive) { archive(history_); }

  // Appends a sample of all rows, taken at time t.
  void push(double t, In sample) {
    if (sample.size() == buffer_.size()) return history_->push(t, sample);  // no algebraic rows
    for (Eigen::Index r = 0; r < buffer_.size(); ++r) buffer_[r] = sample[row(r)];
    history_->push(t, buffer_);
  }

  // Sets the sums at time t of the rows with a history; the other entries are unchanged.
  void convolve(double t, Vec& result) {
    if (result.size() == buffer_.size()) return history_->convolve(t, 0, result);
    history_->convolve(t, 0, buffer_);
    for (Eigen::Index r = 0; r < buffer_.size(); ++r) result[row(r)] = buffer_[r];
  }

 private:
  [[nodiscard]] Eigen::Index row(Eigen::Index r) const { return rows_[static_cast<std::size_t>(r)]; }

  std::vector<Eigen::Index> rows_;
  Vec buffer_;
  std::unique_ptr<History> history_;
};

}  // namespace

ImplicitRule integral_rule(const Problem& problem, const WeightFamily& family) {
  return {
      .tables = weight_tables(problem, family),
      .known = [taylor = TaylorPart(problem)](double t, In convolved, In /*previous*/, In kappa, Vec& known) {
        taylor.at(t, known);
        for_each_row(known.size(), [&](Eigen::Index i) { known[i] += kappa[i] * convolved[i]; });
      }};
}

Trajectory solve_implicit(const Problem& problem, const Grid& grid, const Options& options,
                          const ImplicitRule& rule) {
  Run run(problem, options, grid.steps);
  NewtonSolver newton(problem, options.newton_tolerance);
  StepFactors factors(rule.tables);
  const GridJumps jumps(problem, grid);
  HistoryOfRows history(problem, rule.tables, grid, options);
  run.cost().history_bytes = history.bytes();
  run.cost().history = name(history.kind());

  Vec previous = run.start(), y = previous, recorded, sample(y.size()), known(y.size());
  Vec convolved = Vec::Zero(y.size());
  // Made once: a view takes as long as a component.
  const Eigen::Ref<const Vec> solution(y), before_step(previous), new_sample(sample), sums(convolved);
  double t = 0.0;
  int n = 1;
  const StateArchiver state = [&](Archive& archive) {
    archive.count(n, 1, grid.steps);
    archive(t, y, previous, sample, history, newton);
    if (rule.state) rule.state(archive);
  };
  if (rule.sample) {
    rule.sample(t, y, previous, sample);
  } else {
    run.rhs(t, y, sample);
  }
  for (run.resume_from_checkpoint(state); n <= grid.steps; ++n) {
    run.offer_checkpoint(state);
    history.push(t, new_sample);
    const double before = t;
    t = grid.time(n);
    history.convolve(t, convolved);
    const Vec& kappa = factors.at(grid.step(before, t));
    rule.known(t, sums, before_step, kappa, known);
    if (const SolveStatus ending = newton.solve(run, {t, kappa, known, jumps.before(t)}, y);
        ending != SolveStatus::finished) {
      run.fail(ending, t);
      break;
    }
    const Vec& delivered = newton.delivered(y);
    const bool is_solution = &delivered == &y && !rule.recorded_result;
    if (!is_solution) recorded = delivered;
    if (rule.recorded_result) rule.recorded_result(delivered, recorded);
    if (!(is_solution ? run.accept(t, solution) : run.accept(t, recorded))) break;
    if (n < grid.steps && rule.sample) {
      rule.sample(t, solution, before_step, sample);
    } else if (n < grid.steps) {
      copy_rows(y.size(), newton.rhs_at_solution(run, t, solution).data(), sample.data());
    }
    copy_rows(y.size(), y.data(), previous.data());
  }
  run.cost().linear_solver = newton.linear_solver();
  return run.finish();
}

const RateTheory trapezoidal_theory{[](double) { return 2.0; }, end_rate_of_interpolated_f,
                                    first_step_rate_of_interpolated_f};

// Backward Euler is exact for t.
const RateTheory grunwald_letnikov_theory{[](double) { return 1.0; },
                                          [](double, double) { return exact_power; },
                                          [](double g, double p) {
                                            if (g == 1.0 && same_order(p, 1.0)) return exact_power;
                                            return p;
                                          }};

}  // namespace fde
