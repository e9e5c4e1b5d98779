#include "records/possible.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "measures/measures.hpp"
#include "scenes/number_text.hpp"
#include "scenes/variant.hpp"
#include "stepping/scheme.hpp"

namespace fde {
namespace {

// Quantities and their units.
struct Quantity {
  std::string_view id, unit;
};

const std::vector<Quantity>& quantities() {
  static const std::vector<Quantity> all = [] {
    std::vector<Quantity> found{{"ending", "t"}};
    for (const auto* measure : measures()) found.push_back({measure->id, measure->unit});
    for (const auto& measure : time_measures()) found.push_back({measure.id, "s"});
    return found;
  }();
  return all;
}

// Digits, rates and growths have a sign; all else is a size, a time or a count.
Range range_of(const Quantity& quantity) {
  const bool has_sign = quantity.unit == "digits" || quantity.id.starts_with("expected_rate") ||
                        quantity.id.ends_with("_growth");
  return has_sign ? any_number : not_negative;
}

void require_in(std::string_view name, double value, const Range& allowed) {
  if (!allowed.contains(value)) reject_text(name, fmt::format("{}", value), allowed.text());
}

void require_quantity(const Record& row) {
  const auto found = std::ranges::find(quantities(), row.quantity, &Quantity::id);
  if (found == quantities().end())
    throw std::invalid_argument(fmt::format("quantity {}: no such quantity", row.quantity));
  if (row.unit != found->unit)
    reject_text("unit", row.unit, fmt::format("\"{}\", that of {}", found->unit, row.quantity));
  require_in(row.quantity, row.value, range_of(*found));
  if (row.ending.has_value() != (row.quantity == "ending"))
    throw std::invalid_argument("ending: must be that of the quantity ending, and of no other");
}

void require_setup(const Record& row) {
  const Setup& setup = row.key.setup;
  if (const auto* accuracy = std::get_if<Accuracy>(&setup.resolution)) {
    require_in("accuracy", accuracy->relative, not_negative);
    require_in("accuracy", accuracy->absolute, not_negative);
  }
  require_in("h", row.h, not_negative);
  require_in("tolerance", setup.tolerance, {.low = 0.0, .high = 1.0});
  if (std::isfinite(setup.budget)) require_in("budget", setup.budget, positive);
}

void require_scene(const SceneSettings& scene, const Scenes& known) {
  const auto& maker = scene_named(scene.id, known);
  [[maybe_unused]] const Parameters possible(maker.id, maker.parameters, scene.values);
  if (scene.until) require_in("until", *scene.until, any_end);
}

// Well-formed UTF-8 (RFC 3629: no overlong forms, surrogates or code points beyond 10FFFF) without control
// characters.
bool prints(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  for (std::size_t i = 0; i < text.size();) {
    const unsigned first = byte(i);
    std::size_t more = 0;
    unsigned low = 0x80, high = 0xbf;  // of the second byte
    if (first >= 0xc2 && first <= 0xdf) more = 1;
    if (first >= 0xe0 && first <= 0xef) more = 2;
    if (first >= 0xf0 && first <= 0xf4) more = 3;
    if (more == 0 && (first < ' ' || first >= 0x7f)) return false;
    if (first == 0xc2 || first == 0xe0) low = 0xa0;  // U+0080 to U+009F are control characters
    if (first == 0xed) high = 0x9f;
    if (first == 0xf0) low = 0x90;
    if (first == 0xf4) high = 0x8f;
    for (std::size_t k = 1; k <= more; ++k) {
      if (byte(i + k) < (k == 1 ? low : 0x80) || byte(i + k) > (k == 1 ? high : 0xbf)) return false;
    }
    i += more + 1;
  }
  return true;
}

}  // namespace

void require_external_name(std::string_view name, std::string_view text) {
  constexpr std::size_t most = 100;
  if (text.empty() || text.size() > most || !prints(text))
    reject_text(name, text, fmt::format("1 to {} bytes of UTF-8 that print", most));
  if (find_scheme(text) != nullptr) reject_text(name, text, "another name than those of our schemes");
}

void PossibleRows::require(const Record& row) {
  if (last_ != row.key.scene) {
    require_scene(row.key.scene, known_);
    last_ = row.key.scene;
  }
  if (row.key.external) {
    require_external_name("scheme", row.key.scheme);
  } else {
    entry_named(schemes(), "scheme", row.key.scheme);
  }
  require_setup(row);
  require_quantity(row);
  if (row.wall_clock && (!row.key.external || !is_time(row)))
    throw std::invalid_argument("wall_clock: must stand in times of other programs only");
}

}  // namespace fde
