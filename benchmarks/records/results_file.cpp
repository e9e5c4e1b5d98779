#include "records/results_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <system_error>
#include <tuple>
#include <utility>

#include "records/record_text.hpp"

namespace fde {

namespace {

struct Parsed {
  Results results;
  std::size_t valid = 0;  // bytes up to the end of the last complete write
};

// Adds one line; true when it is a session or the last row of one write, so that the file is whole up to
// here.
bool add_line(const std::string& text, Results& results, std::vector<Record>& open_rows) {
  auto line = parse_line(text);
  if (line.session) {
    results.sessions.push_back(*line.session);
    return true;
  }
  if (results.sessions.empty()) throw std::invalid_argument("a record before the first session");
  line.row.session = results.sessions.size() - 1;
  open_rows.push_back(std::move(line.row));
  if (!line.last) return false;
  std::ranges::move(open_rows, std::back_inserter(results.records));
  open_rows.clear();
  return true;
}

Parsed parse(const std::string& text, const std::filesystem::path& file) {
  Parsed parsed;
  std::vector<Record> open_rows;
  std::size_t begin = 0;
  for (int number = 1; begin < text.size(); ++number) {
    const auto end = text.find('\n', begin);
    const bool ours = parsed.valid > 0 || text.starts_with(first_words) || first_words.starts_with(text);
    if (end == std::string::npos && ours) break;  // the line a killed sweep was writing
    try {
      if (add_line(text.substr(begin, end - begin), parsed.results, open_rows)) parsed.valid = end + 1;
      if (end == std::string::npos) throw std::invalid_argument("no line end");
    } catch (const OtherFormat&) {
      throw std::invalid_argument(
          fmt::format("{}: line {}: results of another version of fdebench, to be measured again",
                      file.string(), number));
    } catch (const std::exception&) {
      throw std::invalid_argument(
          fmt::format("{}: line {} is not a row of fdebench results", file.string(), number));
    }
    begin = end + 1;
  }
  return parsed;
}

// A folder, a pipe or a device; what cannot be looked at says so when it is opened.
bool is_something_else(const std::filesystem::path& file) {
  std::error_code problem;
  const auto status = std::filesystem::status(file, problem);
  return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
}

std::string read_text(const std::filesystem::path& file) {
  const auto cannot = [&](const char* reason) {
    return std::invalid_argument(fmt::format("{}: cannot be read: {}", file.string(), reason));
  };
  if (is_something_else(file)) throw cannot("is not a file");
  std::ifstream in(file, std::ios::binary);
  if (!in) throw cannot(std::strerror(errno));
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::invalid_argument cannot_be_written(const std::filesystem::path& file, const char* reason) {
  return std::invalid_argument(fmt::format("{}: cannot be written: {}", file.string(), reason));
}

}  // namespace

bool same_build(const Session& a, const Session& b) {
  const auto facts = [](const Session& s) {
    return std::tie(s.machine, s.compiler, s.flags, s.commit, s.version);
  };
  return facts(a) == facts(b);
}

bool is_time(const Record& row) { return row.quantity.starts_with("time_"); }

Results read_results(const std::filesystem::path& file) { return parse(read_text(file), file).results; }

ResultsFile::ResultsFile(std::filesystem::path file) : path_(std::move(file)) {
  if (is_something_else(path_)) read_text(path_);  // says why not
  descriptor_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (descriptor_ < 0) throw cannot_be_written(path_, std::strerror(errno));
  try {
    if (flock(descriptor_, LOCK_EX | LOCK_NB) != 0)
      throw cannot_be_written(path_, "another run is writing to it");
    const auto parsed = parse(read_text(path_), path_);
    for (const Record& row : parsed.results.records) {
      if (same_build(parsed.results.sessions[row.session], session_)) recorded_[row.key].note(row);
    }
    if (ftruncate(descriptor_, static_cast<off_t>(parsed.valid)) != 0) {
      throw cannot_be_written(path_, std::strerror(errno));
    }
  } catch (...) {
    close(descriptor_);
    throw;
  }
}

ResultsFile::~ResultsFile() { close(descriptor_); }

RecordedRun ResultsFile::recorded(const RunKey& run) const {
  const auto found = recorded_.find(run);
  return found == recorded_.end() ? RecordedRun() : found->second;
}

void ResultsFile::append(const std::vector<Record>& rows) {
  std::string text;
  if (!session_written_) text = line_of(session_);
  for (const auto& row : rows) text += line_of(row, &row == &rows.back());
  write(text);
  session_written_ = true;
  for (const Record& row : rows) recorded_[row.key].note(row);
}

void ResultsFile::write(const std::string& text) {
  const auto before = lseek(descriptor_, 0, SEEK_END);
  std::size_t written = 0;
  while (written < text.size()) {
    const auto count = ::write(descriptor_, text.data() + written, text.size() - written);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) {
      const int reason = errno;
      [[maybe_unused]] const int ignored =
          ftruncate(descriptor_, before);  // incomplete rows are passed over anyway
      throw std::system_error(reason, std::generic_category(), path_.string() + ": cannot be written");
    }
    written += static_cast<std::size_t>(count);
  }
  struct stat file {};
  if (fstat(descriptor_, &file) == 0 && file.st_nlink == 0) {  // rows that nobody could find
    throw std::system_error(ENOENT, std::generic_category(), path_.string() + ": cannot be written");
  }
}

}  // namespace fde
