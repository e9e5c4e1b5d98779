// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/files/lines.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

namespace fde::bench {
namespace {

std::invalid_argument cannot_be_read(const std::string& file, const std::string& reason) {
  return std::invalid_argument(fmt::format("{}: cannot be read: {}", file, reason));
}

}  // namespace

void require_file(const std::filesystem::path& file) {
  std::error_code problem;
  const auto status = std::filesystem::status(file, problem);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw cannot_be_read(file.string(), "is not a file");
}

LineReader::LineReader(const std::filesystem::path& file, std::string name) : name_(std::move(name)) {
  require_file(file);
  stream_.open(file, std::ios::binary);
  if (!stream_) throw cannot_be_read(name_, std::generic_category().message(errno));
}

bool LineReader::fill() {
  constexpr std::size_t piece = std::size_t{1} << 16;
  buffer_.resize(piece);
  stream_.read(buffer_.data(), static_cast<std::streamsize>(piece));
  if (stream_.bad()) throw cannot_be_read(name_, std::generic_category().message(errno));
  buffer_.resize(static_cast<std::size_t>(stream_.gcount()));
  at_ = 0;
  return !buffer_.empty();
}

bool LineReader::next() {
  text_.clear();
  has_end_ = false;
  ++number_;
  while (!has_end_ && (at_ < buffer_.size() || fill())) {
    const auto rest = std::string_view(buffer_).substr(at_);
    const auto part = rest.substr(0, rest.find('\n'));
    has_end_ = part.size() < rest.size();
    text_ += part;
    at_ += part.size() + (has_end_ ? 1 : 0);
    if (text_.size() <= most_line_bytes) continue;
    throw std::invalid_argument(
        fmt::format("{}: line {} is longer than {} bytes", name_, number_, most_line_bytes));
  }
  end_ += text_.size() + (has_end_ ? 1 : 0);
  return has_end_ || !text_.empty();
}

}  // namespace fde::bench
