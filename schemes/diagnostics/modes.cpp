// SPDX-License-Identifier: MIT
#include "fdebench/schemes/diagnostics/modes.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <functional>
#include <numbers>
#include <vector>

#include "fdebench/schemes/diagnostics/growing_mode_count.hpp"
#include "fdebench/schemes/diagnostics/other_steps.hpp"
#include "fdebench/schemes/history/symbols/generating_function.hpp"
#include "fdebench/schemes/problem/delays.hpp"
#include "fdebench/schemes/problem/problem.hpp"
#include "fdebench/schemes/problem/scalar_equation.hpp"

namespace fde {
namespace {

using Spectrum = std::vector<ComplexValue>;

constexpr Eigen::Index largest_dense = 64;  // eigenvalues of larger matrices would take longer than the run

bool has_modes(const Problem& problem) { return !is_two_sided(problem) && !has_algebraic_rows(problem); }
bool has_delays(const Problem& problem) { return !problem.delays.lags.empty(); }

// The order of all rows; nullopt: they differ.
std::optional<double> common_order(const Problem& problem) {
  const double order = problem.components.front().order;
  const bool same =
      std::ranges::all_of(problem.components, [&](const auto& row) { return row.order == order; });
  return same ? std::optional(order) : std::nullopt;
}

// The eigenvalue of largest modulus of a large matrix, where it is real: by power iteration, with differences
// of f in place of the matrix.
Spectrum dominant(const Problem& problem, double t, const Vec& y) {
  constexpr int iterations = 30;
  constexpr double close = 0.1;  // what is left of an eigenvector's equation
  const double shift = 0x1p-18 * std::max(1.0, y.lpNorm<Eigen::Infinity>());
  Vec direction(y.size()), f(y.size()), moved(y.size());
  for (Eigen::Index i = 0; i < y.size(); ++i) direction[i] = i % 2 == 0 ? 1.0 : -0.9;
  problem.rhs(t, y, f);
  for (int i = 1; direction.allFinite() && !direction.isZero(0.0); ++i) {
    direction.normalize();
    problem.rhs(t, y + shift * direction, moved);
    const Vec image = (moved - f) / shift;
    const double eigenvalue = direction.dot(image);
    if (i == iterations) {
      const bool found = (image - eigenvalue * direction).norm() < close * std::abs(eigenvalue);
      return found ? Spectrum{eigenvalue} : Spectrum{};
    }
    direction = image;
  }
  return {};
}

// Eigenvalues of df/dy with imaginary parts that are not negative, by falling modulus.
Spectrum spectrum(const Problem& problem, double t, const Vec& y) {
  if (problem.size() > largest_dense) return dominant(problem, t, y);
  const Matrix jacobian = jacobian_at(problem, t, y);
  if (!jacobian.allFinite()) return {};
  const Eigen::VectorXcd values = jacobian.eigenvalues();
  Spectrum found;
  for (const ComplexValue value : values) {
    if (value.imag() >= 0.0) found.push_back(value);
  }
  std::ranges::sort(found, std::ranges::greater{}, [](const ComplexValue value) { return std::abs(value); });
  return found;
}

// D^g y = lambda y grows for |arg lambda| < g pi/2 (Matignon 1996).
bool grows(double order, ComplexValue rate) {
  return rate != 0.0 && std::abs(std::arg(rate)) < 0.5 * order * std::numbers::pi;
}

// The problem with its linear part at a time of the run in place of f. Of its equations a symbol takes the
// terms, and the rest from this part.
Problem frozen(const SolvedRun& run, double t) {
  const Problem& problem = run.problem;
  const Vec y = stored_at(run.path, t);
  const Past past = [&](double time, Out value) {
    if (time < 0.0) return problem.delays.before(time, value);
    value = stored_at(run.path, time);
  };
  BoundProblem bound(problem);
  bound.set_solution(past);
  const Matrix jacobian = jacobian_at(bound.problem(), t, y);
  return {.components = problem.components,
          .rhs = [=](double, In at, Out f) { f = jacobian * at; },
          .derivatives = DenseLinearPart{jacobian},
          .equations = problem.equations,
          .end = problem.end,
          .delays = linear_delays(problem.delays.lags, jacobian, delayed_jacobians_at(problem, t, y, past),
                                  Vec::Zero(y.size()))};
}

// How many modes of the scheme, or of the equation, grow; nullopt where that cannot be decided.
std::optional<int> count(const Scheme& scheme, const Problem& problem, double length) {
  constexpr Eigen::Index most_rows = 24;  // of the symbol, where a scheme splits orders
  try {
    if (symbol_of(scheme, problem, length)(ComplexValue{0.0, 1.0}).rows() > most_rows) return std::nullopt;
    return count_growing_modes(scheme, problem, length);
  } catch (const std::exception&) {
    return std::nullopt;
  }
}
std::optional<int> count(const Problem& problem, double length) {
  try {
    return count_growing_modes(problem, length);
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

// Of eigenvalues whose modes of the equation do not grow, whether those of the scheme do.
bool unstable_at(const Scheme& scheme, double order, const Spectrum& rates, double length) {
  constexpr std::size_t looked_at = 2;  // of the largest
  const auto unstable = [&](const ComplexValue rate) {
    return rate != 0.0 && !grows(order, rate) &&
           count(scheme, scalar_equation(order, rate), length).value_or(0) > 0;
  };
  const auto end = rates.begin() + static_cast<std::ptrdiff_t>(std::min(looked_at, rates.size()));
  return std::any_of(rates.begin(), end, unstable);
}

bool unstable_at(const SolvedRun& run, double t, double length) {
  constexpr Eigen::Index largest = 8;
  if (run.problem.size() > largest) return false;
  const Problem linear_problem = frozen(run, t);
  const auto of_scheme = count(run.scheme, linear_problem, length);
  if (!of_scheme || *of_scheme == 0) return false;
  const auto of_equation = count(linear_problem, length);
  return of_equation && *of_scheme > *of_equation;
}

// True also where that cannot be decided.
bool equation_grows(const SolvedRun& run, double t, double length) {
  const Problem& problem = run.problem;
  if (problem.size() > largest_dense) return true;
  if (const auto order = common_order(problem)) {
    return std::ranges::any_of(spectrum(problem, t, stored_at(run.path, t)),
                               [&](const ComplexValue rate) { return grows(*order, rate); });
  }
  return count(frozen(run, t), length) != 0;
}

double step_at(const Grid& grid, double t) { return grid.step(std::max(1, grid.nearest_index(t))); }

// What is left of an initial value, the most of all components; 1 where all are 0.
double part_left(const SolvedRun& run, const Vec& start) {
  const Vec sizes = late_sizes(run);
  double left = start.isZero(0.0) ? 1.0 : 0.0;
  for (Eigen::Index i = 0; i < start.size(); ++i) {
    if (start[i] != 0.0) left = std::max(left, sizes[i] / std::abs(start[i]));
  }
  return left;
}

// The modes e^(st) of the linear part at the start, where all orders are equal.
Spectrum oscillations(const SolvedRun& run) {
  Spectrum modes;
  if (!has_eigenvalue_modes(run.problem)) return modes;
  const auto order = common_order(run.problem);
  for (const ComplexValue rate : spectrum(run.problem, 0.0, stored_at(run.path, 0.0))) {
    // What is not in this sector decays like a power of t.
    if (rate != 0.0 && std::abs(std::arg(rate)) < *order * std::numbers::pi)
      modes.push_back(std::pow(rate, 1.0 / *order));
  }
  return modes;
}

// Whether a mode e^(st) of D^orders y = jacobian y, order 0 an algebraic row, oscillates faster than `least`
// and decays no faster than `decay`, |s| > least, pi/4 < arg s < 3 pi/4 and Re s > -decay. The change of the
// argument of the determinant is counted along the boundary of this region in log s, up to |s| = e^30 least,
// an oscillation that no grid can follow.
bool has_oscillation(const Problem& problem, const Matrix& jacobian, double least, double decay) {
  using namespace std::complex_literals;
  constexpr double most = 30.0, turn_of_row = 0.3,
                   turn_of_all = 3.0;  // change of log |s|; radians on a piece
  constexpr double quarter = 0.25 * std::numbers::pi;
  const Vec orders = orders_of(problem);
  const double first = std::log(least), last = first + most;
  const auto log_f = [&](double log_size, double angle) {
    ComplexMatrix matrix = -jacobian.cast<ComplexValue>();
    for (Eigen::Index i = 0; i < orders.size(); ++i) {
      const ComplexValue power = orders[i] == 0.0 ? 0.0 : std::exp(orders[i] * (log_size + 1i * angle));
      matrix(i, i) += power;
      if (std::abs(power) > 1.0) matrix.row(i) /= std::abs(power);
    }
    return log_determinant(matrix);
  };
  const auto steepest = [&](double log_size) {
    return 2.0 * quarter + std::asin(std::min(decay * std::exp(-log_size), std::sin(quarter)));
  };
  const auto turned = [&](double length, const std::function<ComplexValue(double)>& log_of) {
    const double pieces = length * std::max(orders.maxCoeff() / turn_of_row, orders.sum() / turn_of_all);
    std::vector points{0.0};
    append_pieces(1.0, static_cast<int>(std::ceil(pieces)), points);
    return argument_change(log_of, points);
  };
  const double angle_at_first = steepest(first), angle_at_last = steepest(last);
  const double all =
      turned(most, [&](double p) { return log_f(first + p * most, quarter); }) +
      turned(quarter, [&](double p) { return log_f(last, quarter + p * (angle_at_last - quarter)); }) +
      turned(most, [&](double p) { return log_f(last - p * most, steepest(last - p * most)); }) +
      turned(quarter,
             [&](double p) { return log_f(first, angle_at_first + p * (quarter - angle_at_first)); });
  return !(std::abs(all) < std::numbers::pi);  // NaN: a zero is on the boundary
}

// Backward Euler's method damps a mode until the end by the exponential of half of this.
double damping(const Grid& grid, ComplexValue mode) {
  return mode.imag() * mode.imag() * step_at(grid, grid.end) * grid.end;
}

}  // namespace

std::optional<std::string> unstable_modes(const SolvedRun& run) {
  if (!has_modes(run.problem) || !run.scheme.symbol) return std::nullopt;
  for (const double t : spread_times(run.grid)) {
    const double length = step_at(run.grid, t);
    const bool by_eigenvalues =
        !run.scheme.capabilities.discretises_equations && has_eigenvalue_modes(run.problem);
    const bool unstable = by_eigenvalues
                              ? unstable_at(run.scheme, *common_order(run.problem),
                                            spectrum(run.problem, t, stored_at(run.path, t)), length)
                              : unstable_at(run, t, length);
    if (!unstable) continue;
    return fmt::format(
        "a step of {:.3g} is outside the region of stability of {} for the linear part at t = "
        "{:.3g}",
        length, run.scheme.id, t);
  }
  return std::nullopt;
}

std::optional<std::string> growth_of_its_own(const SolvedRun& run) {
  constexpr double many_times = 1e3;
  const Problem& problem = run.problem;
  if (!has_modes(problem) || has_delays(problem)) return std::nullopt;
  const Vec start = stored_at(run.path, 0.0);
  Vec load = Vec::Zero(start.size()), f(start.size());
  const double initial = taylor_part(problem, run.grid.end).lpNorm<Eigen::Infinity>();
  const double reached = late_sizes(run).head(problem.size()).maxCoeff();
  const auto is_expected_from_load_at = [&](double t) {
    problem.rhs(t, start, f);
    load = load.cwiseMax(f.cwiseAbs());
    double expected = initial;
    for (Eigen::Index i = 0; i < load.size(); ++i) {
      const double order = problem.component(i).order;
      expected += std::pow(run.grid.end, order) / std::tgamma(order + 1.0) * load[i];
    }
    return !(reached > many_times * expected);
  };
  if (std::ranges::any_of(spread_times(run.grid), is_expected_from_load_at)) return std::nullopt;
  // The load may be a pulse that only the steps have met.
  for (int n = 1; n <= run.grid.steps; ++n)
    if (is_expected_from_load_at(run.grid.time(n))) return std::nullopt;
  for (const double t : spread_times(run.grid)) {
    if (equation_grows(run, t, step_at(run.grid, t))) return std::nullopt;
  }
  return fmt::format("the run grows to {:.3g}, the linear part of the equation has no mode that grows",
                     reached);
}

bool has_eigenvalue_modes(const Problem& problem) {
  return has_modes(problem) && !has_delays(problem) && common_order(problem).has_value();
}

bool may_damp_oscillation(const SolvedRun& run) {
  constexpr double slightly = 0.2;
  const double end = run.grid.end, slowest = std::log(significant_part) / end;
  if (has_eigenvalue_modes(run.problem)) {
    return std::ranges::any_of(oscillations(run), [&](const ComplexValue mode) {
      return mode.real() > slowest && damping(run.grid, mode) > slightly;
    });
  }
  if (run.problem.size() > largest_dense || has_delays(run.problem)) return true;
  const double least = std::sqrt(slightly / damping(run.grid, {0.0, 1.0}));
  for (const double t : spread_times(run.grid)) {
    const Matrix jacobian = jacobian_at(run.problem, t, stored_at(run.path, t));
    if (!jacobian.allFinite() || has_oscillation(run.problem, jacobian, least, -slowest)) return true;
    if (is_linear(run.problem)) return false;
  }
  return false;
}

std::optional<std::string> lost_oscillation(const SolvedRun& run) {
  const double left = part_left(run, stored_at(run.path, 0.0));
  if (!(left < significant_part)) return std::nullopt;
  const Grid& grid = run.grid;
  for (const ComplexValue mode : oscillations(run)) {
    if (left >= significant_part * std::exp(mode.real() * grid.end) || damping(grid, mode) <= 1.0) continue;
    return fmt::format(
        "the run decays faster than an oscillation of the equation, of period {:.3g}: a step is {:.3g}",
        2.0 * std::numbers::pi / std::abs(mode.imag()), step_at(grid, grid.end));
  }
  return std::nullopt;
}

}  // namespace fde
