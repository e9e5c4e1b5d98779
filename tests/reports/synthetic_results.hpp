// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
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

// The record of the run in the last session, which is added if there is none.
inline Record& record_of(Results& results, const SyntheticRun& run) {
  const RunKey key{.scene = {run.scene}, .scheme = run.scheme, .settings = {.resolution = run.steps}};
  const std::size_t session = results.sessions.size() - 1;
  const auto found = std::ranges::find_if(
      results.records, [&](const Record& other) { return other.key == key && other.session == session; });
  if (found != results.records.end()) return *found;
  return results.records.emplace_back(Record{.key = key,
                                             .steps = run.steps,
                                             .end = end_time,
                                             .ended_at = end_time,
                                             .timing = {.session = session},
                                             .session = session});
}

inline void add_value(Results& results, const SyntheticRun& run, const std::string& quantity, double value) {
  Record& of = record_of(results, run);
  (quantity.starts_with("time_") ? of.timing.values : of.values).set(quantity, value);
}

inline void add_ending(Results& results, const SyntheticRun& run, double until, const RunOutcome& ending) {
  Record& of = record_of(results, run);
  of.ended_at = until;
  of.ending = ending;
}

inline void add_run(Results& results, const SyntheticRun& run, double error, double seconds) {
  add_value(results, run, "error_end", error);
  add_value(results, run, "time_minimum", seconds);
}

// Adds runs with errors 0.01 h^rate at the end and h in the maximum norm, and times proportional to N.
inline void add_line(Results& results, const std::string& scheme, double rate, double seconds_a_step) {
  for (const int steps : all_steps) {
    const SyntheticRun run{"pendulum", scheme, steps};
    const double h = end_time / steps;
    add_value(results, run, "error_maximum", h);
    add_value(results, run, "reference_bound", 1e-15);
    add_value(results, run, "reference_bound_maximum", 1e-14);
    add_value(results, run, "expected_rate_end", rate);
    add_value(results, run, "expected_rate_maximum", 2.0);
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
