// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/records/results_reader.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace fde::bench {
namespace {

std::string at_line(const std::filesystem::path& file, int number, std::string_view what) {
  return fmt::format("{}: line {}{}", file.string(), number, what);
}

// Throws std::invalid_argument if no session precedes the line.
void require_session(const ResultsLine& line, std::size_t sessions, bool is_session_lost) {
  if (sessions == 0) {
    const bool is_scene = std::holds_alternative<SceneDescription>(line);
    throw std::invalid_argument(fmt::format("a {} before the first session", is_scene ? "scene" : "run"));
  }
  if (is_session_lost) throw std::invalid_argument("its session is left out");
}

}  // namespace

std::optional<ResultsLine> ResultsReader::next() {
  while (line_.next() && !is_torn()) {
    complete_ = line_.end();
    if (auto line = take()) return line;
  }
  return std::nullopt;
}

std::string ResultsReader::warning() const {
  if (left_out_ == 0) return {};
  const auto others = left_out_ - 1;
  return fmt::format(
      "{} (left out{})", first_reason_,
      others == 0 ? "" : fmt::format(", with {} other line{}", others, others == 1 ? "" : "s"));
}

// Whether the line is the incomplete one of a killed sweep; of a file that is none of ours it is not.
bool ResultsReader::is_torn() const {
  const std::string& text = line_.text();
  return !line_.has_end() &&
         (complete_ > 0 || text.starts_with(session_prefix) || session_prefix.starts_with(text));
}

std::optional<ResultsLine> ResultsReader::take() {
  try {
    auto line = parse_line(line_.text());
    if (std::holds_alternative<Session>(line)) {
      ++sessions_;
      is_session_lost_ = false;
      return line;
    }
    require_session(line, sessions_, is_session_lost_);
    const std::size_t session = sessions_ - 1;
    if (auto* run = std::get_if<Record>(&line)) run->session = run->timing.session = session;
    if (auto* times = std::get_if<LaterTimes>(&line)) times->timing.session = session;
    return line;
  } catch (const UnsupportedFormat&) {
    throw std::invalid_argument(
        at_line(file_, line_.number(), ": results of another version of fdebench, to be measured again"));
  } catch (const std::invalid_argument& impossible) {
    leave_out(fmt::format(": {}", impossible.what()));
  } catch (const std::exception&) {
    leave_out(" is not a row of fdebench results");
  }
  return std::nullopt;
}

// Nothing is a results file that does not begin with a session.
void ResultsReader::leave_out(std::string_view reason) {
  const auto text = at_line(file_, line_.number(), reason);
  if (sessions_ == 0) throw std::invalid_argument(text);
  if (left_out_++ == 0) first_reason_ = text;
  is_session_lost_ = is_session_lost_ || line_.text().starts_with(session_prefix);
}

}  // namespace fde::bench
