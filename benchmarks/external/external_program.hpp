// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include "fdebench/benchmarks/scenes/variant.hpp"

namespace fde::bench {

struct Record;
struct RunKey;
struct RunSettings;
class MemoizedReference;

// An external solver: the name of its runs, and the shell command that starts it. docs/external_solvers.md
// specifies its input and output.
struct ExternalProgram {
  std::string name, command;
};

// Parses "NAME=COMMAND". Throws std::invalid_argument if the text has another form or NAME is not allowed.
ExternalProgram parse_external(std::string_view text);

// The key of the program's run of a scene in results; of the settings it contains the number of steps and the
// grading only.
RunKey key_of(const ExternalProgram& program, const SceneSettings& scene, const RunSettings& settings);

// Runs the program once within the budget and measures its printed trajectory, like examine() of a scheme. A
// failure of the program is the status of the run. Throws std::system_error if the temporary files cannot be
// written. Precondition: settings.resolution is a number of steps.
Record examine(const SceneVariant& variant, const Scene& scene, MemoizedReference& reference,
               const ExternalProgram& program, const RunSettings& settings);

// Repeats an examined run up to `most` times, until `enough_seconds` have passed, and adds its times: of the
// solves if the program prints their seconds every time, otherwise of the whole processes. If a repeat fails,
// so has the run.
void time_runs(Record& examined, const SceneVariant& variant, const Scene& scene,
               const ExternalProgram& program, const RunSettings& settings, int most, double enough_seconds);

}  // namespace fde::bench
