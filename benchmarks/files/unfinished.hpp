// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <system_error>

namespace fde::bench {

// A name beside `path`, unique to this process and call, for what is renamed when it is complete. What killed
// processes left under such names is removed.
std::filesystem::path unfinished_name(const std::filesystem::path& path);

// Renames what is complete, unless `path` exists: of several concurrent calls one succeeds. Throws as below.
void rename_to_new(const std::filesystem::path& unfinished, const std::filesystem::path& path);

// Throws std::invalid_argument: "PATH: cannot be written: REASON".
[[noreturn]] void cannot_write(const std::filesystem::path& path, const std::error_code& reason);

// A new file or folder, which appears when it is complete. Throws std::invalid_argument if it exists.
class NewPath {
 public:
  explicit NewPath(std::filesystem::path path);
  NewPath(const NewPath&) = delete;
  NewPath& operator=(const NewPath&) = delete;
  ~NewPath();  // removes what is incomplete

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] const std::filesystem::path& unfinished() const { return unfinished_; }
  void commit() const { rename_to_new(unfinished_, path_); }

 private:
  std::filesystem::path path_, unfinished_;
};

}  // namespace fde::bench
