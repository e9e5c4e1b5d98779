#pragma once

#include <cstddef>
#include <functional>
#include <iosfwd>
#include <stdexcept>
#include <string>
#include <vector>

#include "scenes/registry.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming)
class App;
}

namespace fde {

// A scheme or a reference that did not come to its end: exit code 3.
struct NumericalFailure : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Where a command writes: results to out, everything else to err.
struct Streams {
  std::ostream& out;
  std::ostream& err;
  bool terminal = false;  // err is one: progress may be shown
};

// The command `fdebench` without its process: arguments after the program's name. Returns the exit code: 0
// done, 2 bad input or output that cannot be written, 3 numerical failure; both with one line on err. known:
// the scenes that arguments may name.
int run_fdebench(const std::vector<std::string>& arguments, const Streams& streams,
                 const Scenes& known = scenes());

// Overwrites one line of err with what has been done, on a terminal only.
std::function<void(std::size_t done, std::size_t total, const std::string& what)> progress_line(
    const Streams& streams);

// Each file of list.def adds its subcommands to the application; scenes are named among those known.
#define FDE_COMMAND(file) void add_##file(CLI::App& app, const Streams& streams, const Scenes& known);
#include "command/list.def"
#undef FDE_COMMAND

}  // namespace fde
