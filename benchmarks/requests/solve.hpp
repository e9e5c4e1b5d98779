// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/requests/failure.hpp"
#include "fdebench/benchmarks/requests/quicker_scheme.hpp"
#include "fdebench/benchmarks/requests/run_progress.hpp"
#include "fdebench/benchmarks/requests/solve_cost.hpp"
#include "fdebench/benchmarks/requests/solve_request.hpp"
#include "fdebench/benchmarks/scenes/scene.hpp"
#include "fdebench/schemes/diagnostics/warnings.hpp"

namespace fde::bench {

// What comes of a run: its columns at all its times, at the requested ones, or at its events; or those of
// several solutions.
struct SolvedTable {
  std::vector<std::string> names{};
  std::vector<double> times{};
  std::optional<std::vector<std::string>> events{};  // at these times, where events are requested
  std::optional<std::vector<int>> solutions{};       // of each time, from 1, where all are requested
  Rows values{};                                     // one row a name, one column a time
  Rows field{};                     // the unknowns, one column a time, where they are requested
  std::string ended{};              // by which event and when the run ended before its end; empty: it did not
  std::vector<Warning> warnings{};  // what speaks against the values
  SolveCost cost{};
  std::filesystem::path checkpoint{};  // of no use once the table is written; empty: there is none
};

// The warnings in one line; empty without any.
std::string warning_text(const std::vector<Warning>& warnings);

// A run that did not come to its end.
struct RunFailure : NumericalFailure {
  RunFailure(const std::string& message, std::string_view scheme_id, const Trajectory& path)
      : NumericalFailure(message), scheme(scheme_id), step(path.steps + 1), time(path.failure_time) {}
  std::string scheme;
  std::int64_t step;           // without a result
  std::optional<double> time;  // of that step
};

// What a solve reports while it lasts: its progress; once that its checkpoint cannot be written, which does
// not end it; and once, in another thread, that another scheme is quicker: the search for one
// (quicker_scheme.hpp) begins when the run has taken `long_run`.
struct SolveListener {
  std::function<void(const Progress&)> progress{};
  std::function<void(const std::string&)> complain{};
  std::function<void(const QuickerScheme&)> quicker{};
  std::chrono::duration<double> long_run{5.0};
};

// Solves a scene as the request says. Throws Refusal naming a field, std::invalid_argument for a scheme that
// there is not or a checkpoint of another run, RunFailure, and NumericalFailure where a column is not finite.
SolvedTable solve(const Scene& scene, const SolveRequest& request, const SolveListener& listener = {});

}  // namespace fde::bench
