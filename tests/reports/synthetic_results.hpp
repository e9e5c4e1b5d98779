// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "fdebench/benchmarks/records/record.hpp"

// Synthetic results for tests of reports.
namespace fde::bench {

inline constexpr double end_time = 8.0;
inline const std::vector<int> all_steps{64, 128, 256, 512};

inline Results empty_results() {
  return {.sessions = {{.date = "2025-01-02T03:04:05Z",
                        .machine = "the machine",
                        .system = "",
                        .compiler = "the compiler",
                        .flags = "-O3",
                        .commit = "0123abc",
                        .version = ""}},
          .records = {}};
}

struct SyntheticRun {
  std::string scene, scheme;
  int steps;
};

inline void add_row(Results& results, const SyntheticRun& run, const std::string& quantity, double value) {
  results.records.push_back(
      {.key = {.scene = {run.scene}, .scheme = run.scheme, .setup = {.resolution = run.steps}},
       .steps = run.steps,
       .h = end_time / run.steps,
       .quantity = quantity,
       .value = value,
       .session = results.sessions.size() - 1});
}

inline void add_ending(Results& results, const SyntheticRun& run, double until,
                       const RunOutcome& ending = {}) {
  add_row(results, run, "ending", until);
  results.records.back().ending = ending;
}

inline void add_run(Results& results, const SyntheticRun& run, double error, double seconds) {
  add_row(results, run, "error_end", error);
  add_row(results, run, "time_minimum", seconds);
  add_ending(results, run, end_time);
}

// Adds runs with errors 0.01 h^rate at the end and h in the maximum norm, and times proportional to N.
inline void add_line(Results& results, const std::string& scheme, double rate, double seconds_a_step) {
  for (const int steps : all_steps) {
    const SyntheticRun run{"pendulum", scheme, steps};
    const double h = end_time / steps;
    add_row(results, run, "error_maximum", h);
    add_row(results, run, "reference_bound", 1e-15);
    add_row(results, run, "reference_bound_maximum", 1e-14);
    add_row(results, run, "expected_rate_end", rate);
    add_row(results, run, "expected_rate_maximum", 2.0);
    add_run(results, run, 0.01 * std::pow(h, rate), seconds_a_step * steps);
  }
}

// The pendulum as results describe it; its reference is computed by two methods in a quarter of a second.
inline SceneDescription described_pendulum() {
  return {.scene = {"pendulum"},
          .title = "Fractional pendulum",
          .source = "a paper on pendulums",
          .equations = {{"D(phi, 2)", "-sin(phi)"}},
          .parameters = {{"beta", "0.5", "an order"}},
          .evidence = "two methods",
          .reference_seconds = 0.25,
          .solution = SampledSolution{.t = {0.0, 8.0}, .columns = {{"phi"}, {{1.0, 0.75}}}, .bound = 1e-15}};
}

// Errors at the end: l1 4.4e-4, 1.6e-4, 5.5e-5, 2.0e-5; adams_pc 1.6e-4, 3.9e-5, 9.8e-6, 2.4e-6.
inline Results two_lines() {
  Results results = empty_results();
  add_line(results, "l1", 1.5, 1e-6);
  add_line(results, "adams_pc", 2.0, 3e-6);
  results.scenes = {described_pendulum()};
  return results;
}

}  // namespace fde::bench
