// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>

namespace fde::bench {

// Reads single parts of a file, by their offsets in bytes, while it may be appended to. Several threads may
// use one object. Each function throws std::invalid_argument naming the file if it cannot be read.
class LinesByOffset {
 public:
  explicit LinesByOffset(const std::filesystem::path& file);
  LinesByOffset(const LinesByOffset&) = delete;
  LinesByOffset& operator=(const LinesByOffset&) = delete;
  ~LinesByOffset();

  // The line that begins there, without the line end.
  [[nodiscard]] std::string line(std::uint64_t begin) const;

  // At most `size` bytes from there on; fewer only where the file ends.
  [[nodiscard]] std::string bytes(std::uint64_t begin, std::size_t size) const;

 private:
  std::string name_;
  int descriptor_ = -1;
};

}  // namespace fde::bench
