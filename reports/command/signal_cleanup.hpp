// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <csignal>
#include <string>

namespace fde::bench {

// Signal handler guard: while the object exists, SIGINT, SIGTERM and SIGHUP first call clean_up() (kill
// started programs, remove temporary files) and write `text` to standard error, then end the process as by
// default. Ignored signals stay ignored. Precondition: at most one object at a time.
class SignalCleanup {
 public:
  explicit SignalCleanup(std::string text);
  SignalCleanup(const SignalCleanup&) = delete;
  SignalCleanup& operator=(const SignalCleanup&) = delete;
  ~SignalCleanup();

 private:
  static constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};
  std::string text_;
  std::array<struct sigaction, signals.size()> before_{};
};

}  // namespace fde::bench
