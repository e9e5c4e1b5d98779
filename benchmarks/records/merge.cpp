// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/records/merge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/files/atomic_file.hpp"
#include "fdebench/benchmarks/records/lines.hpp"
#include "fdebench/benchmarks/records/record_text.hpp"
#include "fdebench/benchmarks/records/results_scan.hpp"
#include "fdebench/benchmarks/references/checksum.hpp"

namespace fde::bench {
namespace {

namespace fs = std::filesystem;

// A range of bytes with scenes and rows of a session, and the ranges within it that are left out.
struct ByteRange {
  fs::path file;
  std::uint64_t begin = 0, end = 0;  // bytes
  std::size_t rows = 0;
  std::vector<std::pair<std::uint64_t, std::uint64_t>> left_out{};

  [[nodiscard]] bool leaves_out(std::uint64_t at) const {
    return std::ranges::any_of(left_out,
                               [&](const auto& part) { return part.first <= at && at < part.second; });
  }
};

// The line of a session and all ranges with its scenes and rows.
struct SessionRanges {
  std::string line;
  std::vector<ByteRange> places{};
};

// Returns the warning of the scan.
std::string find_sessions(const fs::path& file, std::vector<SessionRanges>& all) {
  ByteRange* place = nullptr;
  return scan_results(file,
                      {.session =
                           [&](const Session& session, std::uint64_t end) {
                             const std::string line = line_of(session);
                             auto found = std::ranges::find(all, line, &SessionRanges::line);
                             if (found == all.end()) found = all.insert(all.end(), {.line = line});
                             place = &found->places.emplace_back(ByteRange{file, end, end});
                           },
                       .scene = [&](const auto&, std::uint64_t end) { place->end = end; },
                       .rows =
                           [&](const auto& rows, std::uint64_t end) {
                             place->end = end;
                             place->rows += rows.size();
                           },
                       .left_out = [&](std::uint64_t begin,
                                       std::uint64_t end) { place->left_out.emplace_back(begin, end); }})
      .warning;
}

// Copies a range whose session is in no other file: nothing in it is repeated.
void copy_all(const ByteRange& place, AtomicFile& out) {
  LineReader line(place.file);
  line.go_to(place.begin);
  while (line.end() < place.end && line.next()) {
    if (!place.leaves_out(line.begin())) out.write(line.text() + '\n');
  }
}

// Copies the descriptions and measurements of a range that have not been written yet. The lines were
// validated by find_sessions.
void copy_new(const ByteRange& place, std::set<std::string>& written, AtomicFile& out, MergeCounts& merged) {
  LineReader line(place.file);
  line.go_to(place.begin);
  std::string lines;
  std::size_t rows = 0;
  while (line.end() < place.end && line.next()) {
    if (place.leaves_out(line.begin())) continue;
    const ResultsLine parsed = parse_line(line.text());
    lines += line.text() + '\n';
    rows += parsed.scene ? 0 : 1;
    if (!parsed.scene && !parsed.last) continue;
    if (written.insert(sha256(lines)).second) {
      out.write(lines);
      merged.rows += rows;
    } else {
      merged.repeated_rows += rows;
    }
    lines.clear();
    rows = 0;
  }
}

}  // namespace

MergeCounts merge_results(const std::vector<fs::path>& files, const fs::path& out) {
  if (fs::exists(fs::symlink_status(out)))
    throw std::invalid_argument(fmt::format("{}: exists, it must be a new file", out.string()));
  AtomicFile file(out);
  std::vector<SessionRanges> sessions;
  MergeCounts merged;
  for (const auto& from : files) {
    if (auto warning = find_sessions(from, sessions); !warning.empty())
      merged.warnings.push_back(std::move(warning));
  }
  merged.sessions = sessions.size();
  for (const auto& [line, places] : sessions) {
    file.write(line);
    if (places.size() == 1) {
      copy_all(places.front(), file);
      merged.rows += places.front().rows;
      continue;
    }
    std::set<std::string> written;
    for (const auto& place : places) copy_new(place, written, file, merged);
  }
  file.commit_new();
  return merged;
}

}  // namespace fde::bench
