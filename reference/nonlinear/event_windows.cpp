// SPDX-License-Identifier: MIT
#include "fdebench/reference/nonlinear/event_windows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>

#include "fdebench/reference/nonlinear/march/march_limits.hpp"

namespace fde::reference {
namespace {

using Events = std::vector<ResetEvent>;

// The number of the event in a run, which may have it just behind the end.
const ResetEvent* event_of(const Events& events, std::size_t number) {
  return number < events.size() ? &events[number] : nullptr;
}

[[noreturn]] void differ(double one, double other) {
  throw std::runtime_error(fmt::format(
      "two methods: an event that sets unknowns is at t = {:.10g} by one run and at t = {:.10g} by "
      "another",
      one, other));
}

}  // namespace

EventWindows::EventWindows(const PiecewiseSolution& solution, const PiecewiseSolution& other,
                           const DiffusiveSolution& second)
    : size_(solution.problem().size()) {
  constexpr double rounding = 1e-14, next_to_end = 1e-8, unpassed = 1e-12, most_apart = 1e-3;  // relative
  const double end = solution.problem().end;
  const double settled = has_algebraic_rows(solution.problem()) ? 10.0 * first_after_jump : 0.0;
  const std::array<const Events*, 3> runs{&solution.events(), &other.events(), &second.events};
  const auto count = std::ranges::max(runs, {}, [](const Events* of) { return of->size(); })->size();
  double before = 0.0;
  for (std::size_t number = 0; number < count; ++number) {
    double first = end, last = 0.0;
    Vec jump = Vec::Zero(size_);
    bool depends_on_y = false;
    for (const auto* events : runs) {
      const auto* event = event_of(*events, number);
      const double t = event == nullptr ? end : event->t;
      first = std::min(first, t);
      last = std::max(last, t);
      depends_on_y = depends_on_y || event == nullptr || event->depends_on_y;
      if (event != nullptr) jump = jump.cwiseMax(event->jump.cwiseAbs());
    }
    const bool all_have_it =
        std::ranges::all_of(runs, [&](const Events* events) { return number < events->size(); });
    if (!all_have_it && first < end * (1.0 - next_to_end)) {
      throw std::runtime_error(fmt::format(
          "two methods: an event that sets unknowns, at t = {:.10g} by one run, is not found by another",
          first));
    }
    if (last - first > most_apart * (first - before)) differ(first, last);
    before = last;
    const double margin = depends_on_y || last > first ? last - first + rounding * last : 0.0;
    if (margin == 0.0 && settled == 0.0) continue;
    Window window{first - margin, std::min(std::max(last + margin, last * (1.0 + settled)), end), jump};
    window.jump += (solution.at(window.to) - solution.at(window.from)).cwiseAbs();
    windows_.push_back(window);
  }
  for (const auto* behind : {&solution.event_at_end(), &other.event_at_end(), &second.event_at_end})
    if (*behind) windows_.push_back({end * (1.0 - 2.0 * unpassed), end, (*behind)->jump});
}

bool EventWindows::contains(double t) const {
  return std::ranges::any_of(windows_,
                             [&](const Window& window) { return window.from <= t && t <= window.to; });
}

std::optional<double> EventWindows::beginning(double from, double to) const {
  const auto found = std::ranges::find_if(
      windows_, [&](const Window& window) { return from < window.from && window.from < to; });
  return found == windows_.end() ? std::nullopt : std::optional(found->from);
}

Vec EventWindows::jump_within(double from, double to) const {
  Vec most = Vec::Zero(size_);
  for (const Window& window : windows_)
    if (window.from < to && from < window.to) most = most.cwiseMax(window.jump);
  return most;
}

}  // namespace fde::reference
