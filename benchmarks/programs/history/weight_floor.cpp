// SPDX-License-Identifier: MIT
// The error of the product trapezoidal rule when its weights are evaluated in double by the published
// formula, a second difference of nearly equal powers. The scene is relaxation: D^(1/2) y = -y up to t = 1.
// CSV, one row a run; the optional argument is the largest number of steps, default 1e7. All errors are
// absolute, at the end.
//
//   grid            uniform, or graded:4 for the times (n/steps)^4
//   steps           N
//   error           of the scheme with our weights and the history as exponentials
//   naive_last_sum  change of y_N by the published weights in the sum of step N alone; uniform grids
//   naive_error     of the plain O(N^2) loop with the published weights in every step; N up to 2^14
//
// Each published weight has an error of about u k^(g+1), u = 2^-53, but adjacent weights contain the same
// rounded powers: after summation by parts the error of a power is multiplied by a second difference of f.
// The remaining error comes from t = 0, where N^(g+1) in the oldest weight and (N-1-g) N^g in the start
// weight are rounded differently: about u N in y_N. (Here g = 1/2: if N is a square, both are exact and this
// error vanishes too.) A more accurate start weight alone does not help, because the error of the oldest
// weight is then not cancelled. On a graded grid the same mismatch is divided by t_1 = N^-4.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <utility>

#include "fdebench/benchmarks/programs/figures.hpp"
#include "fdebench/benchmarks/scenes/registry.hpp"
#include "fdebench/benchmarks/sweep/measured_run.hpp"
#include "fdebench/schemes/history/weights/kernel_moments.hpp"
#include "fdebench/schemes/history/weights/weights.hpp"

namespace fde::bench::figures {
namespace {

// D^order y = rate y.
struct Relaxation {
  Scene scene;
  double order, rate, start, end_value;
};

Relaxation relaxation() {
  Scene scene = make_scene(built_in_scenes().named("relaxation"));
  const Component component = scene.problem.components.front();
  const double rate = std::get<DenseLinearPart>(scene.problem.derivatives).matrix(0, 0);
  const double end_value = scene.reference.at(scene.problem.end).value[0];
  return {std::move(scene), component.order, rate, component.initial[0], end_value};
}

double printed_weight(double g, double k) {
  return std::pow(k + 1, g + 1) - 2 * std::pow(k, g + 1) + std::pow(k - 1, g + 1);
}

double printed_start_weight(double g, double n) {
  return std::pow(n - 1, g + 1) - (n - 1 - g) * std::pow(n, g);
}

double naive_last_sum(const Relaxation& equation, const Grid& grid, const Trajectory& path) {
  const WeightTable table{&families::trapezoid, equation.order};
  const int n = grid.steps;
  double sum = (printed_start_weight(equation.order, n) - *first_sample_weight(table, n)) * path.y(0, 0);
  for (int k = 1; k < n; ++k) {
    sum += (printed_weight(equation.order, k) - weight(table, k)) * path.y(0, n - k);
  }
  return std::abs(step_factor(table, grid.step()) * equation.rate * sum);
}

// The rule with any weights. memory_term(n, y) is the memory term of step n times Gamma(order + 2).
template <typename Past>
double error_of_loop(const Relaxation& equation, const Grid& grid, const Past& memory_term) {
  const WeightTable table{&families::trapezoid, equation.order};
  const double scale = equation.rate / std::tgamma(equation.order + 2);
  Vec y(grid.steps + 1);
  y[0] = equation.start;
  for (int n = 1; n <= grid.steps; ++n) {
    const double newest = equation.rate * step_factor(table, grid.step(n));
    y[n] = (equation.start + scale * memory_term(n, y)) / (1 - newest);
  }
  return std::abs(y[grid.steps] - equation.end_value);
}

double naive_error_uniform(const Relaxation& equation, const Grid& grid) {
  const double g = equation.order, unit = std::pow(grid.step(), g);
  Vec weights(grid.steps);
  for (int k = 1; k < grid.steps; ++k) weights[k] = printed_weight(g, k);
  return error_of_loop(equation, grid, [&](int n, const Vec& y) {
    double sum = printed_start_weight(g, n) * y[0];
    for (int j = 1; j < n; ++j) sum += weights[n - j] * y[j];
    return unit * sum;
  });
}

// The published weights for any times: the start weight is ((t-t_1)^(g+1) + t^g ((g+1) t_1 - t)) / t_1, the
// weight of t_j is the difference of the slopes of (t-s)^(g+1) on the intervals before and after t_j.
// Adjacent weights contain the same powers.
double naive_error_graded(const Relaxation& equation, const Grid& grid) {
  const double g = equation.order;
  Vec times(grid.steps + 1);
  for (int n = 0; n <= grid.steps; ++n) times[n] = grid.time(n);
  return error_of_loop(equation, grid, [&](int n, const Vec& y) {
    const double now = times[n], first = times[1];
    double before = std::pow(now, g + 1), here = std::pow(now - first, g + 1);
    double sum = (here + std::pow(now, g) * ((g + 1) * first - now)) / first * y[0];
    for (int j = 1; j < n; ++j) {
      const double after = std::pow(now - times[j + 1], g + 1);
      sum +=
          ((after - here) / (times[j + 1] - times[j]) + (before - here) / (times[j] - times[j - 1])) * y[j];
      before = here;
      here = after;
    }
    return sum;
  });
}

void print_row(const Relaxation& equation, const Grid& grid) {
  constexpr int longest_loop = 1 << 14;
  const auto path = find_scheme("product_trapezoidal")
                        ->solve(equation.scene.problem, grid, {.history = HistoryKind::exponentials});
  const auto cell = [](bool computed, auto value) { return computed ? fmt::format("{:.3e}", value()) : ""; };
  fmt::print("{},{},{:.3e},{},{}\n", grid.uniform() ? "uniform" : fmt::format("graded:{}", grid.grading),
             grid.steps, std::abs(path.y(0, grid.steps) - equation.end_value),
             cell(grid.uniform(), [&] { return naive_last_sum(equation, grid, path); }),
             cell(grid.steps <= longest_loop, [&] {
               return grid.uniform() ? naive_error_uniform(equation, grid)
                                     : naive_error_graded(equation, grid);
             }));
  std::fflush(stdout);
}

// 100, 200, 500, 1000, ... steps.
void print_rows(const Relaxation& equation, double grading, double most_steps) {
  for (double decade = 100; decade <= most_steps; decade *= 10) {
    for (const double steps : {decade, 2 * decade, 5 * decade}) {
      if (steps > most_steps) return;
      print_row(equation,
                {.end = equation.scene.problem.end, .steps = static_cast<int>(steps), .grading = grading});
    }
  }
}

}  // namespace

void weight_floor(const Words& words) {
  const double most_steps = words.empty() ? 1e7 : std::strtod(words[0].c_str(), nullptr);
  if (!(most_steps >= 100 && most_steps <= 1e9))
    throw std::invalid_argument("the largest number of steps has to be in [100, 1e9]");
  const Relaxation equation = relaxation();
  fmt::print("grid,steps,error,naive_last_sum,naive_error\n");
  print_rows(equation, 1, most_steps);
  print_rows(equation, 4, std::min(most_steps, 1e6));
}

}  // namespace fde::bench::figures
