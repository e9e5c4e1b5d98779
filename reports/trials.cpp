#include "trials.hpp"

#include <initializer_list>
#include <vector>

#include "arguments.hpp"

namespace fde {
namespace {

std::vector<Trial> all_trials() {
  std::vector<Trial> all;
  const auto add = [&](const std::string& kind, int steps, std::initializer_list<const char*> scenes) {
    for (const auto* scene : scenes) all.push_back({kind, parse_variant(scene), steps});
  };
  add("Stiff", 4096,
      {"relaxation:gamma=0.5,lambda=-100", "relaxation:gamma=0.5,lambda=-10000",
       "relaxation:gamma=0.5,lambda=-1000000", "relaxation:gamma=0.5,lambda=-100000000"});
  add("Extreme orders", 4096,
      {"relaxation:gamma=0.01", "relaxation:gamma=0.99", "relaxation:gamma=0.999", "relaxation:gamma=1.001",
       "relaxation:gamma=1.99", "pendulum:alpha=1.99,beta=0.01"});
  return all;
}

}  // namespace

std::span<const Trial> trials() {
  static const std::vector<Trial> all = all_trials();
  return all;
}

}  // namespace fde
