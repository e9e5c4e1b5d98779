// SPDX-License-Identifier: MIT
#pragma once

#include <compare>
#include <optional>
#include <string>

#include "fdebench/benchmarks/scenes/parameters.hpp"

namespace fde::bench {

// Identifies a scene in results: its id and the replaced parameters. This build need not have a scene of this
// id.
struct SceneSettings {
  std::string id{};
  ParameterValues values{};
  std::optional<double> until{};  // the end of the time interval
  std::string checksum{};         // of the contents of the equation file at path `id`; empty: compiled in

  auto operator<=>(const SceneSettings&) const = default;
};

// For display: "pendulum", "pendulum:alpha=1.9,until=100"; settings_text is the part after the colon.
std::string label_of(const SceneSettings& scene);
std::string settings_text(const SceneSettings& scene);
// The first eight digits of the checksum, which distinguish files of the same name; empty without a file.
std::string short_checksum(const SceneSettings& scene);

}  // namespace fde::bench
