// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "fdebench/benchmarks/records/record.hpp"
#include "fdebench/benchmarks/records/scene_description.hpp"

namespace fde::bench {

// Lines of a results file, in JSON: a session, or a scene or a row of the preceding session. `last` marks the
// last row of a measurement, which is written at once. A scene whose line would be longer than
// most_line_bytes is written without its parameters; if that does not suffice, also without its equations,
// then its solution.

std::string line_of(const Session& session);
std::string line_of(const SceneDescription& scene);
std::string line_of(const Record& row, bool last);

// A parsed line: a session, a scene, or a row with its mark.
struct ResultsLine {
  std::optional<Session> session{};
  std::optional<SceneDescription> scene{};
  Record row{};
  bool last = false;
};

// A session whose rows have another format.
struct UnsupportedFormat : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

// Throws UnsupportedFormat, std::invalid_argument for an invalid row, and another std::exception for anything
// else.
ResultsLine parse_line(const std::string& line);

// Parses the lines of a file one after the other, as parse_line does each. The rows of a run differ in
// quantity, unit and value only: a row that continues the text of an earlier one takes its other fields
// without parsing them, which is four times as fast.
class LineParser {
 public:
  ResultsLine parse(const std::string& line);

 private:
  [[nodiscard]] std::optional<Record> continued(std::string_view line) const;
  void keep(std::string_view line, const Record& row);

  Record row_{};
  std::string until_quantity_{}, until_unit_{};  // the text of row_; empty: none
};

// The beginning of every session, and so of every file.
inline constexpr std::string_view session_prefix = R"({"format":)";

}  // namespace fde::bench
