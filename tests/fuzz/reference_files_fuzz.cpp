// SPDX-License-Identifier: MIT
// Arbitrary bytes as reference data: table, description, index, checksums, a folder of one table, and a file
// of the reference cache. Read, or a one-line error; the cache returns only tables that fit the problem.

#include <stdexcept>

#include "fdebench/benchmarks/reference_data/description.hpp"
#include "fdebench/benchmarks/reference_data/reference_check.hpp"
#include "fdebench/benchmarks/references/cache.hpp"
#include "fdebench/benchmarks/references/checksum.hpp"
#include "fdebench/benchmarks/scenes/registry.hpp"
#include "fdebench/benchmarks/sweep/measured_run.hpp"
#include "fuzz/fuzzing.hpp"
#include "support/temporary_folder.hpp"

namespace {

using namespace fde;
using namespace fde::bench;

const TemporaryFolder& folder() {
  static const TemporaryFolder made;
  return made;
}

void check_table(const std::string& text) {
  folder().write("tables/mittag_leffler.csv", text);
  check_folder(folder().path() / "tables", 4, [](std::size_t, std::size_t, const std::string&) {});
}

// With a valid checksum, so that the parser is reached.
void load_from_cache(const std::string& text) {
  static const Scene scene = make_scene(*find_scene("brusselator"));
  const ReferenceCache cache(folder().path() / "cache");
  const auto name = cache.file_of("key").filename();
  folder().write(std::filesystem::path("cache") / name, sha256(text) + text);
  if (const auto table = cache.load("key", scene.problem)) {
    for (const auto& panel : table->panels.panels) {
      fuzz::require(panel.values.allFinite() && panel.bound.allFinite(), "what is kept is finite");
      fuzz::require(panel.values.cols() == scene.problem.size(), "what is kept has the problem's size");
    }
  }
}

void read(std::size_t kind, const std::string& text) {
  switch (kind) {
    case 0:
      parse_csv("table", text);
      return;
    case 1:
      parse_description("description", text);
      return;
    case 2:
      parse_index("index", text);
      return;
    case 3:
      parse_checksums("checksums", text);
      return;
    case 4:
      return load_from_cache(text);
    default:
      return check_table(text);
  }
}

}  // namespace

FDE_FUZZ_TARGET(reference_files) {
  fuzz::Bytes bytes(data, size);
  const auto kind = bytes.index_below(6);
  try {
    read(kind, std::string(bytes.rest()));
  } catch (const std::invalid_argument& refusal) {
    const std::string_view line = refusal.what();
    fuzz::require(!line.empty() && line.find('\n') == std::string_view::npos, "one line", line);
    fuzz::require(line.find("json.exception") == std::string_view::npos, "a message in our words", line);
  } catch (const std::runtime_error& failure) {
    fuzz::require(kind == 5, "only a recomputed row may have no value", failure.what());
  }
  return 0;
}
