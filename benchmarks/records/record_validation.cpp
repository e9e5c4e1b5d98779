// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/records/record_validation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/measures/measures.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/benchmarks/text/printable.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {
namespace {

// The quantities of records, with their units and allowed values.
struct Quantity {
  std::string_view id, unit;
  Range range = not_negative;
};

const std::vector<Quantity>& quantities() {
  static const std::vector<Quantity> all = [] {
    std::vector<Quantity> found{{"ending", "t"}};
    for (const auto* measure : measures())
      found.push_back({measure->id, measure->unit, measure->may_be_negative ? any_number : not_negative});
    for (const auto& measure : time_measures()) found.push_back({measure.id, "s"});
    return found;
  }();
  return all;
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
  require_in(row.quantity, row.value, found->range);
  if (row.ending.has_value() != (row.quantity == "ending"))
    throw std::invalid_argument("ending: must be that of the quantity ending, and of no other");
}

void require_setup(const Record& row) {
  const RunSettings& setup = row.key.setup;
  if (const auto* accuracy = std::get_if<Tolerance>(&setup.resolution)) {
    require_in("accuracy", accuracy->rtol, not_negative);
    require_in("accuracy", accuracy->atol, not_negative);
  }
  require_in("h", row.h, not_negative);
  require_in("tolerance", setup.tolerance, {.low = 0.0, .high = 1.0});
  if (std::isfinite(setup.budget)) require_in("budget", setup.budget, positive);
}

// A scene of an equation file, which need not be present: its name, the SHA-256 of its contents, and
// numbers or words.
void require_file(const SceneSettings& scene) {
  constexpr std::size_t digits = 64, most = 4096;
  if (scene.id.empty() || scene.id.size() > most || !is_printable(scene.id))
    reject_text("scene", scene.id, fmt::format("1 to {} bytes of UTF-8 that print", most));
  if (scene.checksum.size() != digits ||
      scene.checksum.find_first_not_of("0123456789abcdef") != std::string::npos)
    reject_text("checksum", scene.checksum, "a SHA-256 in hexadecimal");
  for (const auto& [name, value] : scene.values) {
    const auto* number = std::get_if<double>(&value);
    const auto* word = std::get_if<std::string>(&value);
    const bool is_allowed =
        number != nullptr ? std::isfinite(*number) : word != nullptr && is_printable(*word);
    if (!is_allowed) reject_text(name, to_text(value), any_number.text());
  }
}

void require_scene(const SceneSettings& scene, const SceneRegistry& known) {
  if (scene.checksum.empty()) {
    const auto& maker = entry_by_id(known, "scene", scene.id);
    [[maybe_unused]] const Parameters possible(maker.id, maker.parameters, scene.values);
  } else {
    require_file(scene);
  }
  if (scene.until) require_in("until", *scene.until, valid_end_times);
}

}  // namespace

void require_external_name(std::string_view name, std::string_view text) {
  constexpr std::size_t most = 100;
  if (text.empty() || text.size() > most || !is_printable(text))
    reject_text(name, text, fmt::format("1 to {} bytes of UTF-8 that print", most));
  if (find_scheme(text) != nullptr) reject_text(name, text, "another name than those of our schemes");
}

void RecordValidator::require(const Record& row) {
  if (last_ != row.key.scene) {
    require_scene(row.key.scene, known_);
    last_ = row.key.scene;
  }
  if (row.key.external) {
    require_external_name("scheme", row.key.scheme);
  } else {
    entry_by_id(schemes(), "scheme", row.key.scheme);
  }
  require_setup(row);
  require_quantity(row);
  if (row.wall_clock && (!row.key.external || !is_time(row)))
    throw std::invalid_argument("wall_clock: is allowed in times of other programs only");
}

}  // namespace fde::bench
