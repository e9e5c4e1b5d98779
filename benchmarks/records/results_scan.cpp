// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/records/results_scan.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "fdebench/benchmarks/records/lines.hpp"
#include "fdebench/benchmarks/records/record_text.hpp"
#include "fdebench/benchmarks/records/record_validation.hpp"

namespace fde::bench {
namespace {

// The state of a scan.
class Scan {
 public:
  Scan(const ScanCallbacks& callbacks, const SceneRegistry& known)
      : callbacks_(callbacks), possible_(known) {}

  void add_line(const std::string& text, std::uint64_t end) {
    auto line = parse_line(text);
    if (line.session) {
      begin_session(*line.session, end);
    } else {
      add_row(std::move(line.row), line.last, end);
    }
  }

  // Offset of the end of the last complete write.
  [[nodiscard]] std::uint64_t valid() const { return valid_; }

 private:
  void begin_session(const Session& session, std::uint64_t end) {
    if (!open_rows_.empty())
      throw std::invalid_argument("a session begins before the last row of the measurement above");
    ++sessions_;
    valid_ = end;
    callbacks_.session(session, end);
  }

  void add_row(Record row, bool last, std::uint64_t end) {
    if (sessions_ == 0) throw std::invalid_argument("a row before the first session");
    possible_.require(row);
    if (!open_rows_.empty() && (open_rows_.front().key != row.key || open_rows_.front().steps != row.steps))
      throw std::invalid_argument("a row of another run before the last row of the measurement above");
    row.session = sessions_ - 1;
    open_rows_.push_back(std::move(row));
    if (!last) return;
    valid_ = end;
    callbacks_.rows(std::exchange(open_rows_, {}), end);
  }

  const ScanCallbacks& callbacks_;
  RecordValidator possible_;
  std::size_t sessions_ = 0;
  std::vector<Record> open_rows_{};
  std::uint64_t valid_ = 0;
};

// Whether a line without a line end is an incomplete line of a killed sweep.
bool is_truncated_write(const std::string& text, const Scan& scan) {
  return scan.valid() > 0 || text.starts_with(session_prefix) || session_prefix.starts_with(text);
}

std::invalid_argument at_line(const std::filesystem::path& file, int number, std::string_view what) {
  return std::invalid_argument(fmt::format("{}: line {}{}", file.string(), number, what));
}

}  // namespace

std::uint64_t scan_results(const std::filesystem::path& file, const ScanCallbacks& callbacks,
                           const SceneRegistry& known) {
  LineReader line(file);
  Scan scan(callbacks, known);
  while (line.next()) {
    if (!line.has_end() && is_truncated_write(line.text(), scan)) break;
    try {
      scan.add_line(line.text(), line.end());
      if (!line.has_end()) throw std::invalid_argument("no line end");
    } catch (const UnsupportedFormat&) {
      throw at_line(file, line.number(), ": results of another version of fdebench, to be measured again");
    } catch (const std::invalid_argument& impossible) {
      throw at_line(file, line.number(), fmt::format(": {}", impossible.what()));
    } catch (const std::exception&) {
      throw at_line(file, line.number(), " is not a row of fdebench results");
    }
  }
  return scan.valid();
}

}  // namespace fde::bench
