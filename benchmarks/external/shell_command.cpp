// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/external/shell_command.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <optional>
#include <system_error>

#include "fdebench/benchmarks/external/process_cleanup.hpp"

namespace fde::bench {
namespace {

using Clock = std::chrono::steady_clock;

void require(int error, const char* what) {
  if (error != 0) throw std::system_error(error, std::generic_category(), what);
}

// A pipe, close-on-exec: a child process inherits only an end that is duplicated explicitly.
class Pipe {
 public:
  Pipe() { require(pipe2(ends_.data(), O_CLOEXEC) == 0 ? 0 : errno, "pipe"); }
  Pipe& operator=(Pipe&&) = delete;
  ~Pipe() {
    for (const int end : ends_) close(end);
  }

  [[nodiscard]] int reading() const { return ends_[0]; }
  [[nodiscard]] int writing() const { return ends_[1]; }

 private:
  std::array<int, 2> ends_{};
};

// Attributes of the child: its own process group, standard input from release_, no signal blocked.
class SpawnSettings {
 public:
  SpawnSettings(int out, int err) {
    require(posix_spawn_file_actions_init(&files_), "sh");
    require(posix_spawnattr_init(&attributes_), "sh");
    require(posix_spawn_file_actions_adddup2(&files_, release_.reading(), STDIN_FILENO), "sh");
    require(posix_spawn_file_actions_adddup2(&files_, out, STDOUT_FILENO), "sh");
    require(posix_spawn_file_actions_adddup2(&files_, err, STDERR_FILENO), "sh");
    sigset_t nothing{};
    sigemptyset(&nothing);
    require(posix_spawnattr_setsigmask(&attributes_, &nothing), "sh");
    require(posix_spawnattr_setpgroup(&attributes_, 0), "sh");
    require(posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK), "sh");
  }
  SpawnSettings& operator=(SpawnSettings&&) = delete;
  ~SpawnSettings() {
    posix_spawn_file_actions_destroy(&files_);
    posix_spawnattr_destroy(&attributes_);
  }

  // The shell waits for release() before it starts the command, and exits if this process ends before that.
  [[nodiscard]] pid_t start(std::string command, std::string argument) const {
    command = "read -r _ || exit; exec </dev/null; " + command + " \"$@\"";
    std::string shell = "sh", option = "-c", name = "sh";
    const std::array<char*, 6> words{shell.data(), option.data(),   command.data(),
                                     name.data(),  argument.data(), nullptr};
    pid_t child = 0;
    require(posix_spawn(&child, "/bin/sh", &files_, &attributes_, words.data(), environ), "/bin/sh");
    return child;
  }

  void release() const { require(write(release_.writing(), "\n", 1) == 1 ? 0 : errno, "sh"); }

 private:
  Pipe release_{};
  posix_spawn_file_actions_t files_{};
  posix_spawnattr_t attributes_{};
};

std::uint64_t bytes_in(int file) {
  struct stat found {};
  return fstat(file, &found) == 0 ? static_cast<std::uint64_t>(found.st_size) : 0;
}

// A file descriptor that becomes readable when the process has ended. (Debian 12 declares no pidfd_open in
// C++.)
int opened(pid_t child) { return static_cast<int>(syscall(SYS_pidfd_open, child, 0)); }

// A child process. The destructor kills its process group and waits for it.
class Child {
 public:
  Child(const SpawnSettings& settings, const std::string& command, const std::string& argument) {
    {
      const RegistrationGuard guard;
      child_ = settings.start(command, argument);
      trace_.emplace(child_);
      settings.release();
    }
    descriptor_ = opened(child_);
    if (descriptor_ >= 0) return;
    const int error = errno;
    end();
    require(error, "pidfd_open");
  }
  Child& operator=(Child&&) = delete;
  ~Child() {
    if (!ended_) end();
    if (descriptor_ >= 0) close(descriptor_);
  }

  // Waits up to this many milliseconds; returns whether the child has ended.
  [[nodiscard]] bool ends_within(int milliseconds) const {
    struct pollfd watched {
      .fd = descriptor_, .events = POLLIN, .revents = 0
    };
    return poll(&watched, 1, milliseconds) > 0;
  }

  // Kills what is left of the group, then waits for the child: until then its id cannot be reused.
  int end() {
    kill(-child_, SIGKILL);
    trace_.reset();
    int status = 0;
    while (waitpid(child_, &status, 0) < 0 && errno == EINTR) {
    }
    ended_ = true;
    block_after_clean_up();
    return status;
  }

 private:
  pid_t child_ = 0;
  std::optional<RegisteredProcessGroup> trace_{};
  int descriptor_ = -1;
  bool ended_ = false;
};

// From the wait status of the shell, which reports a signal that killed its command as exit code 128 +
// signal.
CommandResult end_of(int status, double seconds) {
  constexpr int signal_code = 128, last_signal = 64;
  if (WIFSIGNALED(status)) return {CommandResult::Status::killed, WTERMSIG(status), seconds};
  const int code = WEXITSTATUS(status);
  if (code > signal_code && code <= signal_code + last_signal)
    return {CommandResult::Status::killed, code - signal_code, seconds};
  return {CommandResult::Status::exited, code, seconds};
}

}  // namespace

CommandResult run_command(const std::string& command, const std::string& argument, int out, int err,
                          const CommandLimits& limits) {
  constexpr double look = 0.02;  // seconds between checks of the output sizes
  const SpawnSettings settings(out, err);
  const auto start = Clock::now();
  const auto elapsed = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  Child child(settings, command, argument);
  while (true) {
    const double left = limits.seconds - elapsed();
    const auto milliseconds = static_cast<int>(std::ceil(1e3 * std::clamp(left, 0.0, look)));
    const bool is_finished = child.ends_within(milliseconds);
    const double seconds = elapsed();
    if (bytes_in(out) + bytes_in(err) > limits.bytes) {
      child.end();
      return {CommandResult::Status::too_much_output, 0, seconds};
    }
    if (is_finished) return end_of(child.end(), seconds);
    if (seconds < limits.seconds) continue;
    child.end();
    return {CommandResult::Status::out_of_time, 0, seconds};
  }
}

}  // namespace fde::bench
