// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/requests/quicker_scheme.hpp"

#include <mpfr.h>

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <mutex>
#include <optional>
#include <stop_token>
#include <utility>
#include <variant>

#include "fdebench/schemes/problem/progress/progress.hpp"

namespace fde::bench {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr double part = 0.01;       // of the time of the run
constexpr double usual = 1e-8;      // accuracy
constexpr Eigen::Index most = 100;  // unknowns

Tolerance accuracy_beside(const RequestedRun& run) {
  const auto* tolerance = std::get_if<Tolerance>(&run.resolution);
  return tolerance != nullptr ? *tolerance : Tolerance{usual, usual};
}

// The time in which the scheme solves the problem; nullopt: not within the budget.
std::optional<Seconds> time_within(Seconds budget, const Scheme& scheme, const Problem& problem,
                                   const Tolerance& accuracy) {
  const auto start = Clock::now();
  try {
    const auto path =
        scheme.solve(problem, accuracy, {.budget = budget.count(), .output_times = {problem.end}});
    const Seconds taken = Clock::now() - start;  // its last step may have taken it beyond the budget
    return path.status == SolveStatus::finished && taken < budget ? std::optional(taken) : std::nullopt;
  } catch (const std::exception&) {  // cancelled, or without memory: it is no quicker one
    return std::nullopt;
  }
}

std::optional<QuickerScheme> quicker_scheme(const Problem& problem, const RequestedRun& run, Seconds of_run) {
  const Tolerance accuracy = accuracy_beside(run);
  for (const Scheme& scheme : schemes()) {
    if (!scheme.capabilities.is_adaptive() || &scheme == &run.scheme) continue;
    if (unsupported_reason(scheme, problem, accuracy)) continue;
    if (const auto taken = time_within(part * of_run, scheme, problem, accuracy))
      return QuickerScheme{scheme.id, accuracy.rtol, *taken, of_run};
  }
  return std::nullopt;
}

void search(const Problem& problem, const RequestedRun& run, Seconds first,
            const std::function<void(const QuickerScheme&)>& found, const std::stop_token& stop) {
  constexpr double growth = 4.0;
  const auto start = Clock::now();
  const ProgressScope cancelled([&](std::size_t, std::size_t) {
    if (stop.stop_requested()) throw Cancelled();
  });
  std::mutex mutex;
  std::unique_lock lock(mutex);
  std::condition_variable_any never;
  for (Seconds at = first;; at = growth * (Clock::now() - start)) {
    never.wait_for(lock, stop, at - (Clock::now() - start), [] { return false; });
    if (stop.stop_requested()) return;
    const auto quicker = quicker_scheme(problem, run, Clock::now() - start);
    if (quicker && !stop.stop_requested()) return found(*quicker);
  }
}

}  // namespace

std::jthread quicker_scheme_search(const Scene& scene, const RequestedRun& run, Seconds first,
                                   std::function<void(const QuickerScheme&)> found) {
  if (scene.problem.size() > most) return {};
  return std::jthread([&, first, found = std::move(found)](const std::stop_token& stop) {
    search(scene.problem, run, first, found, stop);
    mpfr_free_cache();  // MPFR does not free its cached constants of a thread when the thread ends
  });
}

}  // namespace fde::bench
