// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/programs/figures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <exception>
#include <string_view>

namespace {

struct Figure {
  std::string_view name;
  void (*print)(const fde::bench::figures::Words& words);
};

using namespace fde::bench::figures;
constexpr std::array all{Figure{"choices", choices},
                         Figure{"exponentials", exponentials},
                         Figure{"function_times", function_times},
                         Figure{"large", large},
                         Figure{"stability_boundaries", stability_boundaries},
                         Figure{"stability_chain_steps", stability_chain_steps},
                         Figure{"stability_tables", stability_tables},
                         Figure{"two_methods", two_methods},
                         Figure{"weight_floor", weight_floor},
                         Figure{"winners", winners}};

}  // namespace

// Exit codes: 0 done; 1 failed; 2 there is no such figure.
int main(int count, char** arguments) {
  const Words words(arguments + 1, arguments + count);
  const auto* figure = words.empty() ? all.end() : std::ranges::find(all, words[0], &Figure::name);
  if (figure == all.end()) {
    fmt::print(stderr, "fde_figures NAME [WORD]...; names:");
    for (const auto& [name, print] : all) fmt::print(stderr, " {}", name);
    fmt::print(stderr, "\n");
    return 2;
  }
  try {
    figure->print(Words(words.begin() + 1, words.end()));
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "fde_figures {}: {}\n", figure->name, error.what());
    return 1;
  }
}
