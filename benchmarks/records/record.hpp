#pragma once

#include <compare>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "measures/ending.hpp"
#include "records/setup.hpp"
#include "scenes/scene_settings.hpp"

namespace fde {

// What names a run of one build, or a trajectory that another program wrote: its scheme is that program's
// name, and nothing is known of its setup but the number of its times; of one that a sweep started the steps
// and the grid that it was asked for.
struct RunKey {
  SceneSettings scene{};
  std::string scheme{};
  Setup setup{};
  bool external = false;  // of another program

  auto operator<=>(const RunKey&) const = default;  // NOLINT(readability-implicit-bool-conversion)
};

// One number of one run: a row of tidy results.
struct Record {
  RunKey key{};
  int steps = 0;           // made
  double h = 0.0;          // their mean length
  std::string quantity{};  // a Measure's id, or "ending", the last row of each examination
  double value = 0.0;      // of an ending the time
  std::string unit{};
  std::optional<RunEnding> ending{};  // of an ending
  std::size_t session = 0;            // index into Results::sessions
  bool wall_clock = false;            // a time of a whole process, whose program says none
};

// Where and with what numbers were made.
struct Session {
  std::string date, machine, system, compiler, flags, commit, version;
  unsigned cores = 0;
};

// The session of this process, now.
Session this_session();

// All that a results file holds.
struct Results {
  std::vector<Session> sessions{};
  std::vector<Record> records{};
};

// Whether two sessions were of the same build on the same machine, so that their rows belong together.
bool same_build(const Session& a, const Session& b);

// Whether the row is a time of a run, made after its examination.
bool is_time(const Record& row);

}  // namespace fde
