// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/benchmarks/reference_data/reference_folder.hpp"
#include "support/testing.hpp"

namespace fde::bench {

// Tables of two small scenes: one with digits, one whose parameters are not the defaults.
inline std::vector<TableSpec> example_tables() {
  auto tables = planned_tables({{.factory = &scene_factory("power")},
                                {.factory = &scene_factory("relaxation"), .values = {{"gamma", 0.2}}}});
  std::erase_if(tables, [](const auto& table) { return !table.kind->of_scenes(); });
  return tables;
}

inline const FolderFiles& example_files() {
  static const auto files =
      compute_files(example_tables(), [](std::size_t, std::size_t, const std::string&) {});
  return files;
}

}  // namespace fde::bench
