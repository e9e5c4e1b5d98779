#pragma once

#include <sys/types.h>

#include <csignal>
#include <cstddef>
#include <string>

namespace fde {

// Registers a temporary file or a process group for cleanup: while the object exists, a signal that ends this
// process (SIGKILL included) removes the file or kills the group. At most 256 of each at a time; further ones
// are not registered.
class FileTrace {
 public:
  explicit FileTrace(const std::string& path);
  FileTrace(const FileTrace&) = delete;
  FileTrace& operator=(const FileTrace&) = delete;
  ~FileTrace();

 private:
  std::size_t place_;
};
class GroupTrace {
 public:
  explicit GroupTrace(pid_t group);
  GroupTrace(const GroupTrace&) = delete;
  GroupTrace& operator=(const GroupTrace&) = delete;
  ~GroupTrace();

 private:
  std::size_t place_;
};

// Guard for the time between the creation of a file or group and its registration: remove_traces() waits
// while an object exists, and all signals are blocked in this thread.
class NotingTraces {
 public:
  NotingTraces();
  NotingTraces(const NotingTraces&) = delete;
  NotingTraces& operator=(const NotingTraces&) = delete;
  ~NotingTraces();

 private:
  sigset_t before_{};
};

// Kills all registered groups and removes all registered files. To be called when this process is about to
// end; async-signal-safe.
void remove_traces();

// Blocks forever if remove_traces() has been called: the end of a child that it killed must not be reported
// as a result.
void wait_if_ending();

}  // namespace fde
