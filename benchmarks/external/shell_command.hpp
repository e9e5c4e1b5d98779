#pragma once

#include <cstdint>
#include <string>

namespace fde {

// How a command of the shell ended, and the seconds of the clock on the wall that it took.
struct CommandEnd {
  enum class How { exited, killed, out_of_time, too_much_output };
  How how = How::exited;
  int code = 0;  // the exit code, or the signal that killed it
  double seconds = 0.0;
};

struct CommandLimits {
  double seconds;
  std::uint64_t bytes;  // of both outputs; they are looked at some times a second
};

// Runs `sh -c 'COMMAND ARGUMENT'`, the argument as its last word and unchanged, and waits for its end. It
// writes to these two files and reads nothing. What it started and what still runs then is killed, as is all
// of it beyond a limit, unless it has left its process group. The shell's exit codes above 128 are told as
// the signals that they stand for. Throws std::system_error where no process can be started.
CommandEnd run_command(const std::string& command, const std::string& argument, int out, int err,
                       const CommandLimits& limits);

}  // namespace fde
