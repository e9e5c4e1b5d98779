#include "stepping/run.hpp"

#include <utility>

namespace fde {

Run::Run(const Problem& problem, const Grid& grid, const Options& options)
    : problem_(problem), options_(options), start_(taylor_part(problem, 0.0)), f_(problem.size()) {
  path_.grid = grid;
  path_.cost.states = static_cast<int>(problem.size());
  const std::size_t kept =
      options.keep.empty() ? static_cast<std::size_t>(grid.steps) + 1 : options.keep.size();
  path_.steps.reserve(kept);
  path_.y.resize(problem.size(), static_cast<Eigen::Index>(kept));
  if (!two_sided(problem)) record(0, start_);
}

const Vec& Run::rhs(double t, In y) {
  ++path_.cost.rhs_calls;
  problem_.rhs(t, y, f_);
  return f_;
}

bool Run::accept(int n, In y) {
  // At every step a look at the clock would be a quarter of the cheapest step.
  constexpr int steps_between_looks = 16;
  if (!y.allFinite()) {
    fail(Ending::not_finite);
  } else if (!problem_.domain.contains(path_.grid.time(n), y)) {
    fail(Ending::singular);
  } else if ((n < steps_between_looks || n % steps_between_looks == 0) && out_of_budget()) {
    fail(Ending::out_of_budget);
  }
  if (path_.ending != Ending::finished) return false;
  path_.reached = n;
  record(n, y);
  return true;
}

bool Run::out_of_budget() const {
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin_;
  return taken.count() > options_.budget;
}

void Run::record(int n, In y) {
  if (options_.watch) options_.watch(n, y);
  if (!options_.keep.empty()) {
    if (next_kept_ == options_.keep.size() || options_.keep[next_kept_] != n) return;
    ++next_kept_;
  }
  path_.y.col(static_cast<Eigen::Index>(path_.steps.size())) = y;
  path_.steps.push_back(n);
}

Trajectory Run::finish() {
  path_.y.conservativeResize(Eigen::NoChange, static_cast<Eigen::Index>(path_.steps.size()));
  return std::move(path_);
}

std::vector<WeightTable> tables(const Problem& problem, const WeightFamily& family) {
  std::vector<WeightTable> result;
  for (const auto& component : problem.components) result.push_back({&family, component.order});
  return result;
}

StepFactors::StepFactors(std::vector<WeightTable> tables, const Grid& grid)
    : tables_(std::move(tables)), grid_(grid), factors_(static_cast<Eigen::Index>(tables_.size())) {}

const Vec& StepFactors::at(int n) {
  if (n > 1 && grid_.uniform()) return factors_;
  for (std::size_t i = 0; i < tables_.size(); ++i) {
    factors_[static_cast<Eigen::Index>(i)] = step_factor(tables_[i], grid_.step(n));
  }
  return factors_;
}

}  // namespace fde
