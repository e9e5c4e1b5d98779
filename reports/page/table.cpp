// SPDX-License-Identifier: MIT
#include "fdebench/reports/page/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

namespace fde::bench {
namespace {

using nlohmann::json;

bool has_text(const Table& table, std::size_t column) {
  return std::ranges::any_of(table.groups, [=](const RowGroup& group) {
    return std::ranges::any_of(group.rows, [=](const auto& row) { return !row[column].text.empty(); });
  });
}

// A string if the cell has text only; otherwise an object of its nonempty fields, without the text if it
// equals the line's label.
json to_json(const Cell& cell) {
  json shown = json::object();
  if (!cell.detail.empty()) shown["detail"] = cell.detail;
  if (!cell.line.empty()) shown["line"] = cell.line;
  if (cell.highlighted) shown["marked"] = true;
  if (!cell.tooltip.empty()) shown["hint"] = cell.tooltip;
  if (!cell.link.empty()) shown["to"] = cell.link;
  if (!cell.verdict.empty()) shown["tone"] = cell.verdict;
  if (cell.strength > 0.0) shown["strength"] = std::round(1e2 * cell.strength) / 1e2;
  if (cell.runner_up_ratio > 0.0) shown["next"] = std::stod(fmt::format("{:.2g}", cell.runner_up_ratio));
  if (!cell.command.empty()) shown["command"] = cell.command;
  if (cell.session > 0) shown["session"] = cell.session;
  if (shown.empty()) return cell.text;
  if (cell.text != cell.line) shown["text"] = cell.text;
  return shown;
}

}  // namespace

json to_json(const Table& table) {
  std::vector<std::size_t> kept;
  for (std::size_t column = 0; column < table.columns.size(); ++column) {
    if (has_text(table, column)) kept.push_back(column);
  }
  json shown{{"caption", table.caption}, {"columns", json::array()}, {"groups", json::array()}};
  if (table.is_map) shown["map"] = true;
  for (const auto column : kept) {
    const auto& [text, over] = table.columns[column];
    shown["columns"].push_back(over.empty() ? json{{"text", text}} : json{{"text", text}, {"over", over}});
  }
  for (const auto& group : table.groups) {
    json rows = json::array();
    for (const auto& row : group.rows) {
      json cells = json::array();
      for (const auto column : kept) cells.push_back(to_json(row[column]));
      rows.push_back(cells);
    }
    shown["groups"].push_back({{"title", group.title}, {"rows", rows}});
  }
  return shown;
}

}  // namespace fde::bench
