// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>

#include "fdebench/benchmarks/records/record.hpp"

namespace fde::bench {

// The contents of a results file, as ResultsReader reads it. Later times are those of the last examination of
// their run by the same build; without one they are left out.
Results read_results(const std::filesystem::path& file);

// What this build has recorded of each run: its examination on any machine, its times on this one. The
// examinations are without courses and errors of single columns.
using RecordedByKey = std::map<RunKey, Record>;

// The record of a run; nullopt: there is none.
std::optional<Record> recorded_of(const RecordedByKey& runs, const RunKey& run);

// The runs in a results file, and its warning (ResultsReader); empty if there is no file. The file is not
// changed.
struct ReadRecorded {
  RecordedByKey runs{};
  std::string warning{};
};
ReadRecorded read_recorded(const std::filesystem::path& file);

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

  // The record of this run, as RecordedByKey has it.
  [[nodiscard]] std::optional<Record> recorded(const RunKey& run) const {
    return recorded_of(recorded_, run);
  }

  // What ResultsReader says of the lines that were in the file; empty: nothing.
  [[nodiscard]] const std::string& warning() const { return warning_; }

  // Whether the same build has described this scene.
  [[nodiscard]] bool describes(const SceneSettings& scene) const { return described_.contains(scene); }

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
  std::string warning_{};
  Session session_ = this_session();
  bool session_written_ = false;
  RecordedByKey recorded_;
  std::set<SceneSettings> described_;
};

}  // namespace fde::bench
