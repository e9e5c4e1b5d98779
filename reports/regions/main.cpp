// SPDX-License-Identifier: MIT
// Prints reports/page/regions.json, the linear stability regions on the page, one line per scheme.

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string_view>

#include "fdebench/reports/regions/stability_curves.hpp"

int main() try {
  const auto all = fde::bench::page_stability_curves(fde::bench::all_schemes());
  fmt::print("{{\"orders\": {},\n\"same\": {},\n\"curves\": {{\n", all["orders"].dump(), all["same"].dump());
  std::string_view before;
  for (const auto& [id, curves] : all["curves"].items()) {
    fmt::print("{}\"{}\": {}", before, id, curves.dump());
    before = ",\n";
  }
  fmt::print("}}}}\n");
  return 0;
} catch (const std::exception& error) {
  fmt::print(stderr, "fde_page_regions: {}\n", error.what());
  return 1;
}
