#include "diffusive/march.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "diffusive/memory.hpp"
#include "diffusive/stages.hpp"
#include "march/pace.hpp"
#include "march/posed_problem.hpp"
#include "march/rhs_noise.hpp"

namespace fde {

namespace {

[[noreturn]] void fail(const std::string& what, double t) {
  std::ostringstream message;
  message.precision(10);
  message << "second method: " << what << " at t = " << t;
  throw std::runtime_error(message.str());
}

Vec largest(const Matrix& values) { return values.cwiseAbs().colwise().maxCoeff(); }

Vec rhs_at_start(const Problem& problem) {
  Vec f(problem.size());
  problem.rhs(0.0, taylor_part(problem, 0.0), f);
  return f;
}

constexpr double known_rounding = 64.0;  // with that of the last digit of y, it is no news
constexpr double noises = 4.0;           // the sum of some rounding errors

class DiffusiveMarch {
 public:
  DiffusiveMarch(const Problem& problem, const DiffusiveOptions& options)
      : problem_(problem),
        options_(options),
        rule_(options.stages),
        memory_(problem, rule_, options.first_step),
        equations_(problem, rule_.nodes.cast<double>()),
        rhs_noise_(problem) {}

  void run_to(double stop, DiffusiveSolution& solution) {
    // A pendulum on a stiff spring, K/m = 1e6, takes 25000 up to t = 5.
    constexpr std::size_t most_steps = 30000;
    while (time_ < stop) {
      if (solution.times.size() == most_steps || hopeless(solution.times, most_steps)) {
        fail("more steps than it can afford", time_);
      }
      add_step(stop);
      solution.times.push_back(time_);
      solution.values.push_back(value_);
    }
  }

 private:
  [[nodiscard]] bool hopeless(const std::vector<double>& times, std::size_t most_steps) const {
    constexpr std::size_t watched = 1000;
    return times.size() > watched && fde::hopeless(times[times.size() - 1 - watched], time_, watched,
                                                   problem_.end, most_steps - times.size());
  }

  // Halves the step until it resolves the solution.
  void add_step(double stop) {
    constexpr double shortest = 1e-13;  // relative to the time
    for (;;) {
      const double left = stop - time_;
      // Two steps of equal length rather than a long one and a sliver.
      const double length = left <= length_ ? left : std::min(length_, left / 2);
      if (length <= shortest * time_ || length <= std::numeric_limits<double>::min()) {
        fail("no convergence", time_);
      }
      const auto stages = solve(length);
      const double unresolved = stages ? unresolved_by(*stages, length) : 2.0;
      if (stages ? unresolved * doubling() >= 1.0 && noise_found(*stages, length) : noise_found_before()) {
        equations_.allow_noise(rhs_noise_.found());
        continue;
      }
      if (unresolved <= 1.0) {
        return accept(*stages, length, length == left ? stop : time_ + length, unresolved);
      }
      length_ /= 2;
      steps_to_growth_ = 4;
    }
  }

  std::optional<StageSolution> solve(double length) {
    std::vector<Matrix> weights;
    for (Eigen::Index i = 0; i < problem_.size(); ++i) {
      weights.push_back(memory_.weights(i, length));
    }
    return equations_.solve(memory_.past(length), weights, time_, length, last_rhs_, size_);
  }

  // A step of twice the length has about so many times the coefficients.
  [[nodiscard]] double doubling() const { return std::pow(2.0, options_.stages); }

  // What an error of each f_i adds to y_i on a step is that error times this.
  [[nodiscard]] double added(Eigen::Index i, double length) const {
    const double order = problem_.components[static_cast<std::size_t>(i)].order;
    return std::pow(length, order) / std::tgamma(order + 1.0);
  }

