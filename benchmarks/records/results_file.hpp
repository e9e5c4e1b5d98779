#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "records/recorded_run.hpp"
#include "scenes/registry.hpp"

namespace fde {

// All that a results file holds, as scan_results reads it.
Results read_results(const std::filesystem::path& file, const Scenes& known = scenes());

// What is recorded of each run by this build on this machine.
using RecordedByKey = std::map<RunKey, RecordedRun>;
RecordedRun recorded_of(const RecordedByKey& runs, const RunKey& run);

// What a results file holds of them; nothing where there is no file. It is not changed.
RecordedByKey read_recorded(const std::filesystem::path& file, const Scenes& known = scenes());

// A results file open for more runs. The rows of an examination go out in one write, so do the times of a
// run: a kill leaves a valid file without what was in flight.
class ResultsFile {
 public:
  // Opens or creates the file for this process alone, drops incomplete last rows and starts a session.
  // Throws std::invalid_argument naming the file when it cannot be written, holds something else or is open
  // in another run for longer than `wait`.
  explicit ResultsFile(std::filesystem::path file, const Scenes& known = scenes(),
                       std::chrono::seconds wait = {});
  ResultsFile(const ResultsFile&) = delete;
  ResultsFile& operator=(const ResultsFile&) = delete;
  ~ResultsFile();

  // What the file holds of this run, made by the same build on the same machine.
  [[nodiscard]] RecordedRun recorded(const RunKey& run) const { return recorded_of(recorded_, run); }

  // Appends the rows of an examination, the ending last, or the times of one that is there. Throws
  // std::system_error naming the file when the disk is full or the file is gone.
  void append(const std::vector<Record>& rows);

 private:
  void write(const std::string& text);

  std::filesystem::path path_;
  int descriptor_ = -1;
  Session session_ = this_session();
  bool session_written_ = false;
  RecordedByKey recorded_;
};

}  // namespace fde
