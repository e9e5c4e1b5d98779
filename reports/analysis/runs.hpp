#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "measures/time_spread.hpp"
#include "records/record.hpp"
#include "scenes/registry.hpp"

namespace fde {

// All rows of one run side by side.
struct MeasuredRun {
  RunKey key{};
  int steps = 0;
  double h = 0.0;
  std::size_t session = 0;  // of its examination; index into Results::sessions
  RunEnding ending{};
  std::map<std::string, double, std::less<>> values{};  // by quantity
  bool wall_clock = false;                              // its times are of whole processes

  // The value of a quantity; nullopt: not measured.
  [[nodiscard]] std::optional<double> operator[](std::string_view quantity) const;
};

// What a solve of the run takes; of results without an interval from the least time to the median. nullopt:
// it is not timed.
std::optional<TimeSpread> time_of(const MeasuredRun& run);

// The runs of a results file, ordered by scene, scheme (as in their lists) and setup, the coarsest first. A
// run that was made in several sessions counts with the last one; its times may be of a later session of the
// same build.
struct Runs {
  std::vector<MeasuredRun> finished, failed;  // failed: refused, or with another ending than finished
};

Runs runs_of(const Results& results);

// A results file as sessions and runs, as runs_of makes them. Rows are not held, which take twice the size of
// the file. Throws std::invalid_argument naming the file where it holds no run, and as scan_results does.
struct ReadRuns {
  std::vector<Session> sessions{};
  Runs runs{};
};
ReadRuns read_runs(const std::filesystem::path& file, const Scenes& known = scenes());
ReadRuns read_runs(const Results& results);

// Neighbouring runs of the same scene; of the same scene, scheme and setup but for the resolution: a line of
// a chart, the coarsest first.
using RunSpan = std::span<const MeasuredRun>;
std::vector<RunSpan> by_scene(RunSpan runs);
std::vector<RunSpan> by_line(RunSpan runs);

// The neighbouring runs of this scene; empty: none.
RunSpan of_scene(RunSpan runs, const SceneSettings& scene);

}  // namespace fde
