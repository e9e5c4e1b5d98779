#include "page/report.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "page/assets.hpp"
#include "page/page_data.hpp"

namespace fde {
namespace {

namespace fs = std::filesystem;

std::string replaced(std::string_view text, const std::map<char, std::string_view>& replacements) {
  std::string result;
  for (const char c : text) {
    const auto found = replacements.find(c);
    if (found == replacements.end()) {
      result += c;
    } else {
      result += found->second;
    }
  }
  return result;
}

std::string as_html(std::string_view text) {
  return replaced(text, {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}});
}

// JSON within a script element: "<" occurs in strings only, and escaped it can neither end the element nor
// open a comment.
std::string as_script_data(const nlohmann::json& data) { return replaced(data.dump(), {{'<', "\\u003c"}}); }

// The template with each {{name}} replaced by its part, in one pass: what a part holds is not looked at.
std::string fill(std::string_view page, const std::map<std::string_view, std::string_view>& parts) {
  std::string filled;
  while (true) {
    const auto open = page.find("{{");
    filled += page.substr(0, open);
    if (open == std::string_view::npos) return filled;
    const auto close = page.find("}}", open);
    filled += parts.at(page.substr(open + 2, close - open - 2));
    page.remove_prefix(close + 2);
  }
}

[[noreturn]] void reject(const fs::path& path, const std::string& reason) {
  throw std::invalid_argument(fmt::format("{}: cannot be written: {}", path.string(), reason));
}

void write(const fs::path& path, std::string_view text) {
  std::ofstream file(path, std::ios::binary);
  file.write(text.data(), static_cast<std::streamsize>(text.size()));
  file.close();
  if (!file) reject(path, std::generic_category().message(errno));
}

// Under another name first: the rename is the moment at which the page changes.
void replace_file(const fs::path& path, std::string_view text) {
  fs::path temporary = path;
  temporary += fmt::format(".{}.tmp", getpid());
  std::error_code problem;
  try {
    write(temporary, text);
    fs::rename(temporary, path, problem);
    if (problem) reject(path, problem.message());
  } catch (...) {
    fs::remove(temporary, problem);
    throw;
  }
}

}  // namespace

fs::path write_report(const Results& results, const fs::path& directory) {
  return write_report(ReadRuns{results.sessions, runs_of(results)}, directory);
}

fs::path write_report(ReadRuns read, const fs::path& directory) {
  if (assets::vega().empty()) {
    throw std::invalid_argument(
        "report: this build has no charts; run ./setup.sh, then configure and build again");
  }
  std::error_code problem;
  fs::create_directories(directory, problem);
  if (problem) reject(directory, problem.message());
  const std::string data = as_script_data(page_data({.sessions = read.sessions}, std::move(read.runs))),
                    licences = as_html(assets::licences());
  fs::path path = directory / "index.html";
  replace_file(path, fill(assets::page(), {{"style", assets::style()},
                                           {"data", data},
                                           {"vega", assets::vega()},
                                           {"script", assets::script()},
                                           {"licences", licences}}));
  return path;
}

}  // namespace fde
