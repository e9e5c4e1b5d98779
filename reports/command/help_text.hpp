// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "fdebench/reports/command/program_text.hpp"
#include "fdebench/reports/command/topics.hpp"

namespace fde::bench {

struct Streams;

struct Style {
  int columns = 80;
  bool colours = false;
};
Style output_style(const Streams& streams);  // of standard output

// The subcommands in groups, and the topics.
std::string overview_text(const ProgramText& program, const Style& style);
std::string help_text(const ProgramText& program, const SubcommandText& subcommand, const Style& style);
std::string topic_text(const Topic& topic, const Style& style);

}  // namespace fde::bench
