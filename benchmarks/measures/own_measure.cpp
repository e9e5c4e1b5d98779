// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/measures/own_measure.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <string_view>

#include "fdebench/benchmarks/measures/measures.hpp"
#include "fdebench/benchmarks/text/refusal.hpp"

namespace fde::bench {

void require_own_measures(const std::vector<OwnMeasure>& own) {
  std::set<std::string_view> ids;
  for (const auto* measure : measures()) ids.insert(measure->id);
  for (const auto& measure : time_measures()) ids.insert(measure.id);
  const auto is_of_word = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  for (const auto& measure : own) {
    if (measure.id.empty() || !std::ranges::all_of(measure.id, is_of_word) || !ids.insert(measure.id).second)
      refuse_value("measures", measure.id, {"a word of letters, digits and _ that no other measure has"});
  }
}

}  // namespace fde::bench
