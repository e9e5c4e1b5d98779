// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/records/merge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <variant>

#include "fdebench/benchmarks/files/atomic_file.hpp"
#include "fdebench/benchmarks/records/results_reader.hpp"

namespace fde::bench {
namespace {

namespace fs = std::filesystem;

// The line of a session and its other lines, each once, in the order of their first occurrence.
struct MergedSession {
  std::string line;
  std::set<std::string> known{};
  std::vector<const std::string*> lines{};
};

// Returns the warning of the reader.
std::string take(const fs::path& file, std::vector<MergedSession>& sessions, MergeCounts& merged) {
  std::size_t place = 0;  // of the current session
  ResultsReader reader(file);
  while (const auto line = reader.next()) {
    if (const auto* session = std::get_if<Session>(&*line)) {
      const std::string text = line_of(*session);
      const auto found = std::ranges::find(sessions, text, &MergedSession::line);
      place = static_cast<std::size_t>(found - sessions.begin());
      if (found == sessions.end()) sessions.push_back({.line = text});
      continue;
    }
    const auto [added, is_new] = sessions[place].known.insert(reader.text() + '\n');
    if (is_new) sessions[place].lines.push_back(&*added);
    if (!std::holds_alternative<SceneDescription>(*line)) ++(is_new ? merged.rows : merged.repeated_rows);
  }
  return reader.warning();
}

}  // namespace

MergeCounts merge_results(const std::vector<fs::path>& files, const fs::path& out) {
  if (fs::exists(fs::symlink_status(out)))
    throw std::invalid_argument(fmt::format("{}: exists, it must be a new file", out.string()));
  AtomicFile file(out);
  std::vector<MergedSession> sessions;
  MergeCounts merged;
  for (const auto& from : files) {
    const auto warning = take(from, sessions, merged);
    if (!warning.empty()) merged.warnings.push_back(warning);
  }
  merged.sessions = sessions.size();
  for (const auto& session : sessions) {
    file.write(session.line);
    for (const auto* line : session.lines) file.write(*line);
  }
  file.commit_new();
  return merged;
}

}  // namespace fde::bench
