// SPDX-License-Identifier: MIT
#include <algorithm>
#include <nlohmann/json.hpp>

#include "fdebench/reports/page/facts.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {
namespace {

using nlohmann::json;

// The scheme that solves the commensurate expansion of another scheme's chains; nullptr if there is none.
const Scheme* expansion_scheme() {
  const auto found =
      std::ranges::find_if(schemes(), [](const Scheme& scheme) { return !scheme.expansion_of.empty(); });
  return found == schemes().end() ? nullptr : &*found;
}

// Runs of the same scene and steps by the chain and by the expansion.
struct Pair {
  const Record *chain, *expansion;
};

const Record* find(RunSpan runs, std::string_view scheme, const RunSettings& settings) {
  const auto found = std::ranges::find_if(
      runs, [&](const Record& run) { return run.key.scheme == scheme && run.key.settings == settings; });
  return found == runs.end() ? nullptr : &*found;
}

// The pair with the largest common number of steps and equal settings.
std::optional<Pair> finest_pair(const Scheme& expansion, RunSpan scene) {
  std::optional<Pair> finest;
  for (const Record& run : scene) {
    if (run.key.scheme != expansion.id || (finest && finest->expansion->steps > run.steps)) continue;
    if (const auto* chain = find(scene, expansion.expansion_of, run.key.settings)) finest = Pair{chain, &run};
  }
  return finest;
}

json ratio(const Pair& pair) {
  const auto chain = (*pair.chain)["time_minimum"], expansion = (*pair.expansion)["time_minimum"];
  return chain && expansion && *chain > 0.0 ? fact(*expansion / *chain) : json();
}

}  // namespace

json expansion_section(const PageInput& page) {
  const Scheme* expansion = expansion_scheme();
  if (expansion == nullptr) return {};
  json rows = json::array();
  for (const RunSpan scene : by_scene(page.runs.finished)) {
    const auto pair = finest_pair(*expansion, scene);
    if (!pair) continue;
    const SceneSettings& solved = scene.front().key.scene;
    const auto facts = [&](const Record& run) {
      return run_facts(page, run, {"states", "time_minimum", "error_end"});
    };
    rows.push_back({{"title", name_of_scene(page, solved).title},
                    {"name", label_of(solved)},
                    {"steps", pair->chain->steps},
                    {"chain", facts(*pair->chain)},
                    {"expansion", facts(*pair->expansion)},
                    {"ratio", ratio(*pair)}});
  }
  return {{"id", "expansion"},
          {"chain", expansion->expansion_of},
          {"expansion", expansion->id},
          {"groups", json::array({{{"rows", rows}}})}};
}

}  // namespace fde::bench
