#pragma once

#include <string_view>
#include <vector>

#include "sweep/sweep.hpp"

namespace fde {

// One of `count` parts of sweeps, from 1 on.
struct Shard {
  int number = 1, count = 1;
};

// "2/3". Throws std::invalid_argument naming the text and what is allowed.
Shard parse_shard(std::string_view text);

// The sweeps with the scenes of one shard, those without any left out. Scenes are dealt one after the other,
// in the order in which they first stand in the sweeps; a scene goes to one shard with all its runs. So the
// shards depend on nothing of each other, and are all of the sweeps together.
std::vector<Sweep> shard_of(std::vector<Sweep> sweeps, const Shard& shard);

}  // namespace fde
