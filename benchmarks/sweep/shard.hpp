// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include "fdebench/benchmarks/sweep/sweep.hpp"

namespace fde::bench {

// Part `number` (from 1) of `count` parts of a list of sweeps.
struct Shard {
  int number = 1, count = 1;
};

// Parses "2/3". Throws std::invalid_argument naming the text and what is allowed.
Shard parse_shard(std::string_view text);

// The sweeps restricted to the scenes of one shard, without empty sweeps. Scenes are assigned round robin in
// the order of their first appearance; a scene belongs to one shard with all its runs. The shards are
// independent of each other, and their union is all of the sweeps.
std::vector<Sweep> shard_of(std::vector<Sweep> sweeps, const Shard& shard);

}  // namespace fde::bench
