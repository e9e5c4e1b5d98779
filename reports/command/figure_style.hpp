// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>
#include <vector>

#include "fdebench/reports/command/given.hpp"

namespace fde::bench {

// What of a figure is its author's: the arguments of `plot` for it, and their values as reports/plot/ takes
// them. A panel is the page's data of one scene, {"scene": its text, "lines": ..., "sections": [one]}.

std::vector<ArgumentText> style_arguments();

// {"width": inches, "legend": null or a place,
// "axes": {"x": {"title": null or a text, "type": null, "log" or "linear"}, "y": ...}}.
nlohmann::json style_in(const Given& given);

// The texts of --name: {NAME: text}. Throws std::invalid_argument if one names nothing in the panels.
nlohmann::json own_names(const Given& given, const nlohmann::json& panels);

// The schemes of a panel's lines, such as "l1, graded:2", external ones included; without lines the schemes
// of this build.
std::set<std::string> schemes_in(const nlohmann::json& panel);

// The columns that are known of the solution of a section over time.
std::vector<std::string> known_columns(const nlohmann::json& section);

}  // namespace fde::bench
