// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/scenes/registry.hpp"
#include "fdebench/reports/command/program_text.hpp"

namespace fde::bench {

// The word with which a shell's script asks for candidates: fdebench __complete WORD...
inline constexpr std::string_view completion_request = "__complete";

// What a shell offers in place of the last of the words after the program's name, a line each: the word, a
// tab, and what it is. Candidates begin with the last word. A line that begins with a tab asks for files: the
// ending that they have, or "/" for folders, or nothing for all files.
std::string candidates(const ProgramText& program, std::vector<std::string> words,
                       const SceneRegistry& known);

// The script that a shell reads: of "bash", "zsh" or "fish".
std::string completion_script(const std::string& program, std::string_view shell);
const std::vector<std::string>& completion_shells();

}  // namespace fde::bench
