// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/sweep/shard.hpp"

#include <cstddef>
#include <map>
#include <utility>

#include "fdebench/benchmarks/text/number_text.hpp"

namespace fde::bench {

Shard parse_shard(std::string_view text) {
  constexpr int most = 10'000;
  const auto slash = text.find('/');
  if (slash == std::string_view::npos) reject_text("--shard", text, "I/N, the I-th of N shards");
  const int count = parse_count("--shard I/N, N", text.substr(slash + 1), 1, most);
  return {.number = parse_count("--shard I/N, I", text.substr(0, slash), 1, count), .count = count};
}

std::vector<Sweep> shard_of(std::vector<Sweep> sweeps, const Shard& shard) {
  std::map<SceneSettings, std::size_t> numbers;  // of the scenes in the order of first appearance
  const auto is_of_another = [&](const SceneVariant& scene) {
    const auto number = numbers.try_emplace(scene.key(), numbers.size()).first->second;
    return number % static_cast<std::size_t>(shard.count) != static_cast<std::size_t>(shard.number) - 1;
  };
  for (auto& sweep : sweeps) {
    std::vector<SceneVariant> ours;
    for (const auto& scene : sweep.scenes) {
      if (!is_of_another(scene)) ours.push_back(scene);
    }
    sweep.scenes = std::move(ours);
  }
  std::erase_if(sweeps, [](const Sweep& sweep) { return sweep.scenes.empty(); });
  return sweeps;
}

}  // namespace fde::bench
