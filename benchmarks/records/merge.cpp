// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/records/merge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <unordered_set>
#include <variant>

#include "fdebench/benchmarks/files/atomic_file.hpp"
#include "fdebench/benchmarks/files/lines_by_offset.hpp"
#include "fdebench/benchmarks/records/digest.hpp"
#include "fdebench/benchmarks/records/results_reader.hpp"

namespace fde::bench {
namespace {

namespace fs = std::filesystem;

// Consecutive bytes of a file.
struct Part {
  std::size_t file = 0;
  std::uint64_t begin = 0, end = 0;
};

// The line of a session and where its other lines are, each once, in the order of their first occurrence.
struct MergedSession {
  std::string line;
  std::unordered_set<Digest, DigestHash> known{};
  std::vector<Part> parts{};

  // Adjoining lines become one part.
  void add(const Part& part) {
    const bool adjoins = !parts.empty() && parts.back().file == part.file && parts.back().end == part.begin;
    adjoins ? void(parts.back().end = part.end) : parts.push_back(part);
  }
};

// Returns the warning of the reader.
std::string take(const fs::path& path, std::size_t file, std::vector<MergedSession>& sessions,
                 MergeCounts& merged) {
  std::size_t place = 0;  // of the current session
  ResultsReader reader(path);
  while (const auto line = reader.next()) {
    if (const auto* session = std::get_if<Session>(&*line)) {
      const std::string text = line_of(*session);
      const auto found = std::ranges::find(sessions, text, &MergedSession::line);
      place = static_cast<std::size_t>(found - sessions.begin());
      if (found == sessions.end()) sessions.push_back({.line = text});
      continue;
    }
    const bool is_new = sessions[place].known.insert(digest_of(reader.text())).second;
    if (is_new) sessions[place].add({file, reader.begin(), reader.complete()});
    if (!std::holds_alternative<SceneDescription>(*line)) ++(is_new ? merged.rows : merged.repeated_rows);
  }
  return reader.warning();
}

void copy(const LinesByOffset& from, const Part& part, AtomicFile& to) {
  constexpr std::uint64_t piece = std::uint64_t{1} << 16;
  for (auto at = part.begin; at < part.end; at += piece)
    to.write(from.bytes(at, static_cast<std::size_t>(std::min(piece, part.end - at))));
}

}  // namespace

MergeCounts merge_results(const std::vector<fs::path>& files, const fs::path& out) {
  if (fs::exists(fs::symlink_status(out)))
    throw std::invalid_argument(fmt::format("{}: exists, it must be a new file", out.string()));
  AtomicFile file(out);
  std::vector<MergedSession> sessions;
  MergeCounts merged;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const auto warning = take(files[i], i, sessions, merged);
    if (!warning.empty()) merged.warnings.push_back(warning);
  }
  merged.sessions = sessions.size();
  for (const auto& session : sessions) {
    file.write(session.line);
    for (const Part& part : session.parts) copy(LinesByOffset(files[part.file]), part, file);
  }
  file.commit_new();
  return merged;
}

}  // namespace fde::bench
