// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/text/entry_named.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace fde::bench {
namespace {

std::string lower(std::string_view text) {
  std::string result(text);
  std::ranges::transform(result, result.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

// Number of insertions, deletions, replacements and exchanges of neighbours, capitals and small letters being
// equal (optimal string alignment).
std::size_t edit_distance(std::string_view one, std::string_view other) {
  const std::string a = lower(one), b = lower(other);
  std::vector<std::size_t> before, above(b.size() + 1), row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before = std::exchange(above, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1), above[j] + 1, row[j - 1] + 1});
      const bool are_exchanged = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (are_exchanged) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row.back();
}

// Whether `name` may be a slip of the pen for the candidate: a third of its characters differ at most, or one
// is the beginning of the other.
bool is_near(std::string_view name, std::string_view candidate) {
  const std::string a = lower(name), b = lower(candidate);
  const bool is_beginning = std::min(a.size(), b.size()) > 1 && (a.starts_with(b) || b.starts_with(a));
  return is_beginning || 3 * edit_distance(a, b) <= std::max(a.size(), b.size());
}

}  // namespace

std::string did_you_mean(std::string_view name, const std::vector<std::string_view>& candidates) {
  auto near = candidates;
  std::erase_if(near, [=](std::string_view candidate) { return !is_near(name, candidate); });
  const auto distance = [=](std::string_view candidate) { return edit_distance(name, candidate); };
  const auto best = std::ranges::min_element(near, {}, distance);
  return best == near.end() ? "" : fmt::format(", did you mean '{}'?", *best);
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
