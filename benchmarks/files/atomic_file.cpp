// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/files/atomic_file.hpp"

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
#include <system_error>

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

[[noreturn]] void reject(const fs::path& path, const std::error_code& reason) {
  throw std::invalid_argument(fmt::format("{}: cannot be written: {}", path.string(), reason.message()));
}

// Removes the temporary files that killed processes left for this file.
void remove_stale_temporaries(const fs::path& path) {
  const auto folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    const auto writer = writer_of(entry.path().filename().string(), path.filename().string());
    const bool is_gone = writer && kill(*writer, 0) != 0 && errno == ESRCH;
    if (is_gone) fs::remove(entry.path(), ignored);
  }
}

// The target if the path is a symbolic link to an existing file.
fs::path resolve_symlink(const fs::path& path) {
  std::error_code missing;
  if (!fs::is_symlink(path, missing)) return path;
  const auto target = fs::canonical(path, missing);
  return missing ? path : target;
}

// The temporary name, after removing old temporary files; the path itself for a pipe or a device.
fs::path unfinished_of(const fs::path& path) {
  std::error_code ignored;
  const auto there = fs::status(path, ignored);
  if (fs::is_directory(there)) reject(path, std::make_error_code(std::errc::is_a_directory));
  if (fs::exists(there) && !fs::is_regular_file(there)) return path;
  remove_stale_temporaries(path);
  return temporary_name(path);
}

}  // namespace

AtomicFile::AtomicFile(const fs::path& path)
    : path_(resolve_symlink(path)), temporary_(unfinished_of(path_)), stream_(temporary_, std::ios::binary) {
  check();
}

AtomicFile::~AtomicFile() {
  if (writes_directly()) return;
  std::error_code ignored;
  fs::remove(temporary_, ignored);
}

void AtomicFile::write(std::string_view text) {
  stream_.write(text.data(), static_cast<std::streamsize>(text.size()));
  check();
}

void AtomicFile::commit() {
  stream_.close();
  check();
  if (writes_directly()) return;
  std::error_code missing, problem;
  if (const auto old = fs::status(path_, missing); fs::exists(old))
    fs::permissions(temporary_, old.permissions(), problem);
  if (!problem) fs::rename(temporary_, path_, problem);
  if (problem) reject(path_, problem);
}

// Some file systems do not support RENAME_NOREPLACE; all support links, which do not replace a file.
void AtomicFile::commit_new() {
  stream_.close();
  check();
  if (renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, path_.c_str(), RENAME_NOREPLACE) == 0) return;
  if ((errno == EINVAL || errno == ENOSYS) && link(temporary_.c_str(), path_.c_str()) == 0) return;
  reject(path_, {errno, std::generic_category()});
}

void AtomicFile::check() const {
  if (!stream_) reject(path_, {errno, std::generic_category()});
}

}  // namespace fde::bench
