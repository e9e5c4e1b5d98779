#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

namespace fde {

// No line of a results file or of a trajectory is longer.
inline constexpr std::size_t most_line_bytes = std::size_t{1} << 20;

// The lines of a file one after the other: a file of any size takes the memory of its longest line.
class LineReader {
 public:
  // Throws std::invalid_argument naming the file where it cannot be read. A folder, a pipe and a device are
  // no files. Errors call it `name`.
  explicit LineReader(const std::filesystem::path& file) : LineReader(file, file.string()) {}
  LineReader(const std::filesystem::path& file, std::string name);

  // Goes to the next line; false: there is none. Throws std::invalid_argument naming file and line where that
  // is longer than most_line_bytes.
  bool next();

  // Of the line at hand: its text without its end, its number from 1 on, whether it has an end, and the bytes
  // of the file up to its beginning and up to behind its end.
  [[nodiscard]] const std::string& text() const { return text_; }
  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] bool has_end() const { return has_end_; }
  [[nodiscard]] std::uint64_t begin() const { return begin_; }
  [[nodiscard]] std::uint64_t end() const { return end_; }

  // The next line is the one that begins behind so many bytes. Lines count from 1 again.
  void go_to(std::uint64_t bytes);

 private:
  bool fill();

  std::string name_;
  std::ifstream stream_;
  std::string buffer_{}, text_{};
  std::size_t at_ = 0;  // in the buffer
  int number_ = 0;
  bool has_end_ = false;
  std::uint64_t begin_ = 0, end_ = 0;
};

// Throws std::invalid_argument: "FILE: cannot be read: is not a file" where it is a folder, a pipe or a
// device. What cannot be looked at says so when it is opened.
void require_file(const std::filesystem::path& file);

}  // namespace fde
