#include "external/traces.hpp"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <climits>
#include <csignal>
#include <cstddef>

namespace fde {
namespace {

constexpr std::size_t most = 256, none = most;

// Of a place: free, about to be written, to be removed.
enum class State { free, claimed, noted };

struct File {
  std::atomic<State> state = State::free;
  std::array<char, PATH_MAX> path{};  // its own memory: a handler may read it while the owner ends
};
struct Group {
  std::atomic<State> state = State::free;
  std::atomic<pid_t> group = 0;
};
std::atomic<bool> is_ending = false;
std::atomic<int> noting = 0;
std::array<File, most> files;
std::array<Group, most> groups;
static_assert(std::atomic<State>::is_always_lock_free && std::atomic<pid_t>::is_always_lock_free);

template <typename Places>
std::size_t claimed(Places& places) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    State expected = State::free;
    if (places[i].state.compare_exchange_strong(expected, State::claimed)) return i;
  }
  return none;
}

}  // namespace

FileTrace::FileTrace(const std::string& path) : place_(path.size() < PATH_MAX ? claimed(files) : none) {
  if (place_ == none) return;
  auto& file = files[place_];
  *std::ranges::copy(path, file.path.begin()).out = '\0';
  file.state = State::noted;
}

FileTrace::~FileTrace() {
  if (place_ != none) files[place_].state = State::free;
}

GroupTrace::GroupTrace(pid_t group) : place_(claimed(groups)) {
  if (place_ == none) return;
  groups[place_].group = group;
  groups[place_].state = State::noted;
}

GroupTrace::~GroupTrace() {
  if (place_ != none) groups[place_].state = State::free;
}

NotingTraces::NotingTraces() {
  sigset_t all{};
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before_);
  ++noting;
}

// A signal that was held back arrives with the mask.
NotingTraces::~NotingTraces() {
  --noting;
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

void remove_traces() {
  constexpr int millisecond = 1;
  is_ending = true;
  while (noting > 0) poll(nullptr, 0, millisecond);
  for (const Group& of : groups) {
    if (of.state == State::noted) kill(-of.group, SIGKILL);
  }
  for (const File& of : files) {
    if (of.state == State::noted) unlink(of.path.data());
  }
}

void wait_if_ending() {
  while (is_ending) pause();
}

}  // namespace fde
