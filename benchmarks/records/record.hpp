// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/measures/by_quantity.hpp"
#include "fdebench/benchmarks/measures/column_errors.hpp"
#include "fdebench/benchmarks/measures/run_outcome.hpp"
#include "fdebench/benchmarks/observers/course.hpp"
#include "fdebench/benchmarks/records/run_settings.hpp"
#include "fdebench/benchmarks/records/scene_description.hpp"
#include "fdebench/benchmarks/scenes/parameters.hpp"

namespace fde::bench {

struct Assessment;
struct TimedSolves;

// Identifies a run of one build, or a trajectory of another program. In the latter case `scheme` is the name
// of the program, and of the settings only the number of times is known; if a sweep started the program, also
// the requested steps and grid. A scheme of the caller counts as a program, with all settings.
struct RunKey {
  SceneSettings scene{};
  std::string scheme{};
  RunSettings settings{};
  bool external = false;  // of another program, or of a scheme of the caller

  auto operator<=>(const RunKey&) const = default;  // NOLINT(readability-implicit-bool-conversion)
};

// What another program says of itself: the code that it runs, its version, and the language with its
// implementation. All may be empty.
struct ProgramFacts {
  std::string code{}, version{}, language{};

  bool operator==(const ProgramFacts&) const = default;
};

// The times of a run and the conditions under which they were measured, by TimeMeasure.
struct Timing {
  QuantityValues values{};  // empty: not timed
  bool wall_clock = false;  // of whole processes, for a program that reports no times
  bool first_run = false;   // the times are made those of the first run of a process (count_first_runs)
  int count = 0;            // how often the run was timed
  std::size_t session = 0;  // of the last timing, index into Results::sessions

  // Whether other work on the machine disturbed the last timing.
  [[nodiscard]] bool is_disturbed() const { return values["disturbed"].value_or(0.0) > 0.0; }
};
Timing timing_of(const TimedSolves& timed);

// A run and what was measured of it: a line of a results file.
struct Record {
  RunKey key{};
  int steps = 0;           // taken
  double end = 0.0;        // of the interval of time that is solved
  RunOutcome ending{};     // how the run ended, and
  double ended_at = 0.0;   // the time at which it stopped or lost its accuracy, otherwise the end
  ProgramFacts program{};  // of another program only
  ColumnErrors columns{};
  QuantityValues values{};                               // by Measure
  std::map<std::string, Course, std::less<>> courses{};  // of the measures that have one
  Timing timing{};
  std::size_t session = 0;  // of the examination, index into Results::sessions

  // The value of a measure, or of a measure of its times; nullopt: not measured.
  [[nodiscard]] std::optional<double> operator[](std::string_view quantity) const;

  // The mean step size; 0 without a step.
  [[nodiscard]] double h() const { return steps > 0 ? end / steps : 0.0; }

  // The session of the times, or of the examination of a run without times.
  [[nodiscard]] std::size_t last_session() const { return timing.values.empty() ? session : timing.session; }

  // Takes later times in place of those before.
  void take(Timing later);

  // Whether nothing is left to measure: it is timed, or it was not compared up to its end.
  [[nodiscard]] bool is_complete() const;
};

// The run with this assessment in place of an earlier one, without times.
Record assessed(Record run, const Assessment& judgement);

// Times of a run that was examined before: a line with its key and nothing else.
struct LaterTimes {
  RunKey key{};
  Timing timing{};
};

// Where and with which build numbers were computed.
struct Session {
  std::string date, machine, system, compiler, flags, commit, version;
  unsigned cores = 0;
  std::string node{};  // name of the machine; empty: unknown
};

// The session of this process, with the present time. Its node is the environment variable FDEBENCH_NODE.
// Throws std::invalid_argument if that cannot be printed.
Session this_session();

// The contents of a results file: every examination, with the last of its times.
struct Results {
  std::vector<Session> sessions{};
  std::vector<Record> records{};
  std::vector<SceneDescription> scenes{};
  std::string warning{};  // of the reader, on lines that are left out
};

// Whether two sessions are of the same build, whose examinations give the same numbers on every machine.
bool same_build(const Session& a, const Session& b);

// Whether their machines are alike, so that their times can be compared.
bool same_machine(const Session& a, const Session& b);

}  // namespace fde::bench
