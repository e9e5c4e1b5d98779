// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

namespace fde::bench {

// Maximum length of a line in a results file or a trajectory.
inline constexpr std::size_t most_line_bytes = std::size_t{1} << 20;

// Reads a file line by line: memory is needed for the longest line only.
class LineReader {
 public:
  // Throws std::invalid_argument naming the file if it cannot be read or is a folder, a pipe or a device.
  // `name` is the name in messages.
  explicit LineReader(const std::filesystem::path& file) : LineReader(file, file.string()) {}
  LineReader(const std::filesystem::path& file, std::string name);

  // Reads the next line; false at the end of the file. Throws std::invalid_argument naming file and line if
  // it is longer than most_line_bytes.
  bool next();

  // The current line: its text without the line end, its number from 1, whether it has a line end, and the
  // offset in bytes of the byte after its end.
  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] bool has_end() const { return has_end_; }
  [[nodiscard]] std::uint64_t end() const { return end_; }

 private:
  bool fill();

  std::string name_;
  std::ifstream stream_;
  std::string buffer_{}, text_{};
  std::size_t at_ = 0;  // in the buffer
  int number_ = 0;
  bool has_end_ = false;
  std::uint64_t end_ = 0;
};

// Throws std::invalid_argument: "FILE: cannot be read: is not a file" if it is a folder, a pipe or a device.
// A file without access is reported when it is opened.
void require_file(const std::filesystem::path& file);

}  // namespace fde::bench
