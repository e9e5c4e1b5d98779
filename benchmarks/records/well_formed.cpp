// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/records/well_formed.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string>
#include <variant>

#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/benchmarks/text/printable.hpp"

namespace fde::bench {
namespace {

void require_setting(const std::string& name, const ParameterValue& value) {
  require_name("settings", name);
  if (const auto* word = std::get_if<std::string>(&value)) return require_printable(name, *word);
  const auto* number = std::get_if<double>(&value);
  const auto numbers = number != nullptr ? std::vector{*number} : std::get<std::vector<double>>(value);
  for (const double one : numbers) require_in(name, one, any_number);
}

}  // namespace

void require_printable(std::string_view field, std::string_view text) {
  if (!is_printable(text)) reject_text(field, text, "UTF-8 that prints");
}

void require_name(std::string_view field, std::string_view text, std::size_t most) {
  if (text.empty() || text.size() > most || !is_printable(text))
    reject_text(field, text, fmt::format("1 to {} bytes of UTF-8 that print", most));
}

void require_times(std::string_view field, const std::vector<double>& times) {
  for (const double t : times) require_in(field, t, not_negative);
  if (std::ranges::adjacent_find(times, std::ranges::greater_equal{}) != times.end())
    throw std::invalid_argument(fmt::format("{}: its times must increase", field));
}

void require_length(std::string_view field, std::size_t length, std::size_t times) {
  if (length != times)
    throw std::invalid_argument(fmt::format("{}: has {} values at {} times", field, length, times));
}

void require_scene(const SceneSettings& scene) {
  constexpr std::size_t digits = 64, longest = 4096;
  require_name("scene", scene.id, longest);
  const bool is_hexadecimal = scene.checksum.find_first_not_of("0123456789abcdef") == std::string::npos;
  if (!scene.checksum.empty() && (scene.checksum.size() != digits || !is_hexadecimal))
    reject_text("checksum", scene.checksum, "a SHA-256 in hexadecimal");
  for (const auto& [name, value] : scene.values) require_setting(name, value);
  if (scene.until) require_in("until", *scene.until, valid_end_times);
}

}  // namespace fde::bench
