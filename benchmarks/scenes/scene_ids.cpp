// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/scene_ids.hpp"

#include <array>

namespace fde::bench {
namespace {

constexpr std::array ids{
#define FDE_SCENE(id) std::string_view(#id),
#include "fdebench/benchmarks/scenes/list.def"
#undef FDE_SCENE
};

}  // namespace

std::span<const std::string_view> scene_ids() { return ids; }

}  // namespace fde::bench
