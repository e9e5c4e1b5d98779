// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "fdebench/reports/command/program_text.hpp"

namespace fde::bench {

// Manual pages in troff with the man macros: of the program, with the topics as sections, and of a
// subcommand.
std::string man_page(const ProgramText& program);
std::string man_page(const ProgramText& program, const SubcommandText& subcommand);

}  // namespace fde::bench
