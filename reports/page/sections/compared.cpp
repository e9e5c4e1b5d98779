// SPDX-License-Identifier: MIT
#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>
#include <vector>

#include "fdebench/reports/analysis/comparison.hpp"
#include "fdebench/reports/page/facts.hpp"

namespace fde::bench {
namespace {

using nlohmann::json;

constexpr std::size_t most_rows = 200;  // per kind of change

// The run that changed.
json row(const PageInput& page, const CommonRun& run) {
  const RunKey& key = run.now->key;
  json facts{{"scene", label_of(key.scene)}, {"to", section_of(key.scene)}, {"line", page.label(key)}};
  if (const auto* requested = std::get_if<Tolerance>(&key.settings.resolution)) {
    facts["requested"] = {requested->rtol, requested->atol};
  } else {
    facts["steps"] = run.now->steps;
  }
  return facts;
}

json verdict(const TrialResult& verdict, const Record& run) {
  json facts = ending_facts(run.ending);
  facts["verdict"] = verdict.word;
  return facts;
}

json row(const PageInput& page, const EndingChange& change) {
  json facts = row(page, change.run);
  facts["verdicts"] = {verdict(change.before, *change.run.before), verdict(change.now, *change.run.now)};
  facts["worse"] = change.is_worse();
  return facts;
}

json row(const PageInput& page, const ErrorChange& error) {
  json facts = row(page, error.run);
  facts["errors"] = {fact(error.before), fact(error.now)};
  facts["quantity"] = error.quantity;
  if (error.before > 0.0) facts["factor"] = fact(error.now / error.before);
  facts["worse"] = error.grew();
  return facts;
}

json row(const PageInput& page, const TimeRatio& time) {
  json facts = row(page, time.run);
  facts["times"] = {fact(time.before.median), fact(time.now.median)};
  facts.update({{"ratio", fact(time.ratio)}, {"low", fact(time.low)}, {"high", fact(time.high)}});
  return facts;
}

// Adds the first rows of a kind of change, and how many there are.
template <typename Change>
void add(json& groups, const PageInput& page, const std::string& kind, const std::vector<Change>& changes) {
  if (changes.empty()) return;
  json rows = json::array();
  for (std::size_t i = 0; i < std::min(changes.size(), most_rows); ++i) rows.push_back(row(page, changes[i]));
  groups.push_back({{"change", kind}, {"count", changes.size()}, {"rows", rows}});
}

}  // namespace

json compared_section(const PageInput& page, const Runs& before) {
  const Comparison found = compare(before, page.runs);
  std::vector<TimeRatio> moved;
  std::ranges::copy_if(found.times, std::back_inserter(moved),
                       [](const TimeRatio& time) { return time.slower() || time.faster(); });
  json groups = json::array();
  add(groups, page, "endings", found.endings);
  add(groups, page, "errors", found.errors);
  add(groups, page, "times", moved);
  return {{"id", "compared"},
          {"common", found.common},
          {"only_before", found.only_before},
          {"only_now", found.only_now},
          {"groups", groups}};
}

}  // namespace fde::bench
