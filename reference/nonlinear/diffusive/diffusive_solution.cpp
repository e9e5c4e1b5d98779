// SPDX-License-Identifier: MIT
#include "fdebench/reference/nonlinear/diffusive/diffusive_solution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "fdebench/reference/nonlinear/diffusive/memory.hpp"
#include "fdebench/reference/nonlinear/diffusive/stages.hpp"
#include "fdebench/reference/nonlinear/march/implicit_step.hpp"
#include "fdebench/reference/nonlinear/march/march_limits.hpp"
#include "fdebench/reference/nonlinear/march/rhs_noise.hpp"
#include "fdebench/schemes/problem/progress/progress.hpp"

namespace fde::reference {

namespace {

[[noreturn]] void fail(const std::string& what, double t) {
  std::ostringstream message;
  message.precision(10);
  message << "second method: " << what << " at t = " << t;
  throw std::runtime_error(message.str());
}

Vec largest(const Matrix& values) { return values.cwiseAbs().colwise().maxCoeff(); }

class DiffusiveIntegrator {
 public:
  DiffusiveIntegrator(Problem problem, const DiffusiveOptions& options)
      : problem_(std::move(problem)),
        options_(options),
        rule_(options.stages),
        memory_(problem_, rule_, options.first_step),
        equations_(problem_, rule_.nodes.cast<double>()),
        noise_(problem_, rule_) {
    if (options.looking_back != nullptr)
      options.looking_back->set_solution([this](double t, Out y) { y = value_at(t); });
  }

  void run_to(double stop, DiffusiveSolution& solution) {
    // A pendulum on a stiff spring, K/m = 1e6, takes 25000 steps up to t = 5.
    constexpr std::size_t most_steps = 30000;
    while (time_ < stop) {
      if (solution.times.size() == most_steps || hopeless(solution.times, most_steps)) {
        fail("more steps than it can afford", time_);
      }
      report_progress(solution.times.size());
      add_step(std::min(stop, next_discontinuity(problem_, time_)));
      solution.times.push_back(time_);
      solution.values.push_back(value_);
      if (resets_.next() <= time_) pass_event();
    }
    solution.events = resets_.events();
    solution.event_at_end = event_at_end_;
  }

 private:
  [[nodiscard]] bool hopeless(const std::vector<double>& times, std::size_t most_steps) const {
    constexpr std::size_t output_times = 1000;
    return times.size() > output_times &&
           fde::reference::cannot_reach_end(times[times.size() - 1 - output_times], time_, output_times,
                                            problem_.end, most_steps - times.size());
  }

  // Halves the step until it resolves the solution.
  void add_step(double stop) {
    constexpr double shortest = 1e-13;  // relative to the time
    while (length_ > longest_step(problem_, time_)) length_ /= 2;
    for (;;) {
      const double left = std::min(stop, resets_.next()) - time_;
      // Two steps of equal length rather than a long and a very short one.
      const double length = left <= length_ ? left : std::min(length_, left / 2);
      if (length <= shortest * time_ || length <= std::numeric_limits<double>::min()) {
        fail("no convergence", time_);
      }
      const auto stages = solve(length);
      const double unresolved = stages ? unresolved_by(*stages, length) : 2.0;
      if (unresolved * doubling() >= 1.0 && noise_found(stages, length)) {
        equations_.set_rhs_noise(noise_.known_rhs_noise());
        continue;
      }
      if (unresolved <= 1.0) {
        const double end = length == left ? std::min(stop, resets_.next()) : time_ + length;
        if (cut_by_event(*stages, end)) continue;
        if (resets_.next() <= time_) {
          pass_event();
          continue;
        }
        return accept(*stages, length, end, unresolved);
      }
      length_ /= 2;
      steps_to_growth_ = 4;
    }
  }

  // y at a time up to this one, from the steps that are stored where the problem looks back.
  [[nodiscard]] Vec value_at(double t) const {
    const auto step = std::ranges::lower_bound(past_, t, {}, &Step::to);
    return step == past_.end() ? value_ : step->at(t);
  }

  // Whether y jumps within the step to `end`, so that it must end there. An event at its start is the next
  // one.
  bool cut_by_event(const StageSolution& stages, double end) {
    if (problem_.resets.empty()) return false;
    const Step step{time_, end, coefficients_of(stages)};
    const auto event = resets_.find(time_, end, [&](double t) { return step.at(t); });
    return event && *event > time_ && *event < end;
  }

  void pass_event() {
    Vec after = value_;
    resets_.pass(after);
    memory_.add_jump(after - value_);
    value_ = after;
    size_ = size_.cwiseMax(after.cwiseAbs());
    last_rhs_ = rhs_at(problem_, time_, after);
    add_jump_time(problem_, time_);
    restart_after_jump();
  }

  std::optional<StageSolution> solve(double length) {
    std::vector<Matrix> weights;
    for (Eigen::Index i = 0; i < problem_.size(); ++i) {
      weights.push_back(memory_.weights(i, length));
    }
    return equations_.solve(history(length), weights, time_, length, value_, last_rhs_, size_);
  }

  // The history term at the stages; for algebraic rows the last value.
  [[nodiscard]] Matrix history(double length) {
    Matrix history = memory_.history_term(length);
    for (const auto i : algebraic_rows(problem_)) history.col(i).setConstant(value_[i]);
    return history;
  }

