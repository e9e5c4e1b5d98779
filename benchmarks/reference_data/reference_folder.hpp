// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "fdebench/benchmarks/reference_data/table_kind.hpp"

namespace fde::bench {

// One table of the reference data, before it is computed.
struct TableSpec {
  const TableKind* kind;
  SceneVariant of{.factory = nullptr};

  // Path in the folder without .csv or .json: "trajectories/pendulum,alpha=1.9".
  [[nodiscard]] std::string stem() const;
};

// All tables of functions and all tables of these scenes.
std::vector<TableSpec> planned_tables(const std::vector<SceneVariant>& scenes);

// Progress callback: `done` of `total` tables, `what` is the last one. Called by one thread at a time.
using TableProgress = std::function<void(std::size_t done, std::size_t total, const std::string& what)>;

// File contents by file name: a .csv and a .json per table, index.json, the files of the data package and
// SHA256SUMS. The same build gives the same bytes with any number of threads.
using FolderFiles = std::map<std::string, std::string>;
FolderFiles compute_files(const std::vector<TableSpec>& tables, const TableProgress& progress);

// Throws std::invalid_argument naming the folder if it is not a folder, contains a file that is not among the
// files of these tables, or cannot be created.
void require_replaceable(const std::filesystem::path& folder, const std::vector<TableSpec>& tables);

// Replaces the folder: writes all files to a sibling folder, renames it into place, and removes the old
// folder last. Throws std::invalid_argument naming the folder on failure; the old folder is then restored, or
// the message names its new path.
void replace_folder(const std::filesystem::path& folder, const FolderFiles& files);

}  // namespace fde::bench
