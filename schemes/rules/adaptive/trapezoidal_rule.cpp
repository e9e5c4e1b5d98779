// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/adaptive/trapezoidal_rule.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "fdebench/schemes/history/weights/family.hpp"
#include "fdebench/schemes/rules/implicit/newton.hpp"

namespace fde {
namespace {

class NewtonOnTrapezoids final : public TrapezoidalSolver {
 public:
  NewtonOnTrapezoids(const Problem& problem, double tolerance) : problem_(problem), tolerance_(tolerance) {}

  bool solve(Run& run, const StepEquations& step, const Vec& /*continued*/, Vec& y, Vec& f) override {
    if (!newton_) newton_.emplace(problem_, tolerance_);
    if (newton_->solve(run, step, y) != SolveStatus::finished) {
      newton_.reset();
      return false;
    }
    // One more iteration, and f from the linearised equations: where they are stiff, the error of f(t, y) is
    // far larger than that of y; where the step is short, the error of (y - known) / kappa is.
    f = run.rhs(step.t, y);
    const Vec rest = step.known + step.kappa.cwiseProduct(f) - y;
    Vec increment = rest;
    newton_->apply_inverse(increment);
    y += increment;
    f += (increment - rest).cwiseQuotient(step.kappa);
    return y.allFinite() && f.allFinite();
  }

  [[nodiscard]] Vec iteration_error() const override { return Vec::Zero(problem_.size()); }
  void apply_inverse(Vec& error) const override { newton_->apply_inverse(error); }
  [[nodiscard]] std::string_view linear_solver() const override {
    return newton_ ? newton_->linear_solver() : std::string_view();
  }
  void state(Archive& archive) override {
    bool is_there = newton_.has_value();
    archive(is_there);
    if (archive.is_reading() && is_there) newton_.emplace(problem_, tolerance_);
    if (is_there) archive(*newton_);
  }

 private:
  const Problem& problem_;
  double tolerance_;
  std::optional<NewtonSolver> newton_{};
};

class PredictionCorrector final : public TrapezoidalSolver {
 public:
  explicit PredictionCorrector(int corrections) : corrections_(corrections) {}

  bool solve(Run& run, const StepEquations& step, const Vec& continued, Vec& y, Vec& f) override {
    f = continued;
    for (int correction = 0; correction <= corrections_; ++correction) {
      y = step.known + step.kappa.cwiseProduct(f);
      previous_ = std::exchange(f, run.rhs(step.t, y));
    }
    last_change_ = (f - previous_).cwiseAbs();
    return y.allFinite() && f.allFinite();
  }

  [[nodiscard]] Vec iteration_error() const override { return last_change_; }
  void apply_inverse(Vec& /*error*/) const override {}
  void state(Archive& /*archive*/) override {}

