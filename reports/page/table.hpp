#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace fde {

// One cell as the page shows it.
struct Cell {
  std::string text;
  std::string detail{};     // a second, smaller line
  std::string line{};       // the label of the line whose colour it wears
  bool marked = false;      // set apart: worth a second look
  std::string hint{};       // shown where a pointer rests on it
  std::string to{};         // of a row's heading: the id of the section it leads to, in a map all cells
  std::string tone{};       // a verdict, whose colour it wears in a map
  double strength = 0.0;    // of the colour in a map, of its line or its verdict, 0 to 1
  double next = 0.0;        // of a map's winner: the time of the second line to its own; 0: there is none
  std::string command{};    // options of `fdebench solve` that make its run again
  std::size_t session = 0;  // whose run it is of, from 1 on; 0: of none, or there is one only
};

// Rows under one heading; without a title: no heading.
struct RowGroup {
  std::string title{};
  std::vector<std::vector<Cell>> rows{};  // the first cell of a row is its heading
};

struct Column {
  std::string text;
  std::string over{};  // a heading that neighbouring columns share
};

struct Table {
  std::string caption{};
  std::vector<Column> columns{};
  std::vector<RowGroup> groups{};
  bool is_map = false;  // cells wear the colours of their lines

  [[nodiscard]] bool empty() const { return groups.empty(); }
};

// Without the columns that are empty in every row.
nlohmann::json to_json(const Table& table);

}  // namespace fde
