// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

namespace fde::bench {

// How a shell command ended, and its wall time in seconds.
struct CommandResult {
  enum class Status { exited, killed, out_of_time, too_much_output };
  Status status = Status::exited;
  int code = 0;  // exit code (exited) or signal number (killed)
  double seconds = 0.0;
};

struct CommandLimits {
  double seconds;
  std::uint64_t bytes;  // of both outputs together, checked every 20 ms
};

// Runs `sh -c 'COMMAND ARGUMENT'`, the argument unchanged as the last word, and waits for the end of the
// shell. `out` and `err` are file descriptors of regular files for its outputs; its input is /dev/null. At
// the end, or beyond a limit, every process left in its process group is killed. Exit codes of the shell from
// 129 to 192 are reported as the signals 1 to 64. Throws std::system_error if no process can be started.
CommandResult run_command(const std::string& command, const std::string& argument, int out, int err,
                          const CommandLimits& limits);

}  // namespace fde::bench
