#pragma once

#include <array>
#include <csignal>
#include <cstddef>
#include <string>

namespace fde {

// Signal handler guard: while the object exists, SIGINT, SIGTERM and SIGHUP first call remove_traces() (kill
// started programs, remove temporary files) and write `text` to standard error, then end the process as by
// default. Ignored signals stay ignored. Precondition: at most one object at a time.
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
