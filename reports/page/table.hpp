// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace fde::bench {

// One cell of a table on the page.
struct Cell {
  std::string text;
  std::string detail{};  // a second, smaller line
  std::string line{};    // label of the line whose colour the cell has
  bool highlighted = false;
  std::string tooltip{};
  std::string link{};     // id of the section that the cell links to: in row headings, in a map all cells
  std::string verdict{};  // verdict whose colour the cell has in a map
  double strength = 0.0;  // of the colour in a map, in [0, 1]
  // In a map: time of the second line / time of the winner; 0: there is no second.
  double runner_up_ratio = 0.0;
  std::string command{};    // options of `fdebench solve` that repeat the run
  std::size_t session = 0;  // number of the run's session, from 1; 0: no run, or a single session
};

// Rows under one heading; an empty title gives no heading.
struct RowGroup {
  std::string title{};
  std::vector<std::vector<Cell>> rows{};  // the first cell of a row is its heading
};

struct Column {
  std::string text;
  std::string group{};  // a heading common to adjacent columns
};

struct Table {
  std::string caption{};
  std::vector<Column> columns{};
  std::vector<RowGroup> groups{};
  bool is_map = false;  // cells have the colours of their lines

  [[nodiscard]] bool empty() const { return groups.empty(); }
};

// The table without columns that are empty in every row.
nlohmann::json to_json(const Table& table);

}  // namespace fde::bench
