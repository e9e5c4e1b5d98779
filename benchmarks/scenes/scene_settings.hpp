#pragma once

#include <compare>
#include <optional>
#include <string>

#include "scenes/parameters.hpp"

namespace fde {

// What names a scene in results: its id and what was replaced in it. This build need not know it.
struct SceneSettings {
  std::string id{};
  ParameterValues values{};
  std::optional<double> until{};  // the end of the time interval
  std::string checksum{};         // of what its file says, the id being the path; empty: it is of the code

  auto operator<=>(const SceneSettings&) const = default;
};

// For people: "pendulum", "pendulum:alpha=1.9,until=100"; the part behind the colon.
std::string label_of(const SceneSettings& scene);
std::string settings_text(const SceneSettings& scene);
// Eight digits that tell files of one name apart; empty where the scene is of none.
std::string short_checksum(const SceneSettings& scene);

}  // namespace fde
