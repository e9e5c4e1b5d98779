// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/observers/reaction_path.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include "fdebench/benchmarks/observers/fitted_powers.hpp"
#include "fdebench/schemes/problem/smoothness.hpp"

namespace fde::bench {

namespace {

constexpr int most_steps = 5;
// After these steps a polynomial of degree 4 has a relative error of 1e-6 in the derivative of t^p.
constexpr int first_steps = 16;

std::vector<int> steps_around(const Grid& grid, int n) {
  const int count = std::min(most_steps, grid.steps + 1);
  std::vector<int> steps(static_cast<std::size_t>(count));
  std::iota(steps.begin(), steps.end(), std::clamp(n - count / 2, 0, grid.steps + 1 - count));
  return steps;
}

// The derivatives at t of the Lagrange polynomials; t is one of the times.
Vec polynomial_weights(const std::vector<double>& times, double t) {
  const auto size = std::ssize(times);
  Vec weights = Vec::Zero(size);
  const auto at = [&](Eigen::Index k) { return times[static_cast<std::size_t>(k)]; };
  Eigen::Index here = 0;
  while (at(here) != t) ++here;
  for (Eigen::Index k = 0; k < size; ++k) {
    if (k == here) continue;
    double weight = 1.0 / (at(k) - t);
    for (Eigen::Index m = 0; m < size; ++m) {
      if (m != k && m != here) weight *= (t - at(m)) / (at(k) - at(m));
    }
    weights[k] = weight;
  }
  weights[here] = -weights.sum();
  return weights;
}

// The `count` smallest distinct powers, including 0; filled up with integers.
std::vector<double> basis_of(std::vector<double> powers, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) powers.push_back(static_cast<double>(k));
  powers = increasing(std::move(powers), same_order);
  powers.resize(count);
  return powers;
}

Vec start_weights(const std::vector<double>& times, double t, const std::vector<double>& powers) {
  const auto size = std::ssize(times);
  const auto basis = basis_of(powers, times.size());
  reference::LongMatrix values(size, size);
  reference::LongVec rates(size);
  for (Eigen::Index p = 0; p < size; ++p) {
    const auto power = static_cast<long double>(basis[static_cast<std::size_t>(p)]);
    for (Eigen::Index k = 0; k < size; ++k)
      values(p, k) = std::pow(static_cast<long double>(times[static_cast<std::size_t>(k)]) / t, power);
    rates[p] = power / t;
  }
  return least_squares(values, rates).col(0).cast<double>();
}

// Distances from t: t/4, t/16, ...
constexpr int distances = 11;
double distance(double t, int k) { return std::ldexp(t, -2 * (k + 1)); }

// Five times, including t; the farthest are at the k-th distance.
std::vector<double> times_within(double t, double end, int k) {
  const double near = distance(t, k + 1), far = distance(t, k);
  if (t + far <= end) return {t - far, t - near, t, t + near, t + far};
  return {t - far, t - near, t - distance(t, k + 2), t - distance(t, k + 3), t};
}

// The number of candidate sets of five times.
int choices(double t, double end) { return t + distance(t, 0) <= end ? distances - 1 : distances - 3; }

}  // namespace

std::vector<double> with_neighbour_times(const Reactions& reactions, const std::optional<Grid>& grid,
                                         std::vector<double> times, double end) {
  if (reactions.differentiated_columns.empty()) return times;
  std::vector<double> beside;
  for (const double t : times) {
    if (t == 0.0) continue;
    if (grid) {
      for (const int step :
           differentiation_rule(*grid, grid->nearest_index(t), reactions.start_exponents).steps)
        beside.push_back(grid->time(step));
    } else {
      std::ranges::copy(derivative_times(t, end), std::back_inserter(beside));
    }
  }
  times.insert(times.end(), beside.begin(), beside.end());
  return increasing(std::move(times));
}

ReactionPath::ReactionPath(const Scene& scene, const std::optional<Grid>& grid, const Trajectory& path)
    : scene_(scene), grid_(grid), path_(path) {}

std::vector<std::string> ReactionPath::names() const {
  return scene_.reactions ? reaction_names(scene_) : std::vector<std::string>{};
}

Vec ReactionPath::at(Eigen::Index c, In columns) const {
  // Without reactions the columns may be stored separately, and the path then has fewer times.
  if (!scene_.reactions) return {};
  const double t = path_.time(c);
  return reaction_values(scene_, t, columns, rates(t));
}

Vec ReactionPath::columns_to_differentiate_at(double t) const {
  const auto column = std::ranges::lower_bound(path_.times, t) - path_.times.begin();
  return columns_at(scene_.outputs, t, path_.y.col(column))(scene_.reactions.differentiated_columns);
}

std::optional<Vec> ReactionPath::rates(double t) const {
  if (scene_.reactions.differentiated_columns.empty() || t == 0.0) return std::nullopt;
  if (!grid_) {
    return derivative_at(t, scene_.problem.end,
                         [this](double beside) { return columns_to_differentiate_at(beside); });
  }
  const auto [steps, weights] =
      differentiation_rule(*grid_, grid_->nearest_index(t), scene_.reactions.start_exponents);
  Vec rates = Vec::Zero(std::ssize(scene_.reactions.differentiated_columns));
  for (std::size_t k = 0; k < steps.size(); ++k)
    rates += weights[static_cast<Eigen::Index>(k)] * columns_to_differentiate_at(grid_->time(steps[k]));
  return rates;
}

std::vector<double> derivative_times(double t, double end) {
  std::vector<double> times;
  for (int k = 0; k < choices(t, end); ++k)
    std::ranges::copy(times_within(t, end, k), std::back_inserter(times));
  times = increasing(std::move(times));
  std::erase(times, t);
  return times;
}

Vec derivative_at(double t, double end, const std::function<Vec(double)>& values) {
  Vec best, before;
  double least = std::numeric_limits<double>::infinity();
  for (int k = 0; k < choices(t, end); ++k) {
    const auto times = times_within(t, end, k);
    const Vec weights = polynomial_weights(times, t);
    Vec rate = weights[0] * values(times[0]);
    for (std::size_t m = 1; m < times.size(); ++m)
      rate += weights[static_cast<Eigen::Index>(m)] * values(times[m]);
    const double change = k > 0 ? (rate - before).lpNorm<Eigen::Infinity>() : least;
    if (k == 0 || change < least) best = rate;
    if (k > 0) least = std::min(least, change);
    before = std::move(rate);
  }
  return best;
}

DifferentiationRule differentiation_rule(const Grid& grid, int n, const std::vector<double>& powers) {
  DifferentiationRule rate{steps_around(grid, n), {}};
  std::vector<double> times;
  for (const int step : rate.steps) times.push_back(grid.time(step));
  const bool smooth = std::ranges::all_of(powers, is_integer_order) || n > first_steps;
  rate.weights =
      smooth ? polynomial_weights(times, grid.time(n)) : start_weights(times, grid.time(n), powers);
  return rate;
}

}  // namespace fde::bench