  // Factor by which the last coefficients grow when the step size is doubled.
  [[nodiscard]] double doubling() const { return std::pow(2.0, options_.stages); }

  // Whether newly found noise of f is the reason for a short step.
  bool noise_found(const std::optional<StageSolution>& stages, double length) {
    if (!stages) {
      return noise_.detect_on_last_step(size_);
    }
    const Vec allowed = options_.tolerance * size_,
              tolerated = allowed.cwiseQuotient(doubling() * unit_increment(problem_, length));
    // The sizes before this step, which may be too long.
    const double scale = size_.cwiseMax(last_rhs_.cwiseAbs()).maxCoeff();
    return noise_.detect(*stages, time_, length, tolerated, scale);
  }

  // The last two Legendre coefficients of y, and of the contribution of f to y, above their noise and
  // relative to the tolerance. Above 1 the step is too long.
  [[nodiscard]] double unresolved_by(const StageSolution& stages, double length) const {
    if (time_ < options_.negligible_before * problem_.end ||
        just_after_jump(problem_, time_, time_ + length)) {
      return 0.0;
    }
    const Vec of_y =
        StageNoise::above_noise(largest(coefficients_of(stages).bottomRows(2)), stages.noise.values);
    const Vec of_rhs =
        StageNoise::above_noise(largest(rule_.at_nodes.bottomRows(2) * stages.rhs), stages.noise.rhs);
    const Vec excess = of_y.cwiseMax(unit_increment(problem_, length).cwiseProduct(of_rhs));
    const Vec size = size_.cwiseMax(largest(stages.y));
    double unresolved = 0.0;
    for (Eigen::Index i = 0; i < problem_.size(); ++i) {
      if (excess[i] > 0.0) {
        unresolved = std::max(unresolved, excess[i] / (options_.tolerance * size[i]));
      }
    }
    return unresolved;
  }

  // Legendre coefficients of y on the step, one row a degree.
  [[nodiscard]] Matrix coefficients_of(const StageSolution& stages) const {
    Matrix y(stages.y.rows() + 1, stages.y.cols());
    y << value_.transpose(), stages.y;
    return rule_.with_start * y;
  }

  void accept(const StageSolution& stages, double length, double end, double unresolved) {
    const Step step{time_, end, coefficients_of(stages)};
    if (options_.looking_back != nullptr) past_.push_back(step);
    if (!problem_.resets.empty()) {
      const auto path = [&](double t) { return step.at(t); };
      resets_.accept(time_, end, path);
      if (end >= problem_.end) event_at_end_ = resets_.next_to(end, path);
    }
    memory_.advance(length, stages.rhs);
    time_ = end;
    value_ = stages.y.bottomRows<1>().transpose();
    size_ = size_.cwiseMax(largest(stages.y));
    last_rhs_ = stages.rhs.bottomRows<1>().transpose();
    noise_.record_accepted_step(stages, length, end);
    equations_.set_rhs_noise(noise_.known_rhs_noise());
    --steps_to_growth_;
    if (jumps_at(problem_, time_)) {
      restart_after_jump();
    } else if (unresolved * doubling() < 1.0 && length_ <= time_ - last_jump(problem_, time_) &&
               steps_to_growth_ <= 0) {
      length_ *= 2;
    }
  }

  void restart_after_jump() {
    length_ = problem_.end * std::exp2(std::floor(std::log2(first_after_jump * time_ / problem_.end)));
    steps_to_growth_ = 0;
  }

  // y on a step.
  struct Step {
    double from, to;
    Matrix coefficients;

    [[nodiscard]] Vec at(double t) const {
      const double x = 2.0 * (t - from) / (to - from) - 1.0;
      Vec sum = Vec::Zero(coefficients.cols());
      double polynomial = 1.0, before = 0.0;  // P_k(x)
      for (Eigen::Index k = 0; k < coefficients.rows(); ++k) {
        sum += polynomial * coefficients.row(k).transpose();
        const auto n = static_cast<double>(k);
        before = std::exchange(polynomial, ((2.0 * n + 1.0) * x * polynomial - n * before) / (n + 1.0));
      }
      return sum;
    }
  };

  Problem problem_;  // with the times of the events among its jump times
  DiffusiveOptions options_;
  RadauRule rule_;
  MemoryVariables memory_;
  StageEquations equations_;
  StageNoise noise_;
  double time_ = 0.0;
  double length_ = options_.first_step * problem_.end;  // of the next step; end * 2^k
  int steps_to_growth_ = 0;
  std::vector<Step> past_{};  // where the problem looks back
  Vec value_ = taylor_part(problem_, 0.0);
  Vec size_ = value_.cwiseAbs();
  Vec last_rhs_ = rhs_at(problem_, 0.0, value_);
  ResetLocator resets_{problem_};
  std::optional<ResetEvent> event_at_end_{};
};

}  // namespace

DiffusiveSolution diffusive_solution(const Problem& problem, const DiffusiveOptions& options,
                                     const std::vector<double>& stops) {
  require_supported(problem);
  DiffusiveIntegrator march(problem, options);
  DiffusiveSolution solution;
  for (const double stop : stops) {
    march.run_to(stop, solution);
  }
  march.run_to(problem.end, solution);
  return solution;
}

}  // namespace fde::reference
