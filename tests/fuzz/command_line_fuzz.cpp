// SPDX-License-Identifier: MIT
// The command with arbitrary arguments, one a line of the input: exit code 0, 1 (compare), 2 or 3; a failure
// is one printable line on err. It runs in a folder of its own. Arguments with a slash and commands that
// would take minutes are skipped.

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <sstream>
#include <vector>

#include "fdebench/reports/command/command.hpp"
#include "fuzz/fuzzing.hpp"
#include "support/temporary_folder.hpp"

namespace {

using namespace fde;
using namespace fde::bench;
using Words = std::vector<std::string>;

Words lines_of(std::string_view text) {
  Words words;
  while (!text.empty()) {
    const auto end = std::min(text.find('\n'), text.size());
    words.emplace_back(text.substr(0, end));
    words.back().resize(
        std::min(words.back().find('\0'), words.back().size()));  // as arguments of a process end at NUL
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return words;
}

// The text with every number in it reduced to at most `most`.
std::string clamped(const std::string& text, long most) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    long value = 0;
    const auto [end, error] = std::from_chars(text.data() + i, text.data() + text.size(), value);
    const auto length = static_cast<std::size_t>(end - text.data()) - i;
    if (error != std::errc{} || length == 0) {
      result += text[i++];
    } else {
      result += value > most ? std::to_string(value % most + 1) : text.substr(i, length);
      i += length;
    }
  }
  return result;
}

void clamp(Words& words, std::string_view option, long most) {
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (words[i].starts_with(std::string(option) + "=")) words[i] = clamped(words[i], most);
    if (words[i] == option && i + 1 < words.size()) words[i + 1] = clamped(words[i + 1], most);
  }
}

bool names(const Words& words, std::string_view option) {
  return std::ranges::any_of(words, [=](const auto& word) { return word.starts_with(option); });
}

// References that are not closed forms take seconds.
bool is_quick(const Words& words) {
  constexpr std::array slow{"pendulum",  "brusselator", "isokinetic", "nonlinear", "fractional_knife_edge",
                            "vakonomic", "extremum",    "canonical",  "blade",     "multi_term",
                            "two_sided", "hamilton"};
  return std::ranges::none_of(words, [&](const auto& word) {
    return std::ranges::any_of(slow, [&](const auto* name) { return word.find(name) != std::string::npos; });
  });
}

// Limits the command to one that runs in a moment; false if that is not possible.
bool bound(Words& words) {
  if (words.empty()) return true;
  for (const auto& word : words) {
    if (word.find('/') != std::string::npos) return false;
  }
  if (names(words, "--external")) return false;  // runs any command of the shell
  const std::string command = words.front();
  clamp(words, "--steps", 100);
  clamp(words, "--digits", 40);
  clamp(words, "--repeat", 2);
  clamp(words, "--derivative", 8);
  if (command == "exact" || command == "run" || command == "judge" || command == "fit") {
    if (!is_quick(words)) return false;
  }
  if (command == "run" && (!names(words, "--scene") || !names(words, "--scheme") || !names(words, "--steps")))
    return false;
  if (command == "choose" && !names(words, "--results")) return false;
  if (command == "reference" && names(words, "--out")) return false;
  if ((command == "solve" || command == "run") && !names(words, "--budget")) {
    words.emplace_back("--budget");
    words.emplace_back("0.5");
  }
  return words.size() < 20;
}

const TemporaryFolder& room() {
  static const TemporaryFolder folder;
  static const bool made = [] {
    setenv("FDEBENCH_CACHE", "", 1);
    return true;
  }();
  static_cast<void>(made);
  return folder;
}

// Uses a nested folder, so that .. is temporary too.
void prepare_working_folder() {
  const auto here = room().path() / "above" / "here";
  std::filesystem::current_path(room().path());
  std::filesystem::remove_all(room().path() / "above");
  std::filesystem::create_directories(here);
  room().write("above/here/tables/mittag_leffler.csv", "alpha,beta,re_z,re\n1,1,0,1\n");
  room().write("above/here/empty", "");
  std::filesystem::current_path(here);
}

bool is_one_printable_line(std::string_view text) {
  return text.size() > 1 && text.back() == '\n' &&
         std::ranges::none_of(text.substr(0, text.size() - 1),
                              [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; });
}

}  // namespace

FDE_FUZZ_TARGET(command_line) {
  auto words = lines_of({reinterpret_cast<const char*>(data), size});
  if (!bound(words)) return 0;
  prepare_working_folder();
  std::ostringstream out, err;
  const int code = run_fdebench(words, {.out = out, .err = err});
  const auto shown =
      fmt::format("{}\ncode {}\nout: {}\nerr: {}", fmt::join(words, "|"), code, out.str(), err.str());
  const bool is_worse = code == 1 && words.front() == "compare";
  fuzz::require(code == 0 || is_worse || code == 2 || code == 3, "the exit code is 0, 1, 2 or 3", shown);
  if (code == 0) {
    constexpr std::array of_texts{"scenes", "schemes", "help", "completion", "__complete", "-h", "--help"};
    const bool numbers = std::ranges::none_of(
        words, [&](const auto& word) { return std::ranges::find(of_texts, word) != of_texts.end(); });
    fuzz::require(!numbers || !fuzz::contains_nan_or_inf(out.str()), "what is printed is a number", shown);
    return 0;
  }
  fuzz::require(is_one_printable_line(err.str()), "a failure is one printable line", shown);
  // These commands print results before they fail.
  const bool reports = is_worse || (!words.empty() && words.front() == "reference");
  fuzz::require(out.str().empty() || reports, "a failure prints nothing else", shown);
  return 0;
}
