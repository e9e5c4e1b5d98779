// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/text/entry_named.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace fde::bench {
namespace {

// Levenshtein distance.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substitute = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({substitute, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string did_you_mean(std::string_view name, const std::vector<std::string_view>& candidates) {
  const auto distance = [=](std::string_view candidate) { return edit_distance(name, candidate); };
  const auto best = std::ranges::min_element(candidates, {}, distance);
  return best == candidates.end() ? "" : fmt::format(", did you mean '{}'?", *best);
}

void throw_unknown_id(std::string_view kind, std::string_view id, const std::vector<std::string_view>& ids) {
  constexpr std::size_t few = 10, shown = 3;
  auto listed = ids;
  if (ids.size() > few) {
    std::ranges::stable_sort(listed, {}, [=](std::string_view one) { return edit_distance(id, one); });
    listed.resize(shown);
  }
  throw std::invalid_argument(
      fmt::format("{} {}: no such {}{}; {} {}", kind, id, kind, did_you_mean(id, ids),
                  ids.size() > few ? fmt::format("the nearest of {} are", ids.size()) : "there are",
                  fmt::join(listed, ", ")));
}

}  // namespace fde::bench
