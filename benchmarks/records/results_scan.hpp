// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "fdebench/benchmarks/records/record.hpp"

namespace fde::bench {

// Callbacks of scan_results, called in file order. end: the offset of the end of what is passed.
struct ScanCallbacks {
  std::function<void(const Session&, std::uint64_t end)> session;
  std::function<void(const SceneDescription&, std::uint64_t end)> scene;
  std::function<void(std::vector<Record> rows, std::uint64_t end)> rows;  // rows of one write
  std::function<void(std::uint64_t begin, std::uint64_t end)>
      left_out{};  // bytes that are not used; optional
};

// `valid`: the offset of the end of the last complete write. `warning`: the first line that is left out, with
// the file and the reason, and how many others are; empty if none is.
struct ScanSummary {
  std::uint64_t valid = 0;
  std::string warning{};
};

// Reads a results file line by line: JSON lines, each a session, a scene or a record. Incomplete last rows,
// left by a killed sweep, are ignored. An invalid line (record validation) is left out; where it is the last
// row of a measurement the measurement is, where it is a session all of that session. Record::session counts
// sessions from 0. Throws std::invalid_argument naming the file, and the line if there is one, if the file
// cannot be read, has rows of another format, or is not a results file: its first line is no session.
ScanSummary scan_results(const std::filesystem::path& file, const ScanCallbacks& callbacks);

// Throws std::invalid_argument with the reason if scan_results would leave out one of these lines, which
// follow a session.
void require_readable(const std::string& lines);

}  // namespace fde::bench
