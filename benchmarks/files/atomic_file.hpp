// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <string_view>

namespace fde::bench {

// Whether both names are of one file that exists, whatever they are written as: links, ./, ...
bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b);

// Writes a file atomically: under a temporary name, unique to this process and object, which is renamed at
// the end. An existing file is replaced and its permissions are kept. Of a symbolic link the target is
// replaced. Temporary files of killed processes for the same file are removed first. A pipe or a device is
// written directly. Throws std::invalid_argument naming the path and why it cannot be written.
class AtomicFile {
 public:
  explicit AtomicFile(const std::filesystem::path& path);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  ~AtomicFile();  // removes an unfinished file

  void write(std::string_view text);
  void commit();
  void commit_new();  // also throws if the path exists by now: of several concurrent calls one succeeds

 private:
  void check() const;
  [[nodiscard]] bool writes_directly() const { return temporary_ == path_; }

  std::filesystem::path path_, temporary_;
  std::ofstream stream_;
};

}  // namespace fde::bench
