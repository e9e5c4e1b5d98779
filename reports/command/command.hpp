// SPDX-License-Identifier: MIT
#pragma once

#include <iosfwd>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/requests/failure.hpp"
#include "fdebench/benchmarks/scenes/registry.hpp"
#include "fdebench/reports/command/given.hpp"

namespace fde::bench {

// Results are worse than earlier results: exit code 1.
struct WorseResults : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Where a command writes: results to out, everything else to err.
struct Streams {
  std::ostream& out;
  std::ostream& err;
  int columns = 0;       // width of the terminal of err; 0: err is no terminal
  int out_columns = 0;   // the same of out
  bool colours = false;  // whether terminals show colours
  bool quiet = false;    // no progress and no notes on err
};

// Writes "fdebench: MESSAGE" to err, or "fdebench: warning: MESSAGE", the message as one printable line. On a
// terminal an error or a warning is coloured. A note is left out where --quiet is given.
enum class Message { error, warning, note };
void say(const Streams& streams, Message kind, std::string_view message);

// Says the text as a warning; nothing if it is empty.
void warn(const Streams& streams, std::string_view text);

// Runs the command `fdebench` within this process, with the arguments after the program's name. Returns the
// exit code: 0 done, 1 worse results, 2 bad input or output that cannot be written, 3 numerical failure; all
// but 0 with one line on err. `known`: the scenes that arguments may name besides equation files.
int run_fdebench(const std::vector<std::string>& arguments, const Streams& given,
                 const SceneRegistry& known = built_in_scenes());

// A subcommand: what it takes, and what it does with what it is given.
struct Command {
  SubcommandText text;
  void (*run)(const Given& given, const Streams& streams, const SceneRegistry& known);
};
Command solve_command(), choose_command(), run_command(), report_command(), study_command(), judge_command(),
    fit_command(), compare_command(), merge_command(), export_command(), plot_command(), scenes_command(),
    schemes_command(), exact_command(), mittag_leffler_command(), stability_command(), poles_command(),
    response_command(), geometry_command(), reference_command(), help_command(), completion_command();

// All subcommands, as the help lists them.
ProgramText program_text();

}  // namespace fde::bench
