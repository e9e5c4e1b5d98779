// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "fdebench/benchmarks/files/lines.hpp"
#include "fdebench/benchmarks/records/record_text.hpp"

namespace fde::bench {

// Reads a results file line by line. The incomplete last line of a killed sweep is ignored. An invalid line
// is left out; where it is a session, all of that session is.
class ResultsReader {
 public:
  // Throws std::invalid_argument naming the file if it cannot be read.
  explicit ResultsReader(const std::filesystem::path& file) : file_(file), line_(file) {}

  // The next valid line, whose sessions are counted from 0; nullopt at the end. Throws std::invalid_argument
  // naming file and line if a session has another format, a line is too long, or the file is not a results
  // file: its first line is no session.
  std::optional<ResultsLine> next();

  // The text of the current line, without the line end.
  [[nodiscard]] const std::string& text() const { return line_.text(); }

  // The offset in bytes of the first byte of the current line.
  [[nodiscard]] std::uint64_t begin() const {
    return line_.end() - line_.text().size() - (line_.has_end() ? 1 : 0);
  }

  // The offset in bytes of the byte after the last line with a line end.
  [[nodiscard]] std::uint64_t complete() const { return complete_; }

  // The first line that is left out, with the file and the reason, and how many others are; empty if none is.
  [[nodiscard]] std::string warning() const;

 private:
  [[nodiscard]] bool is_torn() const;
  std::optional<ResultsLine> take();
  void leave_out(std::string_view reason);

  std::filesystem::path file_;
  LineReader line_;
  std::uint64_t complete_ = 0;
  std::size_t sessions_ = 0, left_out_ = 0;
  bool is_session_lost_ = false;
  std::string first_reason_{};
};

}  // namespace fde::bench
