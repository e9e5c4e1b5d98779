#pragma once

#include <optional>
#include <string_view>

#include "records/record.hpp"
#include "scenes/registry.hpp"

namespace fde {

// Tells rows that a run can have from those that none has.
class PossibleRows {
 public:
  explicit PossibleRows(const Scenes& known) : known_(known) {}

  // Throws std::invalid_argument naming what is impossible and what is allowed: a scene, a setting of it, a
  // scheme or a quantity that there is not; a unit that is not the quantity's; a value outside what the
  // quantity can be; a setup that no run takes. The scheme of another program has any name but ours.
  void require(const Record& row);

 private:
  const Scenes& known_;
  std::optional<SceneSettings> last_{};  // that was found possible: rows of a scene are neighbours
};

// Throws std::invalid_argument naming the argument where no program may be called so: an id of our schemes,
// nothing, more than 100 bytes, what is not UTF-8 and what does not print.
void require_external_name(std::string_view name, std::string_view text);

}  // namespace fde
