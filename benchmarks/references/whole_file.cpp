#include "references/whole_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace fde {
namespace {

namespace fs = std::filesystem;

fs::path unfinished_name(const fs::path& path) {
  static std::atomic<unsigned> count = 0;
  return path.string() + fmt::format(".{}.{}.tmp", getpid(), count++);
}

[[noreturn]] void reject(const fs::path& path, const std::error_code& reason) {
  throw std::invalid_argument(fmt::format("{}: cannot be written: {}", path.string(), reason.message()));
}

}  // namespace

WholeFile::WholeFile(fs::path path)
    : path_(std::move(path)), unfinished_(unfinished_name(path_)), stream_(unfinished_, std::ios::binary) {
  check();
}

WholeFile::~WholeFile() {
  std::error_code ignored;
  fs::remove(unfinished_, ignored);
}

void WholeFile::write(std::string_view text) {
  stream_.write(text.data(), static_cast<std::streamsize>(text.size()));
  check();
}

void WholeFile::finish() {
  stream_.close();
  check();
  std::error_code problem;
  fs::rename(unfinished_, path_, problem);
  if (problem) reject(path_, problem);
}

void WholeFile::check() const {
  if (!stream_) reject(path_, {errno, std::generic_category()});
}

}  // namespace fde
