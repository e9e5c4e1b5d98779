#include "two_sided/all_at_once.hpp"

#include <cmath>
#include <limits>
#include <optional>

#include "two_sided/linearisation.hpp"

namespace fde {
namespace {

constexpr int most_iterations = 50, most_halvings = 12;
constexpr double stagnation = 1e-10;

double largest(const Rows& y) { return y.cwiseAbs().maxCoeff(); }

class Newton {
 public:
  Newton(const AllTimes& equations, Run& run, double tolerance)
      : equations_(equations),
        run_(run),
        tolerance_(tolerance),
        linearisation_(equations),
        guess_(equations.start()),
        residual_(equations.residual(run, guess_)) {}

  // The solution; nullopt where Newton's method does not find it.
  std::optional<Rows> solve() {
    if (!std::isfinite(residual_.norm())) return std::nullopt;
    double last = std::numeric_limits<double>::infinity();
    for (int iteration = 0; iteration < most_iterations && !run_.out_of_budget(); ++iteration) {
      linearisation_.update(run_, guess_, residual_);
      const Guess increment = linearisation_.increment(residual_);
      ++*run_.cost().newton_iterations;
      const double now = largest(increment.y);
      if (!std::isfinite(now)) return std::nullopt;
      const bool whole = advance(increment);
      const double size = largest(guess_.y);
      if (whole && (now <= tolerance_ * size || (now >= last / 2 && now <= stagnation * size)))
        return std::move(guess_.y);
      if (stuck_) return std::nullopt;
      last = now;
    }
    return std::nullopt;
  }

  [[nodiscard]] std::size_t bytes() const {
    const auto values = 8 * residual_.rows.size();  // guesses, residuals and increments
    return equations_.left().bytes() + equations_.right().bytes() + linearisation_.bytes() +
           sizeof(double) * static_cast<std::size_t>(values);
  }

 private:
  // Takes the largest of the increment, its half, ... that brings the residual down. True: all of it.
  bool advance(const Guess& increment) {
    const double before = residual_.norm();
    // Smaller increments are rounding, and so is what they do to the residual.
    const bool small = largest(increment.y) <= stagnation * largest(guess_.y);
    double part = 1.0;
    for (int halving = 0; halving <= most_halvings; ++halving, part /= 2) {
      Guess trial{.y = guess_.y + part * increment.y, .unknown = guess_.unknown + part * increment.unknown};
      Residual residual = equations_.residual(run_, trial);
      const double after = residual.norm();
      if (!(after < before || (small && std::isfinite(after)))) continue;
      guess_ = std::move(trial);
      residual_ = std::move(residual);
      return halving == 0;
    }
    stuck_ = true;
    return false;
  }

  const AllTimes& equations_;
  Run& run_;
  double tolerance_;
  Linearisation linearisation_;
  Guess guess_;
  Residual residual_;
  bool stuck_ = false;
};

}  // namespace

Trajectory solve_all_at_once(const Problem& problem, const Grid& grid, const Options& options,
                             const WeightFamily& family) {
  Run run(problem, options, grid.steps);
  const AllTimes equations(problem, grid, options, family);
  Newton newton(equations, run, options.tolerance);
  const auto y = newton.solve();
  run.cost().history_bytes = newton.bytes();
  if (!y) {
    // The guess at the start stands for a result, as in every run that fails at its first step.
    if (two_sided(problem)) run.accept(0.0, run.start());
    run.fail(run.out_of_budget() ? Ending::out_of_budget : Ending::not_converged, grid.time(1));
    return run.finish();
  }
  for (int n = two_sided(problem) ? 0 : 1; n <= grid.steps; ++n) {
    if (!run.accept(grid.time(n), y->col(n))) break;
  }
  return run.finish();
}

}  // namespace fde
