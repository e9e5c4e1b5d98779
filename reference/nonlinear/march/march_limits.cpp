// SPDX-License-Identifier: MIT
#include "fdebench/reference/nonlinear/march/march_limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string>

namespace fde::reference {

void require_supported(const Problem& problem) {
  const auto require = [](bool holds, const std::string& what) {
    if (!holds) throw std::invalid_argument("reference solution: " + what);
  };
  require(problem.end > 0.0 && std::isfinite(problem.end), "the end must be positive and finite");
  require(problem.size() > 0, "no components");
  for (std::size_t i = 0; i < problem.components.size(); ++i) {
    const auto& component = problem.components[i];
    const double order = component.order;
    require(component.side == Side::left, fmt::format("component {} has a right derivative", i));
    require(is_algebraic(component) || (order > 0.0 && order <= 2.0),
            fmt::format("component {} needs an order in [0, 2], it has {}", i, order));
    require(component.initial.size() == initial_count(order),
            fmt::format("component {} needs ceil(order) initial values", i));
  }
}

double next_discontinuity(const Problem& problem, double after) {
  const auto next = std::ranges::upper_bound(problem.jump_times, after);
  return next == problem.jump_times.end() ? problem.end : std::min(*next, problem.end);
}

bool jumps_at(const Problem& problem, double t) { return std::ranges::binary_search(problem.jump_times, t); }

void add_jump_time(Problem& problem, double t) {
  const auto next = std::ranges::lower_bound(problem.jump_times, t);
  if (next == problem.jump_times.end() || *next != t) problem.jump_times.insert(next, t);
}

double last_jump(const Problem& problem, double t) {
  const auto next = std::ranges::upper_bound(problem.jump_times, t);
  return next == problem.jump_times.begin() ? 0.0 : *std::prev(next);
}

bool just_after_jump(const Problem& problem, double from, double to) {
  constexpr double settled = 1e3;
  const double jump = last_jump(problem, from);
  return to - jump <= settled * first_after_jump * jump;
}

Vec node_times(const Problem& problem, double from, double length, In nodes) {
  Vec times = from + length * nodes.array();
  const double stop = next_discontinuity(problem, from);
  if (jumps_at(problem, stop)) times = times.cwiseMin(std::nextafter(stop, 0.0));
  return times;
}

}  // namespace fde::reference
