#pragma once

#include <sys/types.h>

#include <csignal>
#include <cstddef>
#include <string>

namespace fde {

// What must not outlive this process: a file is removed and a process group killed, at the latest where a
// signal ends the process, SIGKILL as well. Beyond some hundreds at a time they are no longer noted.
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

// While it lives remove_traces waits: what this thread begins is noted before anything is removed. Signals
// reach other threads.
class NotingTraces {
 public:
  NotingTraces();
  NotingTraces(const NotingTraces&) = delete;
  NotingTraces& operator=(const NotingTraces&) = delete;
  ~NotingTraces();

 private:
  sigset_t before_{};
};

// Kills and removes all that there is, because this process is about to end. A signal handler may call it.
void remove_traces();

// Returns only where remove_traces has not been called: what it has killed has come to no end of its own.
void wait_if_ending();

}  // namespace fde
