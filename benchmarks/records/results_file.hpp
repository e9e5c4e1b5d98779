// SPDX-License-Identifier: MIT
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "fdebench/benchmarks/records/recorded_run.hpp"

namespace fde::bench {

// The contents of a results file, as scan_results reads it.
Results read_results(const std::filesystem::path& file);

// The recorded rows of each run by this build: its times on this machine, its examination on any.
using RecordedByKey = std::map<RunKey, RecordedRun>;
RecordedRun recorded_of(const RecordedByKey& runs, const RunKey& run);

// The runs in a results file, and its warning (ScanSummary); empty if there is no file. The file is not
// changed.
struct ReadRecorded {
  RecordedByKey runs{};
  std::string warning{};
};
ReadRecorded read_recorded(const std::filesystem::path& file);

// Rows or a description that no reader would accept: a defect of what computed them.
struct UnreadableLines : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// A results file open for appending. The rows of an examination are appended in one write, and so are the
// times of a run: a killed process leaves a valid file.
class ResultsFile {
 public:
  // Opens or creates the file with an exclusive lock, truncates incomplete last rows and starts a session.
  // Throws std::invalid_argument naming the file if it cannot be written, is not a results file, or is locked
  // by another run for longer than `wait`.
  explicit ResultsFile(std::filesystem::path file, std::chrono::seconds wait = {});
  ResultsFile(const ResultsFile&) = delete;
  ResultsFile& operator=(const ResultsFile&) = delete;
  ~ResultsFile();

  // The recorded rows of this run, as RecordedByKey has them.
  [[nodiscard]] RecordedRun recorded(const RunKey& run) const { return recorded_of(recorded_, run); }

  // What ScanSummary says of the lines that were in the file; empty: nothing.
  [[nodiscard]] const std::string& warning() const { return warning_; }

  // Whether the same build has described this scene.
  [[nodiscard]] bool describes(const SceneSettings& scene) const { return described_.contains(scene); }

  // Appends the rows of an examination, the ending last, or the times of a recorded one; or the description
  // of a scene. They are read back before they are written: throws UnreadableLines, and writes nothing, if a
  // reader would leave one out. Throws std::system_error naming the file if the disk is full or the file has
  // been removed.
  void append(const std::vector<Record>& rows);
  void append(const SceneDescription& scene);

 private:
  void write(const std::string& lines);
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
