// SPDX-License-Identifier: MIT
#include "fdebench/reports/command/topics.hpp"

#include <array>

// The symbols of assets.S for each topic: its first byte, and one past its last.
#define FDE_TOPIC(id, name) extern "C" const char fde_asset_topic_##id[], fde_asset_topic_##id##_end[];
#include "fdebench/reports/command/topics.def"
#undef FDE_TOPIC

namespace fde::bench {
namespace {

Topic topic_of(std::string_view name, std::string_view file) {
  const auto end = file.find('\n');
  return {name, file.substr(0, end), file.substr(file.find_first_not_of('\n', end))};
}

}  // namespace

std::span<const Topic> topics() {
  static const std::array all{
#define FDE_TOPIC(id, name) topic_of(name, {fde_asset_topic_##id, fde_asset_topic_##id##_end}),
#include "fdebench/reports/command/topics.def"
#undef FDE_TOPIC
  };
  return all;
}

}  // namespace fde::bench
