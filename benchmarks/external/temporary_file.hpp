#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "external/traces.hpp"

namespace fde {

// A file that nobody else has, among the temporary ones of the system; it goes with this object.
class TemporaryFile {
 public:
  // Throws std::system_error naming it where it cannot be made.
  explicit TemporaryFile(std::string_view suffix);
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile();

  // Throws std::system_error naming it where the disk is full.
  void write(std::string_view text) const;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] int descriptor() const { return descriptor_; }

 private:
  std::filesystem::path path_;
  int descriptor_ = -1;
  std::optional<FileTrace> trace_{};
};

}  // namespace fde
