#pragma once

#include <array>
#include <csignal>
#include <cstddef>
#include <string>

namespace fde {

// While it lives, a signal that asks the process to end (SIGINT, SIGTERM, SIGHUP) first kills the programs
// that were started, writes this text on standard error and then ends it as it would without. Signals that
// are ignored stay so. One at a time.
class LastWords {
 public:
  explicit LastWords(std::string text);
  LastWords(const LastWords&) = delete;
  LastWords& operator=(const LastWords&) = delete;
  ~LastWords();

 private:
  static constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};
  std::string text_;
  std::array<struct sigaction, signals.size()> before_{};
};

}  // namespace fde
