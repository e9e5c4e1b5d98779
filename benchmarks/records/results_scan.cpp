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
  explicit Scan(const ScanCallbacks& callbacks) : callbacks_(callbacks) {}

  void add_line(const std::string& text, std::uint64_t end) {
    auto line = parser_.parse(text);
    if (line.session) {
      begin_session(*line.session, end);
    } else if (line.scene) {
      add_scene(*line.scene, end);
    } else {
      add_row(std::move(line.row), line.last, end);
    }
  }

  // Offset of the end of the last complete write.
  [[nodiscard]] std::uint64_t valid() const { return valid_; }

 private:
  void require_no_open_rows(std::string_view what) const {
    if (!open_rows_.empty()) {
      throw std::invalid_argument(
          fmt::format("a {} begins before the last row of the measurement above", what));
    }
  }

  void require_session(std::string_view what) const {
    if (sessions_ == 0) throw std::invalid_argument(fmt::format("a {} before the first session", what));
  }

  void begin_session(const Session& session, std::uint64_t end) {
    require_no_open_rows("session");
    ++sessions_;
    valid_ = end;
    callbacks_.session(session, end);
  }

  void add_scene(const SceneDescription& scene, std::uint64_t end) {
    require_session("scene");
    require_no_open_rows("scene");
    require_valid(scene);
    valid_ = end;
    callbacks_.scene(scene, end);
  }

  void add_row(Record row, bool last, std::uint64_t end) {
    require_session("row");
    require_valid(row);
    if (!open_rows_.empty() && (open_rows_.front().key != row.key || open_rows_.front().steps != row.steps))
      throw std::invalid_argument("a row of another run before the last row of the measurement above");
    row.session = sessions_ - 1;
    open_rows_.push_back(std::move(row));
    if (!last) return;
    valid_ = end;
    callbacks_.rows(std::exchange(open_rows_, {}), end);
  }

  const ScanCallbacks& callbacks_;
  LineParser parser_{};
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

std::uint64_t scan_results(const std::filesystem::path& file, const ScanCallbacks& callbacks) {
  LineReader line(file);
  Scan scan(callbacks);
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
