#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "reference_data/table_kind.hpp"

namespace fde {

// One table of the reference data, before it is made.
struct PlannedTable {
  const TableKind* kind;
  SceneVariant of{.maker = nullptr};

  // "trajectories/pendulum,alpha=1.9": where it lies, without .csv or .json.
  [[nodiscard]] std::string stem() const;
};

// The tables of functions, and those of these scenes.
std::vector<PlannedTable> planned_tables(const std::vector<SceneVariant>& scenes);

// Hears (done, total, what was done), from one thread at a time.
using TellProgress = std::function<void(std::size_t done, std::size_t total, const std::string& what)>;

// Texts by file name: of each table the .csv and the .json, then index.json and SHA256SUMS. The same bytes
// from the same build, on any number of threads.
using FolderFiles = std::map<std::string, std::string>;
FolderFiles make_files(const std::vector<PlannedTable>& tables, const TellProgress& tell);

// Throws std::invalid_argument naming the folder where it is something else than a folder, holds files that
// the tables would not replace, or cannot be made.
void require_replaceable(const std::filesystem::path& folder, const std::vector<PlannedTable>& tables);

// Writes the files beside the folder and puts them in its place when all are complete; what was there is
// removed last. Throws std::invalid_argument naming the folder where that fails; then what was there is there
// again and nothing else, or else the message names where it is.
void replace_folder(const std::filesystem::path& folder, const FolderFiles& files);

}  // namespace fde
