// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>

#include "fdebench/benchmarks/records/record.hpp"

namespace fde::bench {

// A line of a results file, in JSON: a session, or a scene, a run or later times of a run of the preceding
// session. A scene whose line would be longer than most_line_bytes is written without its parameters; if that
// does not suffice, also without its equations, then its solution.
using ResultsLine = std::variant<Session, SceneDescription, Record, LaterTimes>;

// A run as its line has it.
nlohmann::json json_of(const Record& run);

std::string line_of(const Session& session);
std::string line_of(const SceneDescription& scene);
std::string line_of(const Record& run);
std::string line_of(const LaterTimes& times);

// A session whose lines have another format.
struct UnsupportedFormat : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

// A line that is valid (record_validation.hpp). Throws UnsupportedFormat, std::invalid_argument for an
// invalid line, and another std::exception for anything else.
ResultsLine parse_line(const std::string& line);

// The beginning of every session, and so of every file.
inline constexpr std::string_view session_prefix = R"({"format":)";

}  // namespace fde::bench
