// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "fdebench/reports/analysis/text.hpp"
#include "fdebench/reports/page/page_data.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {
namespace {

// The scheme that solves the commensurate expansion of another scheme's chains; nullptr if there is none.
const Scheme* expansion_scheme() {
  const auto found =
      std::ranges::find_if(schemes(), [](const Scheme& scheme) { return !scheme.expansion_of.empty(); });
  return found == schemes().end() ? nullptr : &*found;
}

// Runs of the same scene and steps by the chain and by the expansion.
struct Pair {
  const MeasuredRun *chain, *expansion;
};

const MeasuredRun* find(RunSpan runs, std::string_view scheme, const RunSettings& setup) {
  const auto found = std::ranges::find_if(
      runs, [&](const MeasuredRun& run) { return run.key.scheme == scheme && run.key.setup == setup; });
  return found == runs.end() ? nullptr : &*found;
}

// The pair with the largest common number of steps and equal settings.
std::optional<Pair> finest_pair(const Scheme& expansion, RunSpan scene) {
  std::optional<Pair> finest;
  for (const MeasuredRun& run : scene) {
    if (run.key.scheme != expansion.id || (finest && finest->expansion->steps > run.steps)) continue;
    if (const auto* chain = find(scene, expansion.expansion_of, run.key.setup)) finest = Pair{chain, &run};
  }
  return finest;
}

Cell states(const MeasuredRun& run) {
  const auto count = run["states"];
  return {.text = count ? count_text(*count) : ""};
}

// A time is shown only together with its error.
Cell time_and_error(const MeasuredRun& run) {
  const auto seconds = run["time_minimum"], error = run["error_end"];
  if (!seconds || !error) return {};
  return {.text = time_text(*seconds), .detail = "error " + error_text(*error)};
}

Cell times_as_long(const Pair& pair) {
  const auto chain = (*pair.chain)["time_minimum"], expansion = (*pair.expansion)["time_minimum"];
  return {.text = chain && expansion && *chain > 0.0 ? fmt::format("{:.2f}", *expansion / *chain) : ""};
}

}  // namespace

Section expansion_section(const PageInput& page) {
  const Scheme* expansion = expansion_scheme();
  if (expansion == nullptr) return {};
  Section section{
      .id = "expansion",
      .title = "Decoupled chain or commensurate expansion",
      .paragraphs = {fmt::format(
          "Yin, Liu & Anh 2007 hold that the expansion into equal orders ({}) has too many states, against "
          "their decoupled chain ({}). Measured, at the finest step count that both have:",
          expansion->id, expansion->expansion_of)},
      .table = {.caption = "States and times of the decoupled chain and the commensurate expansion",
                .columns = {{"scene"},
                            {"N"},
                            {"states", "chain"},
                            {"time", "chain"},
                            {"states", "expansion"},
                            {"time", "expansion"},
                            {"time ratio"}}}};
  RowGroup rows;
  for (const RunSpan scene : by_scene(page.runs.finished)) {
    const auto pair = finest_pair(*expansion, scene);
    if (!pair) continue;
    const SceneSettings& solved = scene.front().key.scene;
    rows.rows.push_back({{.text = name_of_scene(solved).title, .detail = label_of(solved)},
                         {.text = count_text(pair->chain->steps)},
                         states(*pair->chain),
                         time_and_error(*pair->chain),
                         states(*pair->expansion),
                         time_and_error(*pair->expansion),
                         times_as_long(*pair)});
  }
  if (!rows.rows.empty()) section.table.groups.push_back(std::move(rows));
  return section;
}

}  // namespace fde::bench
