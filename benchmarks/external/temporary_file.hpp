// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "fdebench/benchmarks/external/process_cleanup.hpp"

namespace fde::bench {

// A unique file in the folder of temporary files, removed by the destructor.
class TemporaryFile {
 public:
  // Throws std::system_error naming the file if it cannot be created.
  explicit TemporaryFile(std::string_view suffix);
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
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
