// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

#include "fdebench/benchmarks/records/record.hpp"

namespace fde::bench {

// Callbacks of scan_results, called in file order. end: the offset of the end of what is passed.
struct ScanCallbacks {
  std::function<void(const Session&, std::uint64_t end)> session;
  std::function<void(const SceneDescription&, std::uint64_t end)> scene;
  std::function<void(std::vector<Record> rows, std::uint64_t end)> rows;  // rows of one write
};

// Reads a results file line by line: JSON lines, each a session, a scene or a record. Incomplete last rows,
// left by a killed sweep, are ignored. Returns the offset of the end of the last complete write.
// Record::session counts sessions from 0. Throws std::invalid_argument naming the file, and the line if there
// is one, if the file cannot be read, has rows of another format, has an invalid line (record validation), or
// is not a results file.
std::uint64_t scan_results(const std::filesystem::path& file, const ScanCallbacks& callbacks);

}  // namespace fde::bench
