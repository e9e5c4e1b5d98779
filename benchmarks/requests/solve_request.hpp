// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "fdebench/benchmarks/records/run_settings.hpp"
#include "fdebench/benchmarks/text/range.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {

// What the fields of a request may be.
inline constexpr int most_steps = 1'000'000'000;  // the weights are tested up to this lag
inline constexpr int most_rows = 10'000'000;      // of a table
inline constexpr CountRange step_counts{1, most_steps}, point_counts{2, most_rows}, thread_counts{1, 1024};
inline constexpr Range newton_tolerances{.low = 0.0, .high = 1.0}, gradings{.low = 1.0, .high = 100.0};

// The times of a table: all times of the run; times of its grid, in any order; each k-th time of the grid and
// the last; or so many from 0 to the end, equally spaced in the number of the step, or in time without a
// grid.
struct AllTimes {};
struct GivenTimes {
  std::vector<double> times;
};
struct EveryTime {
  int stride;
};
struct SpreadTimes {
  int count;
};
using OutputTimes = std::variant<AllTimes, GivenTimes, EveryTime, SpreadTimes>;

// A run that keeps its state in a file, and goes on from the state in it.
struct CheckpointRequest {
  std::filesystem::path file;
  std::chrono::duration<double> between{300.0};
};

// What is asked of solve(). In messages its fields are steps, accuracy, grid, history, tolerance and budget
// (the settings), at, every and points (the times), events, all, field, check, threads, checkpoint and
// scheme.
struct SolveRequest {
  std::string scheme{};                                     // an id
  RunSettings settings{.resolution = 0, .budget = 3600.0};  // the resolution has to be given
  bool optimal_grading = false;  // takes that of optimal_grading() in place of settings.grading
  OutputTimes times{};
  bool events = false;         // a table of the events of the scene in place of times
  bool all_solutions = false;  // of a problem at both ends
  bool field = false;          // all unknowns besides the columns
  bool check = false;          // compares with half of the steps in any case
  int threads = 1;             // among which a step of many unknowns is divided; the result has the same bits
  std::optional<CheckpointRequest> checkpoint{};
};

// The one of two or three fields that is given. Each throws Refusal where the fields are not in their ranges
// or exclude each other, and resolution_from where none is given. An accuracy is a tolerance, relative and
// absolute; where it is given besides steps, it counts.
StepsOrTolerance resolution_from(const std::optional<int>& steps, const std::optional<double>& accuracy);
OutputTimes output_times_from(std::optional<std::vector<double>> at, const std::optional<int>& every,
                              const std::optional<int>& points);

// The grading of "uniform" or "graded:R"; nullopt for "graded:auto", the optimal one. Throws Refusal.
inline constexpr std::string_view optimal_grid = "graded:auto";
std::optional<double> parse_grid(std::string_view text);
// Sets the grading of the request to it.
void set_grid(SolveRequest& request, std::string_view text);

// Throw Refusal naming steps, accuracy, grid or tolerance where a value is not in its range.
void require_allowed(const StepsOrTolerance& resolution);
void require_allowed(const RunSettings& settings);  // but for resolution and budget

// The scheme with this id. Throws std::invalid_argument with the ids that there are.
const Scheme& scheme_named(std::string_view id);

}  // namespace fde::bench
