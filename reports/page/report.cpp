// SPDX-License-Identifier: MIT
#include "fdebench/reports/page/report.hpp"

#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "fdebench/benchmarks/files/atomic_file.hpp"
#include "fdebench/benchmarks/text/output_text.hpp"
#include "fdebench/reports/page/assets.hpp"
#include "fdebench/reports/page/packed.hpp"
#include "fdebench/reports/page/page_data.hpp"

namespace fde::bench {
namespace {

namespace fs = std::filesystem;

// Replaces each {{name}} of the template by its part, in one pass: placeholders inside a part are not
// replaced.
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

}  // namespace

fs::path write_report(ReadRuns read, const fs::path& directory, const std::optional<ReadRuns>& before) {
  if (assets::vega().empty()) {
    throw std::invalid_argument(
        "report: this build has no charts; run ./setup.sh, then configure and build again");
  }
  std::error_code problem;
  fs::create_directories(directory, problem);
  if (problem) {
    throw std::invalid_argument(
        fmt::format("{}: cannot be written: {}", directory.string(), problem.message()));
  }
  const std::string data = packed(page_data(std::move(read), before).dump()), vega = packed(assets::vega()),
                    licences = replaced(assets::licences(), {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}});
  fs::path path = directory / "index.html";
  AtomicFile file(path);
  file.write(fill(assets::page(), {{"style", assets::style()},
                                   {"data", data},
                                   {"vega", vega},
                                   {"charts", assets::charts()},
                                   {"script", assets::script()},
                                   {"licences", licences}}));
  file.commit();
  return path;
}

}  // namespace fde::bench
