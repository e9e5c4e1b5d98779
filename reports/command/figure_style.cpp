// SPDX-License-Identifier: MIT
#include "fdebench/reports/command/figure_style.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "fdebench/benchmarks/text/range.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {
namespace {

using nlohmann::json;

const Range figure_width{1.0, 40.0};
const Words axis_scales{"log", "linear"};

// What in the panels may have another name: scenes, lines, formulations and columns.
std::set<std::string> names_in(const json& panels) {
  std::set<std::string> names;
  const auto add = [&](const json& some) {
    for (const std::string name : some) names.insert(name);
  };
  for (const auto& panel : panels) {
    names.insert(panel["scene"]);
    add(panel["lines"]);
    names.merge(schemes_in(panel));
    const auto& section = panel["sections"].front();
    if (section.contains("family")) names.insert(section["family"]["parameter"]);
    if (section.contains("measured")) names.insert("residual");
    if (section.contains("drifts")) add(section["drifts"].front()["points"]["formulations"]);
    for (const std::string& column : known_columns(section)) names.insert(column);
  }
  return names;
}

}  // namespace

std::set<std::string> schemes_in(const json& panel) {
  std::set<std::string> names;
  for (const std::string line : panel["lines"]) names.insert(line.substr(0, line.find(',')));
  if (names.empty())
    for (const Scheme& scheme : schemes()) names.emplace(scheme.id);
  return names;
}

std::vector<std::string> known_columns(const json& section) {
  const auto& solution = section.contains("family")     ? section["family"]["members"].front()["solution"]
                         : section.contains("solution") ? section["solution"]
                                                        : section;
  std::vector<std::string> known = solution.value("columns", std::vector<std::string>());
  for (const auto* part : {"energy", "reactions", "motion"}) {
    if (!solution.contains(part) || !solution[part].contains("values")) continue;
    for (const std::string name : solution[part]["columns"]) known.push_back(name);
  }
  return known;
}

std::vector<ArgumentText> style_arguments() {
  return {{"[--width INCHES]", "width of the figure", figure_width, "3.4, of several scenes 7"},
          {"[--x-label TEXT]", "title of the horizontal axis"},
          {"[--y-label TEXT]", "title of the vertical axis"},
          {"[--x-axis SCALE]", "scale of the horizontal axis", axis_scales, "that of the kind"},
          {"[--y-axis SCALE]", "scale of the vertical axis", axis_scales, "that of the kind"},
          {"[--legend PLACE]", "where schemes are named", Words{"labels", "bottom", "right", "none"},
           "labels for up to eight lines, otherwise bottom"},
          {"[--name NAME=TEXT]...", "a text for a line, a column or a scene"}};
}

json style_in(const Given& given) {
  const auto text = [&](const std::string& option) {
    return given.has(option) ? json(given.text(option)) : json();
  };
  const auto word = [&](const std::string& option) {
    return given.has(option) ? json(given.word(option)) : json();
  };
  json axes;
  for (const std::string axis : {"x", "y"})
    axes[axis] = {{"title", text("--" + axis + "-label")}, {"type", word("--" + axis + "-axis")}};
  const double usual = given.all("scene").size() > 1 ? 7.0 : 3.4;
  return {
      {"width", given.find_number("--width").value_or(usual)}, {"legend", word("--legend")}, {"axes", axes}};
}

// A name and its text may both contain "=".
json own_names(const Given& given, const json& panels) {
  json own = json::object();
  if (!given.has("--name")) return own;
  const auto known = names_in(panels);
  for (const std::string& text : given.all("--name")) {
    std::string named;
    for (const std::string& name : known)
      if (text.starts_with(name + "=") && name.size() >= named.size()) named = name;
    if (named.empty() || text.size() == named.size() + 1) {
      reject_text("--name", text, fmt::format("NAME=TEXT with a name of {}", fmt::join(known, "; ")));
    }
    own[named] = text.substr(named.size() + 1);
  }
  return own;
}

}  // namespace fde::bench
