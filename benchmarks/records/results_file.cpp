// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/records/results_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <tuple>
#include <utility>

#include "fdebench/benchmarks/measures/measures.hpp"
#include "fdebench/benchmarks/records/lines.hpp"
#include "fdebench/benchmarks/records/record_text.hpp"
#include "fdebench/benchmarks/records/results_scan.hpp"

namespace fde::bench {

namespace {

std::invalid_argument cannot_be_written(const std::filesystem::path& file, const char* reason) {
  return std::invalid_argument(fmt::format("{}: cannot be written: {}", file.string(), reason));
}

// Whether the file can be locked for this process within `wait`. Polls, because flock has no timeout.
bool try_lock_for(std::chrono::seconds wait, int descriptor) {
  constexpr std::chrono::milliseconds between{5};
  const auto last = std::chrono::steady_clock::now() + wait;
  while (flock(descriptor, LOCK_EX | LOCK_NB) != 0) {
    if (std::chrono::steady_clock::now() >= last) return false;
    std::this_thread::sleep_for(between);
  }
  return true;
}

// Whether rows of the same build, written at once, count here after what is recorded of their run. Of another
// machine, an examination counts unless one is known or the run was too slow there; a time does not.
bool counts(const std::vector<Record>& rows, bool from_here, const RecordedRun& known) {
  const auto& ending = rows.back().ending;
  return from_here || (!known.ending() && ending && ending->kind != SolveStatus::out_of_budget);
}

// The recorded runs and scenes of this build, and the offset of the end of the last complete write.
struct RecordedContents {
  RecordedByKey runs{};
  std::set<SceneSettings> scenes{};
  ScanSummary summary{};
};
RecordedContents recorded_in(const std::filesystem::path& file, const Session& build) {
  RecordedContents found;
  bool is_ours = false, from_here = false;
  found.summary = scan_results(file, {.session =
                                          [&](const Session& session, auto) {
                                            is_ours = same_build(session, build);
                                            from_here = same_machine(session, build);
                                          },
                                      .scene =
                                          [&](const SceneDescription& scene, auto) {
                                            if (is_ours) found.scenes.insert(scene.scene);
                                          },
                                      .rows =
                                          [&](const std::vector<Record>& rows, auto) {
                                            if (!is_ours) return;
                                            RecordedRun& run = found.runs[rows.front().key];
                                            if (!counts(rows, from_here, run)) return;
                                            for (const Record& row : rows) run.add(row);
                                          }});
  return found;
}

}  // namespace

bool same_build(const Session& a, const Session& b) {
  const auto facts = [](const Session& s) { return std::tie(s.compiler, s.flags, s.commit, s.version); };
  return facts(a) == facts(b);
}

bool same_machine(const Session& a, const Session& b) { return a.machine == b.machine; }

bool is_time(const Record& row) {
  return row.unit == "s" ||
         std::ranges::find(time_measures(), row.quantity, &TimeMeasure::id) != time_measures().end();
}

// Rows are counted first: growing the vector would need twice the memory.
Results read_results(const std::filesystem::path& file) {
  std::size_t count = 0;
  for (LineReader line(file); line.next();) ++count;
  Results results;
  results.records.reserve(count);
  results.warning =
      scan_results(file,
                   {.session = [&](const Session& session, auto) { results.sessions.push_back(session); },
                    .scene = [&](const SceneDescription& scene, auto) { results.scenes.push_back(scene); },
                    .rows = [&](std::vector<Record> rows,
                                auto) { std::ranges::move(rows, std::back_inserter(results.records)); }})
          .warning;
  return results;
}

RecordedRun recorded_of(const RecordedByKey& runs, const RunKey& run) {
  const auto found = runs.find(run);
  return found == runs.end() ? RecordedRun() : found->second;
}

ReadRecorded read_recorded(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return {};
  auto found = recorded_in(file, this_session());
  return {std::move(found.runs), std::move(found.summary.warning)};
}

ResultsFile::ResultsFile(std::filesystem::path file, std::chrono::seconds wait) : path_(std::move(file)) {
  require_file(path_);
  descriptor_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (descriptor_ < 0) throw cannot_be_written(path_, std::strerror(errno));
  try {
    if (!try_lock_for(wait, descriptor_)) throw cannot_be_written(path_, "another run is writing to it");
    auto found = recorded_in(path_, session_);
    recorded_ = std::move(found.runs);
    described_ = std::move(found.scenes);
    warning_ = std::move(found.summary.warning);
    if (ftruncate(descriptor_, static_cast<off_t>(found.summary.valid)) != 0)
      throw cannot_be_written(path_, std::strerror(errno));
  } catch (...) {
    close(descriptor_);
    throw;
  }
}

ResultsFile::~ResultsFile() { close(descriptor_); }

void ResultsFile::append(const std::vector<Record>& rows) {
  std::string lines;
  for (const auto& row : rows) lines += line_of(row, &row == &rows.back());
  write(lines);
  for (const Record& row : rows) recorded_[row.key].add(row);
}

void ResultsFile::append(const SceneDescription& scene) {
  described_.insert(scene.scene);  // also if it is unreadable, so that it is not computed again
  write(line_of(scene));
}

void ResultsFile::write(const std::string& lines) {
  try {
    require_readable(lines);
  } catch (const std::exception& reason) {
    throw UnreadableLines(
        fmt::format("{}: not written, for no command could read it: {}", path_.string(), reason.what()));
  }
  write_bytes(session_written_ ? lines : line_of(session_) + lines);
  session_written_ = true;
}

void ResultsFile::write_bytes(const std::string& text) {
  const auto before = lseek(descriptor_, 0, SEEK_END);
  std::size_t written = 0;
  while (written < text.size()) {
    const auto count = ::write(descriptor_, text.data() + written, text.size() - written);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) {
      const int reason = errno;
      [[maybe_unused]] const int ignored =
          ftruncate(descriptor_, before);  // incomplete rows are ignored by readers
      throw std::system_error(reason, std::generic_category(), path_.string() + ": cannot be written");
    }
    written += static_cast<std::size_t>(count);
  }
  struct stat file {};
  if (fstat(descriptor_, &file) == 0 &&
      file.st_nlink == 0) {  // the file has been unlinked: the rows are lost
    throw std::system_error(ENOENT, std::generic_category(), path_.string() + ": cannot be written");
  }
}

}  // namespace fde::bench