  // Whether rounding of f keeps a step short that was not known to do so.
  bool noise_found(const StageSolution& stages, double length) {
    const Vec unresolved = largest(rule_.at_nodes.bottomRows(2) * stages.rhs);
    Vec negligible = known_rounding * stages.rhs_noise;
    for (Eigen::Index i = 0; i < problem_.size(); ++i) {
      negligible[i] += options_.tolerance * size_[i] / (doubling() * added(i, length));
    }
    const double scale =
        size_.cwiseMax(last_rhs_.cwiseAbs()).maxCoeff();  // not of what may be too long a step
    return rhs_noise_.find(time_ + length * equations_.nodes().array(), stages.y, unresolved, negligible,
                           scale);
  }

  // The same where a step has no solution: on the step before it.
  bool noise_found_before() {
    if (last_.y.size() == 0) {
      return false;
    }
    const double scale = size_.cwiseMax(largest(last_.rhs)).maxCoeff();
    const Vec negligible = known_rounding * last_.rhs_noise;
    const Vec unresolved = negligible.cwiseMax(std::numeric_limits<double>::min());
    return rhs_noise_.find(time_ + last_length_ * (equations_.nodes().array() - 1.0), last_.y, unresolved,
                           negligible, scale);
  }

  // The last two Legendre coefficients of y, and of f as it adds to y, beyond their noise and relative to the
  // tolerance. Above 1 the step is too long.
  [[nodiscard]] double unresolved_by(const StageSolution& stages, double length) const {
    constexpr double weightless = 1e-18;  // of the end: an error of f before it is lost in rounding later on
    if (time_ < weightless * problem_.end) {
      return 0.0;
    }
    Matrix y(stages.y.rows() + 1, stages.y.cols());
    y << value_.transpose(), stages.y;
    const Vec of_y = largest(rule_.with_start.bottomRows(2) * y) - noises * stages.y_noise;
    const Vec of_rhs = largest(rule_.at_nodes.bottomRows(2) * stages.rhs) - noises * stages.rhs_noise;
    const Vec size = size_.cwiseMax(largest(stages.y));
    double unresolved = 0.0;
    for (Eigen::Index i = 0; i < problem_.size(); ++i) {
      const double excess = std::max(of_y[i], added(i, length) * of_rhs[i]);
      if (excess > 0.0) {
        unresolved = std::max(unresolved, excess / (options_.tolerance * size[i]));
      }
    }
    return unresolved;
  }

  void accept(const StageSolution& stages, double length, double end, double unresolved) {
    memory_.advance(length, stages.rhs);
    time_ = end;
    value_ = stages.y.bottomRows<1>().transpose();
    size_ = size_.cwiseMax(largest(stages.y));
    rhs_noise_.follow(end + length * (equations_.nodes().array() - 1.0), stages.y,
                      noises * (stages.rhs_noise - rhs_noise_.found()));
    equations_.allow_noise(rhs_noise_.found());
    last_ = stages;
    last_length_ = length;
    last_rhs_ = stages.rhs.bottomRows<1>().transpose();
    --steps_to_growth_;
    if (unresolved * doubling() < 1.0 && length_ <= time_ && steps_to_growth_ <= 0) {
      length_ *= 2;
    }
  }

  const Problem& problem_;
  DiffusiveOptions options_;
  RadauRule rule_;
  DiffusiveMemory memory_;
  StageEquations equations_;
  double time_ = 0.0;
  double length_ = options_.first_step * problem_.end;  // of the step to try next; end * 2^k
  int steps_to_growth_ = 0;
  Vec value_ = taylor_part(problem_, 0.0);
  Vec size_ = value_.cwiseAbs();
  Vec last_rhs_ = rhs_at_start(problem_);
  StageSolution last_{};
  double last_length_ = 0.0;
  RhsNoise rhs_noise_;
};

}  // namespace

DiffusiveSolution diffusive_solution(const Problem& problem, const DiffusiveOptions& options,
                                     const std::vector<double>& stops) {
  require_posed(problem);
  DiffusiveMarch march(problem, options);
  DiffusiveSolution solution;
  for (const double stop : stops) {
    march.run_to(stop, solution);
  }
  march.run_to(problem.end, solution);
  return solution;
}

}  // namespace fde
