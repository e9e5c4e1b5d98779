// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "fdebench/reports/analysis/text.hpp"
#include "fdebench/reports/page/page_data.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {
namespace {

constexpr double largest_deviation = 0.1;
constexpr auto at_end = "error at the end", over_all = "maximum error over all steps";

bool deviates(const NormRate& rate) { return std::abs(rate.deviation().value_or(0.0)) > largest_deviation; }

Cell observed(const NormRate& rate) {
  if (rate.fit.points == 0) return {.text = "no fit", .detail = "fewer than three errors above rounding"};
  Cell cell{.text = fmt::format("{:.2f}", rate.fit.slope)};
  if (deviates(rate)) {
    cell.highlighted = true;
    cell.detail = fmt::format("{:.2f} {} theory", std::abs(*rate.deviation()),
                              *rate.deviation() > 0 ? "above" : "below");
  }
  return cell;
}

Cell expected(const NormRate& rate) {
  return {.text = rate.expected ? fmt::format("{:.2f}", *rate.expected) : ""};
}

Cell correlation(const NormRate& rate) {
  return {.text = rate.fit.points > 0 ? fmt::format("{:.4f}", rate.fit.correlation) : ""};
}

std::vector<Cell> row(const PageInput& page, const RateRow& rate) {
  const std::string label = page.label(rate);
  return {{.text = label, .detail = page.grid(rate.setup), .line = label},
          {.text = fmt::format("{} to {}", count_text(rate.coarsest), count_text(rate.finest))},
          expected(rate.end),
          observed(rate.end),
          correlation(rate.end),
          expected(rate.maximum),
          observed(rate.maximum),
          correlation(rate.maximum)};
}

// A text with the number of fits and the number of deviating fits.
std::string summary(const std::vector<RateRow>& rates) {
  std::ptrdiff_t fits = 0, deviating = 0;
  for (const auto norm : {&RateRow::end, &RateRow::maximum}) {
    fits += std::ranges::count_if(rates,
                                  [=](const RateRow& rate) { return (rate.*norm).deviation().has_value(); });
    deviating += std::ranges::count_if(rates, [=](const RateRow& rate) { return deviates(rate.*norm); });
  }
  return fmt::format(
      "Observed rates are least-squares slopes over the finest step counts, five at most; errors at "
      "rounding are left out. {} of {} differ from the theory by more than {}. They are marked: the "
      "fitted range may not be asymptotic, or the scene has what the theory leaves out.",
      deviating, fits, largest_deviation);
}

// Whether the scheme has its rate at the end of this scene, but by theory not in the maximum norm.
bool speaks_of_a_theorem(const RateRow& rate) {
  return rate.end.deviation() && !deviates(rate.end) && *rate.end.expected > 1.0 &&
         rate.maximum.expected.value_or(2.0) <= 1.0;
}

// What the rates imply for the theorem on a scheme, with the scenes that show it; empty if there are none.
std::string on_the_theorem(const Scheme& scheme, const std::vector<RateRow>& rates) {
  std::vector<std::string> scenes;
  for (const RateRow& rate : rates) {
    if (rate.scheme == scheme.id && speaks_of_a_theorem(rate)) scenes.push_back(label_of(rate.scene));
  }
  if (scenes.empty()) return {};
  return fmt::format(
      "At a fixed time t > 0 {} shows {} on {}, although the hypothesis of {}, {}, fails for these scenes. "
      "In the maximum norm over all steps it does not: the error at t₁ is O(h) or worse. A larger slope "
      "there means that the first steps do not dominate the fitted range yet. Rates belong to (scheme, "
      "smoothness, grid, norm).",
      scheme.id, scheme.theorem->rate, fmt::join(scenes, ", "), scheme.theorem->name,
      scheme.theorem->hypothesis);
}

}  // namespace

Section rates_section(const PageInput& page) {
  Section section{.id = "rates",
                  .title = "Observed and theoretical rates",
                  .table = {.caption = "Observed and theoretical rates by scene and scheme",
                            .columns = {{"scheme"},
                                        {"steps"},
                                        {"theory", at_end},
                                        {"observed", at_end},
                                        {"correlation", at_end},
                                        {"theory", over_all},
                                        {"observed", over_all},
                                        {"correlation", over_all}}}};
  for (const Scheme& scheme : schemes()) {
    if (!scheme.theorem) continue;
    if (auto text = on_the_theorem(scheme, page.rates); !text.empty())
      section.paragraphs.push_back(std::move(text));
  }
  section.paragraphs.push_back(summary(page.rates));
  for (const RateRow& rate : page.rates) {
    auto& groups = section.table.groups;
    const std::string title = name_of_scene(rate.scene).title;
    if (groups.empty() || groups.back().title != title) groups.push_back({.title = title});
    groups.back().rows.push_back(row(page, rate));
  }
  return section;
}

}  // namespace fde::bench
