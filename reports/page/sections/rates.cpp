// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "fdebench/reports/page/facts.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {
namespace {

using nlohmann::json;

constexpr double largest_deviation = 0.1;

bool deviates(const NormRate& rate) { return std::abs(rate.deviation().value_or(0.0)) > largest_deviation; }

json rate_facts(const NormRate& rate) {
  json facts{{"expected", fact(rate.expected)}};
  if (rate.fit.points > 0)
    facts.update({{"observed", fact(rate.fit.slope)}, {"correlation", fact(rate.fit.correlation)}});
  if (deviates(rate)) facts[*rate.deviation() > 0 ? "above" : "below"] = fact(std::abs(*rate.deviation()));
  return facts;
}

json row(const PageInput& page, const RateRow& rate) {
  return {{"line", page.label(rate)},
          {"grid", page.grid(rate.settings)},
          {"steps", {rate.coarsest, rate.finest}},
          {"end", rate_facts(rate.end)},
          {"maximum", rate_facts(rate.maximum)}};
}

// Whether the scheme has its rate at the end of this scene, but by theory not in the maximum norm.
bool speaks_of_a_theorem(const RateRow& rate) {
  return rate.end.deviation() && !deviates(rate.end) && *rate.end.expected > 1.0 &&
         rate.maximum.expected.value_or(2.0) <= 1.0;
}

// The theorems on schemes whose hypothesis fails for scenes that show the rate, with these scenes.
json theorems(const std::vector<RateRow>& rates) {
  json all = json::array();
  for (const Scheme& scheme : schemes()) {
    if (!scheme.theorem) continue;
    json scenes = json::array();
    for (const RateRow& rate : rates) {
      if (rate.scheme == scheme.id && speaks_of_a_theorem(rate)) scenes.push_back(label_of(rate.scene));
    }
    if (scenes.empty()) continue;
    all.push_back({{"scheme", scheme.id},
                   {"rate", scheme.theorem->rate},
                   {"scenes", scenes},
                   {"theorem", scheme.theorem->name},
                   {"hypothesis", scheme.theorem->hypothesis}});
  }
  return all;
}

}  // namespace

json rates_section(const PageInput& page) {
  std::ptrdiff_t fits = 0, deviating = 0;
  for (const auto norm : {&RateRow::end, &RateRow::maximum}) {
    fits += std::ranges::count_if(page.rates,
                                  [=](const RateRow& rate) { return (rate.*norm).deviation().has_value(); });
    deviating += std::ranges::count_if(page.rates, [=](const RateRow& rate) { return deviates(rate.*norm); });
  }
  json groups = json::array();
  for (const RateRow& rate : page.rates) {
    const std::string title = name_of_scene(page, rate.scene).title;
    if (groups.empty() || groups.back()["title"] != title) groups.push_back({{"title", title}});
    groups.back()["rows"].push_back(row(page, rate));
  }
  return {{"id", "rates"},
          {"fits", fits},
          {"deviating", deviating},
          {"largest_deviation", largest_deviation},
          {"theorems", theorems(page.rates)},
          {"groups", groups}};
}

}  // namespace fde::bench
