// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/files/lines_by_offset.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <stdexcept>
#include <system_error>

#include "fdebench/benchmarks/files/lines.hpp"

namespace fde::bench {
namespace {

std::invalid_argument cannot_be_read(const std::string& file) {
  return std::invalid_argument(
      fmt::format("{}: cannot be read: {}", file, std::generic_category().message(errno)));
}

}  // namespace

LinesByOffset::LinesByOffset(const std::filesystem::path& file) : name_(file.string()) {
  require_file(file);
  descriptor_ = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor_ < 0) throw cannot_be_read(name_);
}

LinesByOffset::~LinesByOffset() { close(descriptor_); }

std::string LinesByOffset::bytes(std::uint64_t begin, std::size_t size) const {
  std::string text(size, '\0');
  std::size_t read = 0;
  while (read < size) {
    const auto count = pread(descriptor_, text.data() + read, size - read, static_cast<off_t>(begin + read));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw cannot_be_read(name_);
    if (count == 0) break;
    read += static_cast<std::size_t>(count);
  }
  text.resize(read);
  return text;
}

std::string LinesByOffset::line(std::uint64_t begin) const {
  constexpr std::size_t piece = 2048;  // most lines of results are shorter
  std::string text;
  while (true) {
    const std::string next = bytes(begin + text.size(), piece);
    const auto end = next.find('\n');
    text.append(next, 0, end);
    if (end != std::string::npos || next.size() < piece) return text;
  }
}

}  // namespace fde::bench
