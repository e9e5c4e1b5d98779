// SPDX-License-Identifier: MIT
#pragma once

#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "support/command_output.hpp"

namespace fde::bench {

// Runs a command given as words separated by blanks.
inline CommandOutput fdebench(const std::string& words) {
  std::istringstream stream(words);
  return fdebench(std::vector<std::string>(std::istream_iterator<std::string>(stream), {}));
}

// The numbers of a CSV text, without its header line.
inline std::vector<std::vector<double>> csv_rows(const std::string& csv) {
  std::vector<std::vector<double>> result;
  std::istringstream lines(csv);
  std::string line, cell;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    std::istringstream cells(line);
    result.emplace_back();
    while (std::getline(cells, cell, ',')) result.back().push_back(std::stod(cell));
  }
  return result;
}

}  // namespace fde::bench
