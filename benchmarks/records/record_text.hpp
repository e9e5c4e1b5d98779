#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "records/record.hpp"

namespace fde {

// Lines of a results file, JSON each: a session, or a row of the session before. The last row of what was
// measured at once says so.

std::string line_of(const Session& session);
std::string line_of(const Record& row, bool last);

// What a line holds: a session, or a row and whether it is the last of its measurement.
struct ResultsLine {
  std::optional<Session> session{};
  Record row{};
  bool last = false;
};

// A session of a file that has its rows in another form.
struct OtherFormat : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

// Throws OtherFormat, std::invalid_argument for a row that says something impossible, and std::exception for
// whatever else is no such line.
ResultsLine parse_line(const std::string& line);

// With what every session begins, and so every file.
inline constexpr std::string_view first_words = R"({"format":)";

}  // namespace fde
