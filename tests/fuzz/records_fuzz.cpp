// SPDX-License-Identifier: MIT
// Arbitrary bytes as a results file: read, or a one-line error; the page and the recommendation from it
// contain no nan or inf, and the file can be appended to.

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "fdebench/benchmarks/records/results_file.hpp"
#include "fdebench/benchmarks/requests/answers_json.hpp"
#include "fdebench/reports/analysis/recorded_recommendation.hpp"
#include "fdebench/reports/page/page_data.hpp"
#include "fuzz/fuzzing.hpp"
#include "support/temporary_folder.hpp"

namespace {

using namespace fde;
using namespace fde::bench;

// Absent values of a run are null in their column; a value that is not finite would be written as null too.
bool all_finite(const nlohmann::json& value) {
  if (value.is_number_float()) return std::isfinite(value.get<double>());
  return !value.is_structured() || std::ranges::all_of(value, all_finite);
}

void show(const Results& results) {
  const auto data = page_data(read_runs(results));
  const std::string page = data.dump();
  fuzz::require(!fuzz::contains_nan_or_inf(page), "numbers on the page", page);
  fuzz::require(all_finite(data), "numbers of the charts are finite", page);
  if (results.records.empty()) return;
  for (const double accuracy : {1e-3, 1e-12}) {
    for (const ErrorKind& kind : error_kinds) {
      const auto made = recommend(runs_of(results), results.records.front().key.scene, kind, accuracy);
      for (const auto& text : made.missing)
        fuzz::require(!fuzz::contains_nan_or_inf(text), "numbers of what is missing", text);
      if (made.options.empty()) continue;
      const std::string text = to_text(made) + json_of(made).dump();
      fuzz::require(!fuzz::contains_nan_or_inf(text), "numbers of the recommendation", text);
    }
  }
}

}  // namespace

FDE_FUZZ_TARGET(records) {
  static const TemporaryFolder folder;
  static const auto file = folder.path() / "results.jsonl";
  std::ofstream(file, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
  Results results;
  try {
    results = read_results(file);
  } catch (const std::invalid_argument& refusal) {
    fuzz::require(std::string_view(refusal.what()).starts_with(file.string()), "the file is named",
                  refusal.what());
    return 0;
  }
  show(results);
  const auto count = results.records.size();
  ResultsFile(file).append(Record{.key = {.scene = {"power"}, .scheme = "l1", .settings = {1}}, .steps = 1});
  fuzz::require(read_results(file).records.size() == count + 1, "a file that was read can be continued");
  return 0;
}
