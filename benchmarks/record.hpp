#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace fde {

// One number of one run: a row of tidy results.
struct Record {
  std::string scene{}, scheme{}, history{};  // history as asked for
  int steps = 0;
  double h = 0.0;
  double tolerance = 0.0;  // Options::tolerance
  std::string quantity{};  // a Measure's id, or "outcome", the last row of each run
  double value = 0.0;
  std::string unit{};
  std::string status{};     // "finished", or what went wrong and when, or "refused: reason"
  std::size_t session = 0;  // index into Results::sessions
};

// Where and with what numbers were made.
struct Session {
  std::string date, machine, system, compiler, flags, commit, version;
  unsigned cores = 0;
};

// The session of this process, now.
Session this_session();

// All that a results file holds.
struct Results {
  std::vector<Session> sessions;
  std::vector<Record> records;
};

// Reads a results file: JSON lines, a session or a record each. An incomplete last run, left by a killed
// sweep, is passed over. Throws std::invalid_argument naming the file (and line) when it cannot be read or is
// something else.
Results read_results(const std::filesystem::path& file);

// A results file open for more runs. All rows of a run go out in one write, so a kill leaves a valid file.
class ResultsFile {
 public:
  // Opens or creates the file for this process alone, drops an incomplete last run and starts a session.
  // Throws std::invalid_argument naming the file when it cannot be written, holds something else or is open
  // in another run.
  explicit ResultsFile(std::filesystem::path file);
  ResultsFile(const ResultsFile&) = delete;
  ResultsFile& operator=(const ResultsFile&) = delete;
  ~ResultsFile();

  // Whether the file holds the outcome of this run, made by the same build on the same machine.
  [[nodiscard]] bool has(std::string_view scene, std::string_view scheme, int steps) const;

  // Appends the rows of one run, the outcome last. Throws std::system_error naming the file when the disk is
  // full.
  void append(const std::vector<Record>& run);

 private:
  void write(const std::string& text);

  std::filesystem::path path_;
  int descriptor_ = -1;
  Session session_ = this_session();
  bool session_written_ = false;
  Results results_;
};

}  // namespace fde