 private:
  int corrections_;
  Vec previous_, last_change_;
};

std::unique_ptr<History> history_for(const Problem& problem, const Options& options, double shortest) {
  return make_history(HistoryKind::exponentials, {weight_tables(problem, families::trapezoid)},
                      {.end = problem.end, .min_step = shortest}, options.newton_tolerance);
}

}  // namespace

std::unique_ptr<TrapezoidalSolver> make_newton_solver(const Problem& problem, double tolerance) {
  return std::make_unique<NewtonOnTrapezoids>(problem, tolerance);
}

std::unique_ptr<TrapezoidalSolver> make_predictor_corrector(int corrections) {
  return std::make_unique<PredictionCorrector>(corrections);
}

TrapezoidalRule::TrapezoidalRule(const Problem& problem, const Tolerance& accuracy, const Options& options,
                                 Run& run, double shortest, std::unique_ptr<TrapezoidalSolver> solver)
    : problem_(problem),
      taylor_(problem),
      allowed_(accuracy),
      factors_(weight_tables(problem, families::trapezoid)),
      history_(history_for(problem, options, shortest)),
      solver_(std::move(solver)),
      orders_(orders_of(problem)),
      newest_{0.0, run.rhs(0.0, run.start())},
      next_(newest_),
      rhs_error_(problem.size()),
      previous_(run.start()),
      y_(previous_),
      convolved_(previous_),
      known_(previous_) {
  for (Eigen::Index i = 0; i < orders_.size(); ++i)
    first_of_same_order_.push_back(std::ranges::find(orders_, orders_[i]) - orders_.begin());
  history_->push(0.0, newest_.f);
}

void TrapezoidalRule::compute_known(double t) {
  kappa_ = factors_.at(t - newest_.t);
  history_->convolve(t, 0, convolved_);
  taylor_.at(t, known_);
  known_ += kappa_.cwiseProduct(convolved_);
}

double TrapezoidalRule::attempt(Run& run, double t) {
  compute_known(t);
  y_ = previous_;
  next_.t = t;
  if (!solver_->solve(run, {t, kappa_, known_}, extrapolated_rhs(t), y_, next_.f)) return no_solution;
  const Vec iteration_error = solver_->iteration_error();
  return error(run, defect().binaryExpr(iteration_error, [](double line, double left) {
    return line + std::copysign(left, line);
  }));
}

// max |error_i| / limit_i, where 0 / 0 counts as 0.
double TrapezoidalRule::weighted_max_norm(const Vec& error, const Vec& limit) {
  double largest = 0.0;
  for (Eigen::Index i = 0; i < error.size(); ++i) {
    if (error[i] != 0.0) largest = std::max(largest, std::abs(error[i]) / limit[i]);
  }
  return largest;
}

// The mean distance of f from its line on the step; without a previous step, half of the change of f.
Vec TrapezoidalRule::defect() const {
  const Vec change = next_.f - newest_.f;
  if (!older_) return change / 2.0;
  const double length = next_.t - newest_.t, length_before = newest_.t - older_->t;
  // h^2 f[t_(n-2), t_(n-1), t_n] / 6, without the square of a length, which may be 1e-290.
  const Vec bend = change - length / length_before * (newest_.f - older_->f);
  return bend * (length / (length + length_before) / 6.0);
}

// Contribution to y_n of an error 1 of f on the whole step: h^g / Gamma(g+1).
Vec TrapezoidalRule::effect_of_rhs_error() const {
  return kappa_.cwiseProduct((orders_.array() + 1.0).matrix());
}

double TrapezoidalRule::error_of_jump() const {
  constexpr double jumps = 1e-6;  // relative to f, on a step of few units in the last place of the time
  const Vec change = next_.f - newest_.f;
  const bool is_one =
      (change.array().abs() > jumps * newest_.f.array().abs().max(next_.f.array().abs())).any();
  return is_one ? weighted_max_norm(effect_of_rhs_error().cwiseProduct(change), limit_) : no_solution;
}

double TrapezoidalRule::error(Run& run, const Vec& of_f) {
  const Vec unit = effect_of_rhs_error();
  const Vec largest = y_.cwiseAbs().cwiseMax(previous_.cwiseAbs()), terms = known_.cwiseAbs();
  Vec limit_of_all = allowed_.from_tolerance(largest, terms);
  limit_ = allowed_.on_step(largest, terms);
  Vec answered = unit.cwiseProduct(of_f);
  const Vec unanswered = answered;
  solver_->apply_inverse(answered);
  interpolated_.clear();
  for (Eigen::Index i = 0; i < limit_.size(); ++i) {
    if (needs_interpolation(unanswered[i], answered[i], limit_[i]))
      interpolated_.push_back({i, {previous_[i], y_[i] - previous_[i], 0.0, 0.0}});
  }
  Vec again = answered;
  solver_->apply_inverse(again);
  const Vec left = undamped_fraction(answered, again);  // r
  if (!answered.allFinite() || !left.allFinite()) return no_solution;
  // The sum of `all` errors, of which each is `one`. That of the errors up to now is compared with the limit
  // for the present size of y.
  const auto sum = [&](double one, double all, Eigen::Index i) {
    return std::abs(one) * all / (left[i] + all * (1.0 - left[i]));
  };
  const auto largest_error = [&] {
    double result = 0.0;
    Vec sums = answered;
    for (Eigen::Index i = 0; i < limit_.size(); ++i) {
      if (answered[i] == 0.0) continue;
      const auto [by_now, by_end] = accumulation(orders_[i]);  // a
      sums[i] = std::copysign(sum(answered[i], by_now, i), answered[i]);
      result = std::max(
          {result, sum(answered[i], by_now, i) / limit_[i], sum(answered[i], by_end, i) / limit_of_all[i]});
    }
    return std::max(result, allowed_.error_of_outputs(problem_, next_.t, y_, sums, terms));
  };
  const auto effect_of = [&](const Vec& rhs_errors, bool at_end) {
    Vec effect = unit.cwiseProduct(rhs_errors);
    solver_->apply_inverse(effect);
    for (Eigen::Index i = 0; i < effect.size(); ++i) {
      const auto [by_now, by_end] = accumulation(orders_[i]);
      effect[i] = sum(effect[i], at_end ? by_end : by_now, i);
    }
    return effect;
  };
  const auto largest_resolved_error = [&] {
    limit_ = allowed_.on_step(largest, largest, terms, effect_of(rhs_error_.all(), false))
                 .cwiseMax(effect_of(rhs_error_.rounding(), false));
    limit_of_all = limit_of_all.cwiseMax(effect_of(rhs_error_.rounding(), true));
    return largest_error();
  };
  const double result = rhs_error_.is_measured() ? largest_resolved_error() : largest_error();
  if (result <= 1.0) return result;
  rhs_error_.measure([&](In y) -> const Vec& { return run.rhs(next_.t, y); }, y_, limit_);
  return largest_resolved_error();
}

// r of each component: the ratio of the root mean squares of `again` and `answered`, the larger of that over
// all components and that over the components of the same order.
Vec TrapezoidalRule::undamped_fraction(const Vec& answered, const Vec& again) const {
  // Squares of errors divided by the largest error do not overflow.
  const double largest = weighted_max_norm(answered, limit_);
  if (largest == 0.0 || !std::isfinite(largest) || answered == again) return Vec::Ones(limit_.size());
  Vec before = Vec::Zero(limit_.size()), after = before;
  double all_before = 0.0, all_after = 0.0;
  const auto square = [&](double error, Eigen::Index i) {
    const double part = error / limit_[i] / largest;
    return part * part;
  };
  for (Eigen::Index i = 0; i < limit_.size(); ++i) {
    const double one = square(answered[i], i), other = square(again[i], i);
    all_before += one;
    all_after += other;
    before[first_of_same_order_[static_cast<std::size_t>(i)]] += one;
    after[first_of_same_order_[static_cast<std::size_t>(i)]] += other;
  }
  const auto part = [](double now, double whole) {
    return whole == 0.0 ? 0.0 : std::min(std::sqrt(now / whole), 1.0);
  };
  const double all = part(all_after, all_before);
  Vec left(limit_.size());
  for (Eigen::Index i = 0; i < left.size(); ++i) {
    left[i] = std::max(
        all, part(after[first_of_same_order_[static_cast<std::size_t>(i)]], before[first_of_same_order_[i]]));
  }
  return left;
}

// The factors a now and at the end: the sum of equal errors on all steps since the last jump of f, in units
// of the error of one step. The kernel t^(order-1) falls for orders below 1 and grows for orders above 1.
std::pair<double, double> TrapezoidalRule::accumulation(double order) const {
  const double length = next_.t - newest_.t, steps = (next_.t - last_jump_time_) / length;
  const double by_now = std::pow(steps, order);
  return {by_now, order <= 1.0 ? by_now : steps * std::pow(problem_.end / length, order - 1.0)};
}

// f extrapolated by the line through its last two values.
Vec TrapezoidalRule::extrapolated_rhs(double t) const {
  if (!older_) return newest_.f;
  return newest_.f + (t - newest_.t) / (newest_.t - older_->t) * (newest_.f - older_->f);
}

Vec TrapezoidalRule::extrapolate(double t) {
  compute_known(t);
  return known_ + kappa_.cwiseProduct(extrapolated_rhs(t));
}

Vec TrapezoidalRule::dense_output(double t) {
  compute_known(t);
  const double share = (t - newest_.t) / (next_.t - newest_.t);
  Vec y = known_ + kappa_.cwiseProduct(newest_.f + share * (next_.f - newest_.f));
  for (const auto& row : interpolated_) y[row.row] = row.at(share);
  return y;
}

void TrapezoidalRule::extrapolate_over_jump(double t) {
  y_ = extrapolate(t);
  next_ = {t, extrapolated_rhs(t)};
  interpolated_.clear();
}

void TrapezoidalRule::evaluate_behind_jump(Run& run) { next_.f = run.rhs(next_.t, y_); }

void TrapezoidalRule::accept() {
  history_->push(next_.t, next_.f);
  allowed_.accept_step(y_.cwiseAbs().cwiseMax(previous_.cwiseAbs()));
  older_ = std::exchange(newest_, next_);
  previous_ = y_;
}

void TrapezoidalRule::restart(Run& /*run*/) {
  older_.reset();
  allowed_.restart();
  last_jump_time_ = newest_.t;
}

DerivativePolynomials TrapezoidalRule::derivative_polynomials() const {
  DerivativePolynomials lines = DerivativePolynomials::Zero(previous_.size(), 3);
  lines.col(0) = older_->f;
  lines.col(1) = newest_.f - older_->f;
  return lines;
}

void TrapezoidalRule::state(Archive& archive) {
  bool has_older = older_.has_value();
  archive(allowed_, rhs_error_, history_, solver_, newest_, last_jump_time_, previous_, y_, has_older);
  if (archive.is_reading()) older_ = has_older ? std::optional(newest_) : std::nullopt;
  if (older_) archive(*older_);
}

}  // namespace fde
