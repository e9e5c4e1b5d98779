// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/records/results_scan.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "fdebench/benchmarks/records/lines.hpp"
#include "fdebench/benchmarks/records/record_text.hpp"
#include "fdebench/benchmarks/records/record_validation.hpp"

namespace fde::bench {
namespace {

constexpr std::string_view last_mark = R"("last":true)";

std::invalid_argument at_line(const std::filesystem::path& file, int number, std::string_view what) {
  return std::invalid_argument(fmt::format("{}: line {}{}", file.string(), number, what));
}

// The state of a scan.
class Scan {
 public:
  Scan(std::filesystem::path file, const ScanCallbacks& callbacks)
      : file_(std::move(file)), callbacks_(callbacks) {}

  void take(const LineReader& line) {
    line_ = {line.number(), line.begin(), line.end()};
    try {
      add(line.text());
      if (!line.has_end()) throw std::invalid_argument("no line end");
    } catch (const UnsupportedFormat&) {
      throw at_line(file_, line_.number, ": results of another version of fdebench, to be measured again");
    } catch (const std::invalid_argument& impossible) {
      leave_out(line.text(), fmt::format(": {}", impossible.what()));
    } catch (const std::exception&) {
      leave_out(line.text(), " is not a row of fdebench results");
    }
  }

  // Offset of the end of the last complete write.
  [[nodiscard]] std::uint64_t valid() const { return valid_; }

  [[nodiscard]] ScanSummary summary() const {
    if (left_out_ == 0) return {valid_, ""};
    const auto others = left_out_ - 1;
    return {valid_,
            fmt::format(
                "{} (left out{})", first_reason_,
                others == 0 ? "" : fmt::format(", with {} other line{}", others, others == 1 ? "" : "s"))};
  }

 private:
  struct Line {
    int number = 0;
    std::uint64_t begin = 0, end = 0;
  };

  void add(const std::string& text) {
    auto line = parser_.parse(text);
    if (line.session) return begin_session(*line.session);
    if (sessions_ == 0)
      throw std::invalid_argument(fmt::format("a {} before the first session", line.scene ? "scene" : "row"));
    if (is_session_lost_) throw std::invalid_argument("its session is left out");
    if (line.scene) return add_scene(*line.scene);
    add_row(std::move(line.row), line.last);
  }

  void begin_session(const Session& session) {
    leave_out_open_rows();
    ++sessions_;
    is_session_lost_ = false;
    valid_ = line_.end;
    callbacks_.session(session, line_.end);
  }

  void add_scene(const SceneDescription& scene) {
    require_valid(scene);
    leave_out_open_rows();
    valid_ = line_.end;
    callbacks_.scene(scene, line_.end);
  }

  void add_row(Record row, bool last) {
    require_valid(row);
    if (!open_rows_.empty() && (open_rows_.front().key != row.key || open_rows_.front().steps != row.steps))
      leave_out_open_rows();
    row.session = sessions_ - 1;
    if (open_rows_.empty()) first_open_ = line_;
    open_rows_.push_back(std::move(row));
    if (!last) return;
    valid_ = line_.end;
    callbacks_.rows(std::exchange(open_rows_, {}), line_.end);
  }

  // An invalid line. Nothing is a results file that does not begin with a session.
  void leave_out(const std::string& text, std::string_view reason) {
    if (sessions_ == 0) throw at_line(file_, line_.number, reason);
    count(line_, reason, 1);
    const bool is_session = text.starts_with(session_prefix);
    is_session_lost_ = is_session_lost_ || is_session;
    if (is_session || text.find(last_mark) != std::string::npos) leave_out_open_rows();
    if (open_rows_.empty()) valid_ = line_.end;
  }

  // The rows of a measurement whose last row is missing: nothing says how the run ended.
  void leave_out_open_rows() {
    if (!open_rows_.empty()) count(first_open_, ": a measurement without its last row", open_rows_.size());
    open_rows_.clear();
  }

  void count(const Line& first, std::string_view reason, std::size_t lines) {
    if (left_out_ == 0) first_reason_ = at_line(file_, first.number, reason).what();
    left_out_ += lines;
    if (callbacks_.left_out) callbacks_.left_out(first.begin, lines == 1 ? first.end : line_.begin);
  }

  std::filesystem::path file_;
  const ScanCallbacks& callbacks_;
  LineParser parser_{};
  Line line_{}, first_open_{};  // the current line, and that of the first open row
  std::size_t sessions_ = 0, left_out_ = 0;
  bool is_session_lost_ = false;
  std::vector<Record> open_rows_{};
  std::uint64_t valid_ = 0;
  std::string first_reason_{};
};

// Whether a line without a line end is an incomplete line of a killed sweep.
bool is_truncated_write(const std::string& text, const Scan& scan) {
  return scan.valid() > 0 || text.starts_with(session_prefix) || session_prefix.starts_with(text);
}

}  // namespace

ScanSummary scan_results(const std::filesystem::path& file, const ScanCallbacks& callbacks) {
  LineReader line(file);
  Scan scan(file, callbacks);
  while (line.next()) {
    if (!line.has_end() && is_truncated_write(line.text(), scan)) break;
    scan.take(line);
  }
  return scan.summary();
}

void require_readable(const std::string& lines) {
  LineParser parser;
  std::istringstream all(lines);
  for (std::string text; std::getline(all, text);) {
    if (text.size() > most_line_bytes) throw std::invalid_argument("too long");
    const auto line = parser.parse(text);
    if (line.scene) require_valid(*line.scene);
    if (!line.scene && !line.session) require_valid(line.row);
  }
}

}  // namespace fde::bench
