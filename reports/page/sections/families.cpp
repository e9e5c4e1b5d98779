// SPDX-License-Identifier: MIT
#include "fdebench/reports/analysis/families.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/records/default_accuracies.hpp"
#include "fdebench/reports/analysis/robustness.hpp"
#include "fdebench/reports/page/facts.hpp"

namespace fde::bench {
namespace {

using nlohmann::json;

constexpr double is_typical = 0.95;  // of the scenes

json few(double value) { return chart_number(value, few_digits); }

// A family and what its cells share.
struct Plane {
  const PageInput& page;
  const Family& family;
  std::vector<SceneLines> lines{};  // of each member
  Places labels{}, options{};

  std::size_t label(const RecommendedRun& run) { return labels(page.label(run)); }
  std::size_t label(const std::string& scheme, const RunSettings& settings) {
    return labels(page.names.name(scheme, settings));
  }
};

// Columns with an entry for each member; `of` gives the facts of one.
json columns_of(std::size_t members, const std::function<json(std::size_t)>& of) {
  json columns = json::object();
  for (std::size_t member = 0; member < members; ++member) {
    const json facts = of(member);
    for (const auto& [name, value] : facts.items()) {
      auto& column = columns[name];
      if (column.is_null()) column = json(std::vector<json>(members));
      column[member] = value;
    }
  }
  return columns;
}

// The run that is the first in its cell, with the next line and those within noise.
json cell_facts(Plane& plane, const std::vector<RecommendedRun>& ranked) {
  if (ranked.empty()) return json::object();
  const RecommendedRun& first = ranked.front();
  const auto& [median, low, high, confidence] = first.time;
  json facts{{"line", plane.label(first)}, {"scheme", plane.options(first.schemes.front())},
             {"steps", first.steps},       {"error", few(first.error)},
             {"seconds", few(median)},     {"low", few(low)},
             {"high", few(high)},          {"options", plane.options(options_of(first))}};
  if (plane.page.sessions.size() > 1) facts["session"] = first.session + 1;
  if (first.wall_clock) facts["wall_clock"] = true;
  if (ranked.size() < 2) return facts;
  facts["second"] = plane.label(ranked[1]);
  facts["ratio"] = few(ranked[1].time.median / median);
  json ties = json::array();
  for (const RecommendedRun& other : std::span(ranked).subspan(1))
    if (other.time.low <= high) ties.push_back(plane.label(other));
  if (!ties.empty()) facts["ties"] = ties;
  return facts;
}

// The smallest error of each member, whatever its time.
json best_errors(Plane& plane, const ErrorKind& kind) {
  return columns_of(plane.lines.size(), [&](std::size_t member) {
    const auto missed = plane.lines[member].shortfall(kind, 0.0, {});
    if (!missed) return json::object();
    return json{{"line", plane.label(missed->best)}, {"error", few(missed->best.error)}};
  });
}

// The time of every scheme on every member; a run that several schemes share counts for each of them.
using RankedRuns = std::vector<std::vector<RecommendedRun>>;
TimesOfScenes times_of(Plane& plane, const RankedRuns& ranked) {
  for (const auto& runs : ranked) {
    for (const auto& run : runs)
      for (const auto& scheme : run.schemes) plane.label(scheme, run.settings);
  }
  TimesOfScenes times(ranked.size(), {plane.labels.texts().size(), std::nullopt});
  for (std::size_t member = 0; member < ranked.size(); ++member) {
    for (const auto& run : ranked[member]) {
      for (const auto& scheme : run.schemes) {
        auto& time = times[member][plane.label(scheme, run.settings)];
        if (!time || run.time.median < time->median) time = run.time;
      }
    }
  }
  return times;
}

json estimate_facts(const Estimate& of) {
  return {{"value", fact(of.value)}, {"low", fact(of.low)}, {"high", fact(of.high)}};
}

std::vector<std::string> names_of(const Plane& plane, const std::vector<std::size_t>& lines) {
  std::vector<std::string> names;
  for (const auto line : lines) names.push_back(plane.labels.texts()[line]);
  return names;
}

// Where a line is mostly the cheapest.
json part_facts(const Plane& plane, const RankedRuns& ranked, const std::string& line) {
  std::vector<bool> wins;
  for (const auto& runs : ranked) wins.push_back(!runs.empty() && plane.page.label(runs.front()) == line);
  const auto part = where_mostly(plane.family, wins);
  if (!part) return {};
  return {{"parameter", plane.family.parameters[part->parameter]},
          {"from", part->from},
          {"bound", fact(part->bound)},
          {"inside", fact(part->inside)},
          {"outside", fact(part->outside)}};
}

// How the schemes compare over all members.
json robustness_facts(Plane& plane, const RankedRuns& ranked, double accuracy) {
  const Robustness found = robustness_of(times_of(plane, ranked));
  json facts{{"accuracy", accuracy},
             {"members", ranked.size()},
             {"scenes", found.scenes},
             {"unsolved", found.unsolved},
             {"tied", found.tied}};
  if (found.lines.empty()) return facts;
  const auto& best = found.lines.front();
  facts["best"] = {{"line", plane.labels.texts()[best.line]},
                   {"regret", std::isfinite(best.tail.value) ? estimate_facts(best.tail) : json()},
                   {"solved", best.solved},
                   {"undecided", names_of(plane, found.undecided)}};
  std::map<std::size_t, std::size_t> first;  // cells by the line that is first in them, within noise or not
  for (const auto& runs : ranked) {
    if (!runs.empty()) ++first[plane.label(runs.front())];
  }
  for (const LineRobustness& of : found.lines) {
    const auto& line = plane.labels.texts()[of.line];
    json row{{"line", line},
             {"won", of.won},
             {"solved", of.solved},
             {"scenes", found.scenes},
             {"near", estimate_facts(of.near)},
             {"median", estimate_facts(of.median)},
             {"tail", estimate_facts(of.tail)}};
    if (const auto cells = first[of.line]; cells > 0) {
      row["first"] = cells;
      row["where"] = part_facts(plane, ranked, line);
    }
    facts["rows"].push_back(std::move(row));
  }
  return facts;
}

// The smallest accuracy that some line reaches in most scenes, otherwise that with the most such scenes.
json typical_accuracy(const json& robustness) {
  json best;
  std::size_t most = 0;
  for (const json& at : robustness) {
    const auto scenes = at["scenes"].get<std::size_t>();
    if (scenes > most || static_cast<double>(scenes) >= is_typical * at["members"].get<double>()) {
      best = at["accuracy"];
      most = scenes;
    }
  }
  return best;
}

json plane_facts(Plane& plane) {
  const auto& family = plane.family;
  json facts{{"parameters", family.parameters}};
  for (std::size_t parameter = 0; parameter < family.parameters.size(); ++parameter) {
    json column = json::array();
    for (const auto& member : family.members) column.push_back(fact(member.values[parameter]));
    facts["values"].push_back(std::move(column));
  }
  for (const auto& member : family.members) facts["names"].push_back(label_of(member.scene));
  for (const ErrorKind& kind : error_kinds) {
    const std::string id(error_measure(kind));
    for (const double accuracy : default_accuracies) {
      RankedRuns ranked;
      for (const auto& lines : plane.lines) ranked.push_back(lines.within(kind, accuracy));
      facts["cells"][id].push_back(
          columns_of(ranked.size(), [&](std::size_t member) { return cell_facts(plane, ranked[member]); }));
      facts["robustness"][id].push_back(robustness_facts(plane, ranked, accuracy));
    }
    facts["best"][id] = best_errors(plane, kind);
    facts["typical"][id] = typical_accuracy(facts["robustness"][id]);
  }
  facts["lines"] = plane.labels.texts();
  facts["options"] = plane.options.texts();
  return facts;
}

}  // namespace

json family_sections(const PageInput& page) {
  json sections = json::array();
  for (const Family& family : families(page.families, page.runs)) {
    Plane plane{.page = page, .family = family};
    for (const auto& member : family.members) plane.lines.emplace_back(member.runs);
    const auto& [title, source] = name_of_scene(page, family.scene);
    json section =
        compact({{"id", fmt::format("family-{}{}", label_of(family.scene), short_checksum(family.scene))},
                 {"scene", title},
                 {"name", label_of(family.scene)},
                 {"source", source}});
    section["accuracies"] = default_accuracies;
    section["plane"] = compact(plane_facts(plane));
    sections.push_back(std::move(section));
  }
  return sections;
}

}  // namespace fde::bench
