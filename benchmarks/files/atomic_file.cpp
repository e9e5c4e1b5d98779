// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/files/atomic_file.hpp"

#include <cerrno>
#include <system_error>

#include "fdebench/benchmarks/files/unfinished.hpp"

namespace fde::bench {
namespace {

namespace fs = std::filesystem;

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
  if (fs::is_directory(there)) cannot_write(path, std::make_error_code(std::errc::is_a_directory));
  if (fs::exists(there) && !fs::is_regular_file(there)) return path;
  return unfinished_name(path);
}

}  // namespace

bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code none;
  return std::filesystem::equivalent(a, b, none);
}

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
  if (problem) cannot_write(path_, problem);
}

void AtomicFile::commit_new() {
  stream_.close();
  check();
  rename_to_new(temporary_, path_);
}

void AtomicFile::check() const {
  if (!stream_) cannot_write(path_, {errno, std::generic_category()});
}

}  // namespace fde::bench
