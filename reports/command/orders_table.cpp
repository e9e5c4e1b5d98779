// SPDX-License-Identifier: MIT
#include "fdebench/reports/command/orders_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <variant>

#include "fdebench/benchmarks/text/printable.hpp"
#include "fdebench/reports/analysis/line_names.hpp"

namespace fde::bench {
namespace {

std::vector<ObservedOrders::Row> rows_of(RunSpan line, std::string_view error) {
  std::vector<ObservedOrders::Row> rows;
  for (const Record& run : line) {
    const auto value = run[error];
    if (!value) continue;
    auto& row = rows.emplace_back(ObservedOrders::Row{.steps = run.steps, .h = run.h(), .error = *value});
    if (rows.size() < 2) continue;
    const auto& before = rows[rows.size() - 2];
    constexpr double apart = 1.4;  // steps nearer to each other say little about the order
    if (before.error > 0.0 && row.error > 0.0 && row.steps > apart * before.steps) {
      row.order =
          std::log(before.error / row.error) / std::log(static_cast<double>(row.steps) / before.steps);
    }
  }
  return rows;
}

// As TeX writes it.
std::string tex_number(double value) {
  const std::string text = fmt::format("{:.2e}", value);
  const auto e = text.find('e');
  return fmt::format("${}\\cdot10^{{{}}}$", text.substr(0, e), std::stoi(text.substr(e + 1)));
}

std::string tex_text(const std::string& text) {
  std::string made;
  for (const char c : text) made += c == '_' ? "\\_" : std::string(1, c);
  return made;
}

std::string order_text(const std::optional<double>& order) {
  return order ? fmt::format("${:.2f}$", *order) : "";
}

}  // namespace

ObservedOrders observed_orders(const Runs& runs, const SceneSettings& scene, std::string_view error,
                               std::string_view expected, const std::vector<std::string>& schemes) {
  ObservedOrders made;
  const LineNames names(runs);
  for (const RunSpan line : by_line(of_scene(runs.finished, scene))) {
    const RunKey& key = line.front().key;
    if (std::holds_alternative<Tolerance>(key.settings.resolution)) continue;
    if (!schemes.empty() && std::ranges::find(schemes, key.scheme) == schemes.end()) continue;
    auto rows = rows_of(line, error);
    if (rows.empty()) continue;
    made.lines.push_back({names.name(key.scheme, key.settings), line.back()[expected], std::move(rows)});
  }
  return made;
}

std::string csv_of(const ObservedOrders& orders) {
  std::string text = "scheme,steps,h,error,order,expected\n";
  for (const auto& line : orders.lines) {
    const auto expected = line.expected ? fmt::format("{:.6g}", *line.expected) : "";
    for (const auto& row : line.rows) {
      text += fmt::format("{},{},{},{},{},{}\n", csv_names({line.name}), row.steps, row.h, row.error,
                          row.order ? fmt::format("{:.4f}", *row.order) : "", expected);
    }
  }
  return text;
}

std::string latex_of(const ObservedOrders& orders) {
  std::set<int> steps;
  std::string header = "$N$", expected = "theory";
  for (const auto& line : orders.lines) {
    header += fmt::format(" & \\multicolumn{{2}}{{c}}{{{}}}", tex_text(line.name));
    expected += fmt::format(" & & {}", order_text(line.expected));
    for (const auto& row : line.rows) steps.insert(row.steps);
  }
  std::string text =
      fmt::format("\\begin{{tabular}}{{r*{{{}}}{{lr}}}}\n\\hline\n{} \\\\\n", orders.lines.size(), header);
  for (std::size_t i = 0; i < orders.lines.size(); ++i) text += " & error & order";
  text += " \\\\\n\\hline\n";
  for (const int number : steps) {
    text += fmt::format("{}", number);
    for (const auto& line : orders.lines) {
      const auto row = std::ranges::find(line.rows, number, &ObservedOrders::Row::steps);
      text += row == line.rows.end()
                  ? " & &"
                  : fmt::format(" & {} & {}", tex_number(row->error), order_text(row->order));
    }
    text += " \\\\\n";
  }
  return text + fmt::format("\\hline\n{} \\\\\n\\hline\n\\end{{tabular}}\n", expected);
}

}  // namespace fde::bench
