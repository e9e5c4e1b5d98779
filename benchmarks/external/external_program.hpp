#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "records/record.hpp"
#include "references/watched_reference.hpp"
#include "scenes/variant.hpp"

namespace fde {

// Another program that solves scenes: what its runs are called, and the command of the shell that starts it.
// docs/external_solvers.md says what it is given and what it is to print.
struct ExternalProgram {
  std::string name, command;
};

// "NAME=COMMAND". Throws std::invalid_argument where it is no such thing, or NAME is no name of a program.
ExternalProgram parse_external(std::string_view text);

// Its run of a scene, without rows: named as in results, with no more of the setup than its steps and grid.
RunKey key_of(const ExternalProgram& program, const SceneSettings& scene, const Setup& setup);

// As of a scheme: runs it once within the budget and judges what it prints. What goes wrong with it is how
// the run ended. Throws std::system_error where the temporary files cannot be written.
std::vector<Record> examine(const SceneVariant& variant, const Scene& scene, WatchedReference& reference,
                            const ExternalProgram& program, const Setup& setup);

// Runs it again, at most `most` times and no more after so many seconds. The time rows: of its solves, where
// it says what they took, otherwise of the whole processes. Where it fails now the rows of an examination.
std::vector<Record> time_runs(const SceneVariant& variant, const Scene& scene, const ExternalProgram& program,
                              const Setup& setup, int most, double enough_seconds);

}  // namespace fde
