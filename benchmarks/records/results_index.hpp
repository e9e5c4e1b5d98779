// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "fdebench/benchmarks/records/placed_run.hpp"

namespace fde::bench {

struct IndexedRun : PlacedRun {
  std::int64_t before = -1;  // index of the examination of this run before this one; -1: none
  bool is_latest = true;     // no later one is in the file
};

// Where a results file has its runs and its scenes, for a command that reads each only when it writes it.
struct ResultsIndex {
  std::vector<Session> sessions{};
  std::vector<IndexedRun> runs{};  // all examinations, in the order of the file
  // Of each scene that a run or a description has: the offsets of its descriptions.
  std::map<SceneSettings, std::vector<std::uint64_t>> scenes{};
  std::string warning{};  // of the reader, on lines that are left out
};

// Reads the file once. Later times belong to runs as in read_results. Throws as ResultsReader does.
ResultsIndex index_results(const std::filesystem::path& file);

// The description at this offset.
SceneDescription read_scene(const LinesByOffset& file, std::uint64_t offset);

}  // namespace fde::bench
