// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "fdebench/benchmarks/reference_data/reference_folder.hpp"

namespace fde::bench {

// What makes a folder of tables a Frictionless Data Package (version 1 of the specification) that can be
// cited: the tables with their columns, keys, sizes and checksums, the licence, how to cite, a page to read.
inline constexpr std::array package_file_names{"CITATION.cff", "LICENSE", "README.md", "datapackage.json"};

// These files. Precondition: `files` contains the CSV of each table.
FolderFiles package_files(const std::vector<TableSpec>& tables, const FolderFiles& files);

// Name of a table in the package: letters, digits, '.', '_' and '-', "trajectories.power-p-0.7".
std::string resource_name(const TableSpec& table);

}  // namespace fde::bench
