// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "fdebench/reference/nonlinear/panel_table.hpp"

namespace fde::bench {

// A computed reference solution, and the processor seconds that it took.
struct TimedTable {
  reference::PanelTable panels;
  double seconds = 0.0;
};

// Reference solutions on disk, each with a key that names its problem. A file is a SHA-256 followed by CBOR;
// a file that is damaged, truncated or of another key is ignored. Files are replaced atomically, so processes
// may share a folder.
class ReferenceCache {
 public:
  // Without a folder nothing is stored.
  explicit ReferenceCache(std::optional<std::filesystem::path> folder) : folder_(std::move(folder)) {}

  // The table stored under the key for this problem, bit for bit; nullopt if there is none.
  [[nodiscard]] std::optional<TimedTable> load(const std::string& key, const Problem& problem) const;

  // Stores nothing, without an error, if the folder cannot be written or is in a $HOME that does not exist: a
  // cache is optional.
  void store(const std::string& key, const TimedTable& table) const;

  // Precondition: there is a folder.
  [[nodiscard]] std::filesystem::path file_of(const std::string& key) const;

 private:
  std::optional<std::filesystem::path> folder_;
};

// $FDEBENCH_CACHE (empty: nullopt), else $XDG_CACHE_HOME/fdebench, else $HOME/.cache/fdebench, else nullopt.
std::optional<std::filesystem::path> cache_folder();

// The name with everything that determines its reference: the version of the methods, the end, orders and
// initial values, and f at some points, so that a changed equation has another key.
std::string reference_key(const std::string& name, const Problem& problem);

// The reference of a problem without a closed form: two_sided_reference for a two-sided problem, else
// reference_solution.
reference::Reference computed_reference(const Problem& problem);

// The same, with a cache: solved once for each key.
reference::Reference cached_reference(const std::string& name, const Problem& problem,
                                      const ReferenceCache& cache);

}  // namespace fde::bench
