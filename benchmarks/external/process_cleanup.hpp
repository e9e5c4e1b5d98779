// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <csignal>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace fde::bench {

// Registers a temporary file or a process group for cleanup: while the object exists, a signal that ends this
// process (SIGKILL included) removes the file or kills the group. At most 256 of each at a time; further ones
// are not registered.
class RegisteredFile {
 public:
  explicit RegisteredFile(const std::string& path);
  RegisteredFile& operator=(RegisteredFile&&) = delete;
  ~RegisteredFile();

 private:
  std::size_t place_;
};
class RegisteredProcessGroup {
 public:
  explicit RegisteredProcessGroup(pid_t group);
  RegisteredProcessGroup& operator=(RegisteredProcessGroup&&) = delete;
  ~RegisteredProcessGroup();

 private:
  std::size_t place_;
};

// Guard for the time between the creation of a file or group and its registration: clean_up() waits
// while an object exists, and all signals are blocked in this thread.
class RegistrationGuard {
 public:
  RegistrationGuard();
  RegistrationGuard& operator=(RegistrationGuard&&) = delete;
  ~RegistrationGuard();

 private:
  sigset_t before_{};
};

// Kills all registered groups and removes all registered files. To be called when this process is about to
// end; async-signal-safe.
void clean_up();

// Blocks forever if clean_up() has been called: the end of a child that it killed must not be reported
// as a result.
void block_after_clean_up();

// A unique file in the folder of temporary files, removed by the destructor.
class TemporaryFile {
 public:
  // Throws std::system_error naming the file if it cannot be created.
  explicit TemporaryFile(std::string_view suffix);
  TemporaryFile& operator=(TemporaryFile&&) = delete;
  ~TemporaryFile();

  // Appends the text. Throws std::system_error naming the file if it cannot be written (disk full).
  void write(std::string_view text) const;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] int descriptor() const { return descriptor_; }

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
  std::optional<RegisteredFile> trace_{};
};

}  // namespace fde::bench
