// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/implicit/implicit_rule.hpp"

#include "fdebench/schemes/history/history.hpp"
#include "fdebench/schemes/history/parallel_for_rows.hpp"
#include "fdebench/schemes/history/weights/weights.hpp"
#include "fdebench/schemes/problem/problem.hpp"
#include "fdebench/schemes/rules/implicit/newton_stepper.hpp"

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
  [[nodiscard]] ChosenHistory chosen() const { return history_->chosen(); }

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

class ImplicitStepper final : public NewtonStepper<ImplicitStepper> {
 public:
  ImplicitStepper(const Problem& problem, const Grid& grid, const Options& options, const ImplicitRule& rule)
      : NewtonStepper(problem, grid, options),
        rule_(rule),
        factors_(rule.tables),
        history_(problem, rule.tables, grid, options),
        previous_(y_),
        sample_(y_.size()),
        known_(y_.size()),
        convolved_(Vec::Zero(y_.size())) {
    record_history(history_.bytes(), history_.chosen());
  }

  SolveStatus step() {
    push_sample();
    copy_rows(y_.size(), y_.data(), previous_.data());
    history_.convolve(t(), convolved_);
    const Vec& kappa = factors_.at(h());
    rule_.known(t(), sums_, before_step_, kappa, known_);
    const SolveStatus ending = solve(kappa, known_);
    if (ending != SolveStatus::finished || !rule_.recorded_result) return ending;
    recorded_ = *result_;
    rule_.recorded_result(*result_, recorded_);
    result_ = &recorded_;
    return ending;
  }

  void rule_state(Archive& archive) {
    NewtonStepper::rule_state(archive);
    archive(previous_, history_);
    if (rule_.state) rule_.state(archive);
  }

 private:
  // Appends the sample at t_(n-1).
  void push_sample() {
    if (rule_.sample) {
      rule_.sample(before(), solution_, before_step_, sample_);
    } else {
      copy_rows(y_.size(), rhs_before().data(), sample_.data());
    }
    history_.push(before(), new_sample_);
  }

  const ImplicitRule& rule_;
  StepFactors factors_;
  HistoryOfRows history_;
  Vec previous_, recorded_{}, sample_, known_, convolved_;
  // Made once: a view takes as long as a component.
  const Eigen::Ref<const Vec> before_step_{previous_}, new_sample_{sample_}, sums_{convolved_};
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
  return integrate(ImplicitStepper(problem, grid, options, rule));
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
