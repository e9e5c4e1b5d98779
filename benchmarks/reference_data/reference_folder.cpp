// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/reference_data/reference_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <mutex>
#include <set>
#include <stdexcept>
#include <system_error>
#include <thread>

#include "fdebench/benchmarks/reference_data/data_package.hpp"
#include "fdebench/benchmarks/reference_data/description.hpp"
#include "fdebench/benchmarks/references/checksum.hpp"
#include "fdebench/benchmarks/sweep/in_parallel.hpp"

namespace fde::bench {
namespace {

namespace fs = std::filesystem;

constexpr auto index_name = "index.json";
constexpr auto checksums_name = "SHA256SUMS";

[[noreturn]] void reject(const fs::path& folder, const std::string& reason) {
  throw std::invalid_argument(fmt::format("{}: cannot be written: {}", folder.string(), reason));
}

// The canonical path without a trailing slash; symbolic links are followed.
fs::path normal(const fs::path& folder) {
  const fs::path path = fs::weakly_canonical(fs::absolute(folder));
  return path.has_filename() ? path : path.parent_path();
}

std::set<std::string> names_of(const std::vector<TableSpec>& tables) {
  std::set<std::string> names{index_name, checksums_name};
  names.insert(package_file_names.begin(), package_file_names.end());
  for (const auto& table : tables) names.insert({table.stem() + ".csv", table.stem() + ".json"});
  return names;
}

// The nearest ancestor that exists.
fs::path existing_parent(fs::path path) {
  do path = path.parent_path();
  while (!fs::exists(path) && path.has_relative_path());
  return path;
}

void write(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  if (!out) throw std::system_error(errno, std::generic_category());
}

fs::path beside(const fs::path& target, const char* what) {
  return target.string() + fmt::format(".{}.{}", getpid(), what);
}

// Renames `target` to `old` and `partial` to `target`; if the second fails, tries to rename `old` back.
void put_in_place(const fs::path& partial, const fs::path& target, const fs::path& old) {
  const bool replaced = fs::exists(target);
  if (replaced) fs::rename(target, old);
  try {
    fs::rename(partial, target);
  } catch (const std::system_error&) {
    std::error_code ignored;  // on failure `old` remains, and replace_folder reports it
    if (replaced) fs::rename(old, target, ignored);
    throw;
  }
}

// Blocks SIGINT, SIGTERM and SIGHUP in this thread until destruction.
class BlockedSignals {
 public:
  BlockedSignals() {
    sigset_t held;
    sigemptyset(&held);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&held, signal);
    pthread_sigmask(SIG_BLOCK, &held, &before_);
  }
  ~BlockedSignals() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  BlockedSignals& operator=(BlockedSignals&&) = delete;

 private:
  sigset_t before_{};
};

}  // namespace

std::string TableSpec::stem() const {
  if (!kind->of_scenes()) return std::string(kind->id);
  std::string name = of.label();
  std::ranges::replace(name, ':', ',');  // ':' is not allowed in file names on all systems
  return fmt::format("{}/{}", kind->folder, name);
}

std::vector<TableSpec> planned_tables(const std::vector<SceneVariant>& scenes) {
  std::vector<TableSpec> tables;
  for (const auto& kind : table_kinds()) {
    if (!kind.of_scenes()) tables.push_back({.kind = &kind});
    for (const auto& scene : scenes) {
      if (!kind.of_scenes() || (kind.has_table != nullptr && !kind.has_table(scene))) continue;
      tables.push_back({.kind = &kind, .of = scene});
    }
  }
  return tables;
}

FolderFiles compute_files(const std::vector<TableSpec>& tables, const TableProgress& progress) {
  std::vector<ComputedTable> made(tables.size());
  std::mutex mutex;
  std::size_t done = 0;
  in_parallel(tables.size(), std::thread::hardware_concurrency(), [&](std::size_t i) {
    made[i] = tables[i].kind->make(tables[i].of);
    const std::scoped_lock lock(mutex);
    progress(++done, tables.size(), tables[i].stem());
  });
  FolderFiles files;
  std::vector<IndexEntry> index;
  for (std::size_t i = 0; i < tables.size(); ++i) {
    const std::string stem = tables[i].stem(), csv = to_csv(made[i].table);
    index.push_back({stem + ".csv", stem + ".json", sha256(csv), made[i].table.rows.size()});
    files[stem + ".csv"] = csv;
    files[stem + ".json"] = write_description(*tables[i].kind, tables[i].of, made[i], index.back().checksum);
  }
  files[index_name] = write_index(index);
  files.merge(package_files(tables, files));
  Checksums checksums;
  for (const auto& [name, text] : files) checksums[name] = sha256(text);
  files[checksums_name] = write_checksums(checksums);
  return files;
}

void require_replaceable(const fs::path& folder, const std::vector<TableSpec>& tables) {
  const fs::path target = normal(folder);
  std::error_code problem;
  const auto status = fs::status(target, problem);
  if (fs::exists(status) && !fs::is_directory(status)) reject(folder, "is not a folder");
  const fs::path parent = existing_parent(target);
  if (!fs::is_directory(parent)) reject(folder, fmt::format("{} is not a folder", parent.string()));
  if (faccessat(AT_FDCWD, parent.c_str(), W_OK, AT_EACCESS) != 0)
    reject(folder, std::generic_category().message(errno));
  if (!fs::exists(status)) return;
  const auto ours = names_of(tables);
  for (const auto& entry : fs::recursive_directory_iterator(target, problem)) {
    const auto name = entry.path().lexically_relative(target).generic_string();
    if (entry.is_directory() || ours.contains(name)) continue;
    reject(folder,
           fmt::format("holds {}, which is not of the reference data; name a new or an empty folder", name));
  }
  if (problem) reject(folder, problem.message());
}

void replace_folder(const fs::path& folder, const FolderFiles& files) {
  const fs::path target = normal(folder), partial = beside(target, "partial"), old = beside(target, "old");
  const BlockedSignals held;
  try {
    for (const auto& [name, text] : files) write(partial / name, text);
    put_in_place(partial, target, old);
  } catch (const std::system_error& error) {
    std::error_code ignored;
    fs::remove_all(partial, ignored);
    const bool kept_aside = fs::exists(old) && !fs::exists(target);
    reject(folder, error.code().message() + (kept_aside ? "; what was there is now " + old.string() : ""));
  }
  std::error_code problem;
  fs::remove_all(old, problem);
  if (problem) {
    throw std::invalid_argument(
        fmt::format("{}: is written, but {} with what was there cannot be removed: {}", folder.string(),
                    old.string(), problem.message()));
  }
}

}  // namespace fde::bench
