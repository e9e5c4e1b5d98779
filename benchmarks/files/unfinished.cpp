// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/files/unfinished.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace fde::bench {
namespace {

namespace fs = std::filesystem;

fs::path temporary_name(const fs::path& path) {
  static std::atomic<unsigned> count = 0;
  return path.string() + fmt::format(".{}.{}.tmp", getpid(), count++);
}

// The process that owns a temporary name; nullopt: not a temporary name of this file.
std::optional<pid_t> writer_of(const std::string& unfinished, const std::string& name) {
  if (!unfinished.starts_with(name + ".") || !unfinished.ends_with(".tmp")) return std::nullopt;
  pid_t writer = 0;
  unsigned number = 0;
  const char* const end = unfinished.data() + unfinished.size();
  const auto pid = std::from_chars(unfinished.data() + name.size() + 1, end, writer);
  if (pid.ec != std::errc{} || writer <= 0 || *pid.ptr != '.') return std::nullopt;
  const auto count = std::from_chars(pid.ptr + 1, end, number);
  if (count.ec != std::errc{} || std::string_view(count.ptr, end) != ".tmp") return std::nullopt;
  return writer;
}

// Removes what killed processes left of this file or folder.
void remove_stale_temporaries(const fs::path& path) {
  const auto folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    const auto writer = writer_of(entry.path().filename().string(), path.filename().string());
    const bool is_gone = writer && kill(*writer, 0) != 0 && errno == ESRCH;
    if (is_gone) fs::remove_all(entry.path(), ignored);
  }
}

}  // namespace

fs::path unfinished_name(const fs::path& path) {
  remove_stale_temporaries(path);
  return temporary_name(path);
}

// Some file systems do not support RENAME_NOREPLACE; all support links, which do not replace a file.
void rename_to_new(const fs::path& unfinished, const fs::path& path) {
  if (renameat2(AT_FDCWD, unfinished.c_str(), AT_FDCWD, path.c_str(), RENAME_NOREPLACE) == 0) return;
  if ((errno == EINVAL || errno == ENOSYS) && link(unfinished.c_str(), path.c_str()) == 0) return;
  cannot_write(path, {errno, std::generic_category()});
}

void cannot_write(const fs::path& path, const std::error_code& reason) {
  throw std::invalid_argument(fmt::format("{}: cannot be written: {}", path.string(), reason.message()));
}

NewPath::NewPath(fs::path path) : path_(std::move(path)) {
  if (!path_.has_filename()) path_ = path_.parent_path();
  if (fs::exists(fs::symlink_status(path_)))
    throw std::invalid_argument(fmt::format("{}: exists, it must be a new file or folder", path_.string()));
  unfinished_ = unfinished_name(path_);
}

NewPath::~NewPath() {
  std::error_code ignored;
  fs::remove_all(unfinished_, ignored);
}

}  // namespace fde::bench
