// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <unordered_map>

#include "fdebench/benchmarks/records/placed_run.hpp"
#include "fdebench/benchmarks/records/record_text.hpp"

namespace fde::bench {

// Which examinations of a run are read: all, or the last one of any build.
enum class Examinations { all, latest };

// The contents of a results file, as ResultsReader reads it. Later times are those of the last examination of
// their run by the same build; without one they are left out.
Results read_results(const std::filesystem::path& file, Examinations which = Examinations::all);

// What this build has recorded of each run: its examination on any machine, its times on this one. Where they
// are is known; a record is read from the file when it is looked up.
class RecordedRuns {
 public:
  // Those in the file, which must exist.
  RecordedRuns(const std::filesystem::path& path, const Session& build);

  // The record of a run; nullopt: there is none. Several threads may call it.
  [[nodiscard]] std::optional<Record> find(const RunKey& run) const;

  // What ResultsReader says of the file; the offset of the end of its last complete line.
  [[nodiscard]] const std::string& warning() const { return warning_; }
  [[nodiscard]] std::uint64_t complete() const { return complete_; }

  // Whether the build has described this scene.
  [[nodiscard]] bool describes(const SceneSettings& scene) const { return described_.contains(scene); }

  // A line at this offset, read by the constructor or appended since. Of another machine, an examination
  // counts unless one is known or the run was too slow there; a time does not.
  void add(const ResultsLine& line, std::uint64_t offset, bool is_from_here);

 private:
  LinesByOffset file_;
  std::unordered_map<Digest, PlacedRun, DigestHash> places_{};
  std::set<SceneSettings> described_{};
  std::string warning_{};
  std::uint64_t complete_ = 0;
};

// The runs in a results file, which is not changed; nullopt if there is no file.
std::optional<RecordedRuns> read_recorded(const std::filesystem::path& file);

// A line that no reader would accept: a defect of what computed it.
struct UnreadableLine : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A results file open for appending. A line is appended in one write: a killed process leaves a valid file.
class ResultsFile {
 public:
  // Opens or creates the file with an exclusive lock, removes an incomplete last line and starts a session.
  // Throws std::invalid_argument naming the file if it cannot be written, is not a results file, or is locked
  // by another run for longer than `wait`.
  explicit ResultsFile(std::filesystem::path file, std::chrono::seconds wait = {});
  ResultsFile(const ResultsFile&) = delete;
  ResultsFile& operator=(const ResultsFile&) = delete;
  ~ResultsFile();

  // The record of this run, as RecordedRuns has it.
  [[nodiscard]] std::optional<Record> recorded(const RunKey& run) const;

  // What ResultsReader says of the lines that were in the file; empty: nothing.
  [[nodiscard]] const std::string& warning() const { return recorded_->warning(); }

  // Whether the same build has described this scene.
  [[nodiscard]] bool describes(const SceneSettings& scene) const { return recorded_->describes(scene); }

  // Appends a run, the times of a run that is recorded, or the description of a scene. The line is read back
  // before it is written: throws UnreadableLine, and writes nothing, if a reader would leave it out. Throws
  // std::system_error naming the file if the disk is full or the file has been removed.
  void append(const Record& run);
  void append_times(const Record& run);
  void append(const SceneDescription& scene);

 private:
  void write(const std::string& line);
  void write_bytes(const std::string& text);

  std::filesystem::path path_;
  int descriptor_ = -1;
  Session session_ = this_session();
  bool session_written_ = false;
  std::optional<RecordedRuns> recorded_{};  // of the constructor on
};

}  // namespace fde::bench
