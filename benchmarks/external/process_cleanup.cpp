// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/external/process_cleanup.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <new>
#include <system_error>

namespace fde::bench {

namespace {

constexpr std::size_t most = 256, none = most;

// State of a slot: free, being written, registered for cleanup.
enum class State { free, claimed, registered };

struct File {
  std::atomic<State> state = State::free;
  std::array<char, PATH_MAX> path{};  // a copy: a signal handler may read it while the owner is destroyed
};
struct Group {
  std::atomic<State> state = State::free;
  std::atomic<pid_t> group = 0;
};
struct CleanupSlots {
  std::array<File, most> files;
  std::array<Group, most> groups;
};
std::atomic<bool> is_ending = false;
std::atomic<int> registrations_in_progress = 0;
std::atomic<CleanupSlots*> known = nullptr;  // set at the first registration
static_assert(std::atomic<State>::is_always_lock_free && std::atomic<pid_t>::is_always_lock_free);

void remove_all(const CleanupSlots& places) {
  for (const Group& of : places.groups) {
    if (of.state == State::registered) kill(-of.group, SIGKILL);
  }
  for (const File& of : places.files) {
    if (of.state == State::registered) unlink(of.path.data());
  }
}

// A child process that cleans up the registered files and groups, in shared memory, when this process has
// ended in whatever way: SIGKILL cannot be handled. It detects the end by reading a pipe whose other end only
// this process holds. If it cannot be started, there is no such cleanup. It calls async-signal-safe functions
// only, as is required after fork without exec.
class CleanupProcess {
 public:
  explicit CleanupProcess(const CleanupSlots& places) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) return;
    sigset_t all{}, before{};
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    child_ = fork();
    if (child_ == 0) watch(static_cast<unsigned>(ends[0]), places);
    pthread_sigmask(SIG_SETMASK, &before, nullptr);
    close(ends[0]);
    end_ = ends[1];
  }
  CleanupProcess& operator=(CleanupProcess&&) = delete;
  ~CleanupProcess() {
    if (end_ >= 0) close(end_);
    if (child_ > 0) waitpid(child_, nullptr, 0);
  }

 private:
  [[noreturn]] static void watch(unsigned pipe, const CleanupSlots& places) {
    setsid();
    if (pipe > 0) close_range(0, pipe - 1, 0);
    close_range(pipe + 1, ~0U, 0);
    char nothing = 0;
    while (read(static_cast<int>(pipe), &nothing, 1) < 0 && errno == EINTR) {
    }
    remove_all(places);
    _exit(0);
  }

  pid_t child_ = -1;
  int end_ = -1;
};

CleanupSlots& places() {
  static CleanupSlots& shared = []() -> CleanupSlots& {
    void* memory =
        mmap(nullptr, sizeof(CleanupSlots), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw std::system_error(errno, std::generic_category(), "shared memory");
    known = new (memory) CleanupSlots;
    return *known;
  }();
  static const CleanupProcess watcher(shared);
  return shared;
}

template <typename Of>
std::size_t claimed(Of& of) {
  for (std::size_t i = 0; i < of.size(); ++i) {
    State expected = State::free;
    if (of[i].state.compare_exchange_strong(expected, State::claimed)) return i;
  }
  return none;
}

}  // namespace

RegisteredFile::RegisteredFile(const std::string& path)
    : place_(path.size() < PATH_MAX ? claimed(places().files) : none) {
  if (place_ == none) return;
  auto& file = places().files[place_];
  *std::ranges::copy(path, file.path.begin()).out = '\0';
  file.state = State::registered;
}

RegisteredFile::~RegisteredFile() {
  if (place_ != none) places().files[place_].state = State::free;
}

RegisteredProcessGroup::RegisteredProcessGroup(pid_t group) : place_(claimed(places().groups)) {
  if (place_ == none) return;
  auto& noted = places().groups[place_];
  noted.group = group;
  noted.state = State::registered;
}

RegisteredProcessGroup::~RegisteredProcessGroup() {
  if (place_ != none) places().groups[place_].state = State::free;
}

RegistrationGuard::RegistrationGuard() {
  sigset_t all{};
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before_);
  ++registrations_in_progress;
}

// A blocked signal is delivered when the mask is restored.
RegistrationGuard::~RegistrationGuard() {
  --registrations_in_progress;
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

void clean_up() {
  constexpr int millisecond = 1;
  is_ending = true;
  while (registrations_in_progress > 0) poll(nullptr, 0, millisecond);
  if (const CleanupSlots* all = known) remove_all(*all);
}

void block_after_clean_up() {
  while (is_ending) pause();
}

TemporaryFile::TemporaryFile(std::string_view suffix) {
  std::error_code error;
  const auto folder = std::filesystem::temp_directory_path(error);
  if (error) throw std::system_error(error, "the folder of temporary files, $TMPDIR or /tmp");
  std::string name = (folder / "fdebench-XXXXXX").string();
  name += suffix;
  const RegistrationGuard guard;
  descriptor_ = mkostemps(name.data(), static_cast<int>(suffix.size()), O_CLOEXEC);
  if (descriptor_ < 0) throw std::system_error(errno, std::generic_category(), name + ": cannot be written");
  path_ = name;
  trace_.emplace(name);
}

TemporaryFile::~TemporaryFile() {
  close(descriptor_);
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

void TemporaryFile::write(std::string_view text) const {
  while (!text.empty()) {
    const auto count = ::write(descriptor_, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0)
      throw std::system_error(errno, std::generic_category(), path_.string() + ": cannot be written");
    text.remove_prefix(static_cast<std::size_t>(count));
  }
}

}  // namespace fde::bench
