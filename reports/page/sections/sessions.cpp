// SPDX-License-Identifier: MIT
#include <algorithm>

#include "fdebench/reports/page/page_data.hpp"

namespace fde::bench {
namespace {

std::vector<Cell> row(std::string name, const std::vector<Session>& sessions,
                      std::string (*text)(const Session&)) {
  std::vector<Cell> cells{{.text = std::move(name)}};
  for (const Session& session : sessions) cells.push_back({.text = text(session)});
  return cells;
}

}  // namespace

Table sessions_table(const PageInput& page) {
  const auto& sessions = page.sessions;
  Table table{.caption = "Where and with what the numbers were made", .columns = {{"session"}}};
  for (std::size_t i = 0; i < sessions.size(); ++i) table.columns.push_back({std::to_string(i + 1)});
  std::vector<std::vector<Cell>> rows{
      row("date", sessions, [](const Session& s) { return s.date; }),
      row("machine", sessions, [](const Session& s) { return s.machine; }),
      row("cores", sessions, [](const Session& s) { return s.cores > 0 ? std::to_string(s.cores) : ""; }),
      row("system", sessions, [](const Session& s) { return s.system; }),
      row("compiler", sessions, [](const Session& s) { return s.compiler; }),
      row("flags", sessions, [](const Session& s) { return s.flags; }),
      row("commit", sessions, [](const Session& s) { return s.commit; }),
      row("version", sessions, [](const Session& s) { return s.version; }),
  };
  std::erase_if(rows, [](const auto& cells) {
    return std::all_of(cells.begin() + 1, cells.end(), [](const Cell& cell) { return cell.text.empty(); });
  });
  table.groups.push_back({.rows = rows});
  return table;
}

}  // namespace fde::bench
