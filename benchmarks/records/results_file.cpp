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
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

#include "fdebench/benchmarks/records/results_reader.hpp"

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

}  // namespace

Results read_results(const std::filesystem::path& file, Examinations which) {
  Results results;
  std::vector<std::size_t> builds;  // for each session the first of the same build
  std::unordered_map<Digest, std::size_t, DigestHash>
      last;  // index of the record of a run, of each build or of any
  const auto digest = [&](const RunKey& run) {
    auto of_run = digest_of(run);
    if (which == Examinations::all) of_run[1] += builds.back();
    return of_run;
  };
  ResultsReader reader(file);
  while (auto line = reader.next()) {
    if (auto* session = std::get_if<Session>(&*line)) {
      const auto same = [&](const Session& other) { return same_build(other, *session); };
      builds.push_back(
          static_cast<std::size_t>(std::ranges::find_if(results.sessions, same) - results.sessions.begin()));
      results.sessions.push_back(std::move(*session));
    } else if (auto* scene = std::get_if<SceneDescription>(&*line)) {
      results.scenes.push_back(std::move(*scene));
    } else if (auto* run = std::get_if<Record>(&*line)) {
      auto& place = last.try_emplace(digest(run->key), results.records.size()).first->second;
      if (which == Examinations::all) place = results.records.size();
      if (place == results.records.size()) {
        results.records.push_back(std::move(*run));
      } else {
        results.records[place] = std::move(*run);
      }
    } else if (const auto* times = std::get_if<LaterTimes>(&*line)) {
      const auto found = last.find(digest(times->key));
      if (found == last.end()) continue;
      Record& timed = results.records[found->second];
      if (builds[timed.session] == builds.back()) timed.take(times->timing);
    }
  }
  results.warning = reader.warning();
  return results;
}

RecordedRuns::RecordedRuns(const std::filesystem::path& path, const Session& build) : file_(path) {
  bool is_ours = false, is_from_here = false;
  ResultsReader reader(path);
  while (const auto line = reader.next()) {
    if (const auto* session = std::get_if<Session>(&*line)) {
      is_ours = same_build(*session, build);
      is_from_here = same_machine(*session, build);
    }
    if (is_ours) add(*line, reader.begin(), is_from_here);
  }
  warning_ = reader.warning();
  complete_ = reader.complete();
}

void RecordedRuns::add(const ResultsLine& line, std::uint64_t offset, bool is_from_here) {
  if (const auto* scene = std::get_if<SceneDescription>(&line)) {
    described_.insert(scene->scene);
  } else if (const auto* run = std::get_if<Record>(&line)) {
    const auto key = digest_of(run->key);
    if (!is_from_here && (places_.contains(key) || run->ending.kind == SolveStatus::out_of_budget)) return;
    places_.insert_or_assign(key, PlacedRun{.examination = offset,
                                            .session = static_cast<std::uint32_t>(run->session),
                                            .has_own_times = is_from_here});
  } else if (const auto* times = std::get_if<LaterTimes>(&line)) {
    const auto found = places_.find(digest_of(times->key));
    if (is_from_here && found != places_.end()) found->second.take_times(offset, times->timing.session);
  }
}

std::optional<Record> RecordedRuns::find(const RunKey& run) const {
  const auto found = places_.find(digest_of(run));
  return found == places_.end() ? std::nullopt : std::optional(read_record(file_, found->second));
}

std::optional<RecordedRuns> read_recorded(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return std::nullopt;
  return std::optional<RecordedRuns>(std::in_place, file, this_session());
}

ResultsFile::ResultsFile(std::filesystem::path file, std::chrono::seconds wait) : path_(std::move(file)) {
  require_file(path_);
  descriptor_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (descriptor_ < 0) throw cannot_be_written(path_, std::strerror(errno));
  try {
    if (!try_lock_for(wait, descriptor_)) throw cannot_be_written(path_, "another run is writing to it");
    recorded_.emplace(path_, session_);
    if (ftruncate(descriptor_, static_cast<off_t>(recorded_->complete())) != 0)
      throw cannot_be_written(path_, std::strerror(errno));
  } catch (...) {
    close(descriptor_);
    throw;
  }
}

ResultsFile::~ResultsFile() { close(descriptor_); }

std::optional<Record> ResultsFile::recorded(const RunKey& run) const { return recorded_->find(run); }

void ResultsFile::append(const Record& run) { write(line_of(run)); }

void ResultsFile::append_times(const Record& run) { write(line_of(LaterTimes{run.key, run.timing})); }

void ResultsFile::append(const SceneDescription& scene) {
  recorded_->add(scene, 0, true);  // also if it is unreadable, so that it is not computed again
  write(line_of(scene));
}

void ResultsFile::write(const std::string& line) {
  ResultsLine read;
  try {
    if (line.size() > most_line_bytes + 1) throw std::invalid_argument("too long");
    read = parse_line(line);
  } catch (const std::exception& reason) {
    throw UnreadableLine(
        fmt::format("{}: not written, for no command could read it: {}", path_.string(), reason.what()));
  }
  write_bytes(session_written_ ? line : line_of(session_) + line);
  session_written_ = true;
  recorded_->add(read, static_cast<std::uint64_t>(lseek(descriptor_, 0, SEEK_END)) - line.size(), true);
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
          ftruncate(descriptor_, before);  // an incomplete line is ignored by readers
      throw std::system_error(reason, std::generic_category(), path_.string() + ": cannot be written");
    }
    written += static_cast<std::size_t>(count);
  }
  struct stat file {};
  if (fstat(descriptor_, &file) == 0 && file.st_nlink == 0) {  // the file has been unlinked: the line is lost
    throw std::system_error(ENOENT, std::generic_category(), path_.string() + ": cannot be written");
  }
}

}  // namespace fde::bench
