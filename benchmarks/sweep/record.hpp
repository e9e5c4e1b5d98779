#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

namespace fde {

// One number of one run: a row of tidy results.
struct Record {
  std::string scene{}, scheme{}, history{};  // history as asked for
  int steps = 0;
  double h = 0.0;
  double tolerance = 0.0;  // Options::tolerance
  std::string quantity{};  // a Measure's id, or "outcome", the last row of each examination
  double value = 0.0;
  std::string unit{};
  // Of an outcome "finished", or what went wrong and when, or "refused: reason"; of the last time "timed".
  std::string status{};
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

// Whether two sessions were of the same build on the same machine, so that their rows belong together.
bool same_build(const Session& a, const Session& b);

// Whether the row is a time of a run, made after its examination.
bool is_time(const Record& row);

// How far a run has come: nothing, all but its times, everything (a run that did not finish is not timed).
enum class Stage { missing, examined, done };

// Reads a results file: JSON lines, a session or a record each. Incomplete last rows, left by a killed sweep,
// are passed over. Throws std::invalid_argument naming the file (and line) when it cannot be read or is
// something else.
Results read_results(const std::filesystem::path& file);

// A results file open for more runs. The rows of an examination go out in one write, so do the times of a
// run: a kill leaves a valid file without what was in flight.
class ResultsFile {
 public:
  // Opens or creates the file for this process alone, drops incomplete last rows and starts a session.
  // Throws std::invalid_argument naming the file when it cannot be written, holds something else or is open
  // in another run.
  explicit ResultsFile(std::filesystem::path file);
  ResultsFile(const ResultsFile&) = delete;
  ResultsFile& operator=(const ResultsFile&) = delete;
  ~ResultsFile();

  // What the file holds of this run, made by the same build on the same machine.
  [[nodiscard]] Stage stage(const std::string& scene, const std::string& scheme, int steps) const;

  // Appends the rows of an examination, the outcome last, or the times of one that is there. Throws
  // std::system_error naming the file when the disk is full or the file is gone.
  void append(const std::vector<Record>& rows);

 private:
  using Key = std::tuple<std::string, std::string, int>;  // scene, scheme, steps

  void write(const std::string& text);
  void note(const Record& row);

  std::filesystem::path path_;
  int descriptor_ = -1;
  Session session_ = this_session();
  bool session_written_ = false;
  std::map<Key, Stage> stages_;  // of this build
};

}  // namespace fde
