// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "fdebench/benchmarks/measures/column_errors.hpp"
#include "fdebench/benchmarks/measures/run_outcome.hpp"
#include "fdebench/benchmarks/observers/drift.hpp"
#include "fdebench/benchmarks/records/run_settings.hpp"
#include "fdebench/benchmarks/records/scene_description.hpp"
#include "fdebench/benchmarks/scenes/parameters.hpp"

namespace fde::bench {

// Identifies a run of one build, or a trajectory of another program. In the latter case `scheme` is the name
// of the program, and of the setup only the number of times is known; if a sweep started the program, also
// the requested steps and grid.
struct RunKey {
  SceneSettings scene{};
  std::string scheme{};
  RunSettings setup{};
  bool external = false;  // of another program

  auto operator<=>(const RunKey&) const = default;  // NOLINT(readability-implicit-bool-conversion)
};

// What another program says of itself: the code that it runs, its version, and the language with its
// implementation. All may be empty.
struct ProgramFacts {
  std::string code{}, version{}, language{};

  bool operator==(const ProgramFacts&) const = default;
};

// A number of a run: one row of tidy results.
struct Record {
  RunKey key{};
  int steps = 0;           // taken
  double h = 0.0;          // mean step size
  std::string quantity{};  // id of a Measure, or "ending", the last row of each examination
  double value = 0.0;      // of an ending: the time
  std::string unit{};
  std::optional<RunOutcome> ending{};  // for quantity "ending" only
  ProgramFacts program{};              // for the ending of another program only
  ColumnErrors columns{};              // for the ending only
  Course course{};                     // the largest value up to t; empty: not recorded
  std::size_t session = 0;             // index into Results::sessions
  bool wall_clock = false;             // time of a whole process, for a program that reports none
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

// The contents of a results file.
struct Results {
  std::vector<Session> sessions{};
  std::vector<Record> records{};
  std::vector<SceneDescription> scenes{};
  std::string warning{};  // of the reader, on lines that are left out
};

// Whether two sessions are of the same build, whose examinations give the same rows on every machine.
bool same_build(const Session& a, const Session& b);

// Whether their machines are alike, so that their times can be compared.
bool same_machine(const Session& a, const Session& b);

// Whether the row was measured after the examination of a run: a time, or a condition of the timing.
bool is_time(const Record& row);

}  // namespace fde::bench
