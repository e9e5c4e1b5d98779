// SPDX-License-Identifier: MIT
// fde_bits > tests/bits.txt: the results of tests/conformance/bits.hpp, one a line, with numbers as
// hexadecimal fractions. Regenerate the file when a scheme or a scene is added.
// fde_bits FILE prints the distance of this build from a file, sorted by distance.

#include <algorithm>
#include <exception>
#include <stdexcept>
#include <utility>

#include "conformance/bits.hpp"
#include "fdebench/schemes/history/block_kernels.hpp"

namespace {

using namespace fde;
using namespace fde::bench;

void print_distances(const std::vector<FinalValues>& table) {
  std::vector<std::pair<double, std::string>> distances;
  const auto here = final_values();
  if (!std::ranges::equal(here, table, {}, &FinalValues::run, &FinalValues::run))
    throw std::runtime_error("the file has other runs than this build");
  for (std::size_t i = 0; i < here.size(); ++i)
    distances.emplace_back(ulps_between(here[i], table[i].values), here[i].run);
  std::ranges::sort(distances);
  for (const auto& [ulps, run] : distances) {
    if (ulps > 0.0) fmt::print("{} {}\n", run, ulps);
  }
  fmt::print("{} of {} have the same bits\n",
             std::ranges::count(distances, 0.0, &std::pair<double, std::string>::first), distances.size());
}

void print_distances_of_all_targets(const std::string& file) {
  for (const auto target : vector_targets()) {
    select_vector_target(target);
    fmt::print("{}\n", target);
    print_distances(read_final_values(file));
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count > 1) {
    try {
      print_distances_of_all_targets(arguments[1]);
      return 0;
    } catch (const std::exception& failure) {
      fmt::print(stderr, "fde_bits: {}: {}\n", arguments[1], failure.what());
      return 1;
    }
  }
  for (const auto& [run, values, size] : final_values()) {
    fmt::print("{}", run);
    for (const double value : values) fmt::print(" {:a}", value);
    fmt::print("\n");
  }
}
