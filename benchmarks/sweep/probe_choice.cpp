// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/sweep/probe_choice.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <variant>

namespace fde::bench {
namespace {

// Chooses the probed scenes among variants of one scene.
class VariantProbes {
 public:
  VariantProbes(const std::vector<SceneVariant>& scenes, std::vector<std::size_t> members)
      : scenes_(scenes), members_(std::move(members)) {
    std::map<std::string, std::set<double>> values;
    for (const auto i : members_) {
      for (const auto& [name, value] : scenes_[i].values)
        if (const auto* number = std::get_if<double>(&value)) values[name].insert(*number);
      if (scenes_[i].until) values["until"].insert(*scenes_[i].until);
    }
    for (const auto& [name, of] : values) {
      double rank = 0.0;
      for (const double value : of)
        ranks_[name][value] = of.size() < 2 ? 0.0 : rank++ / static_cast<double>(of.size() - 1);
    }
  }

  void add_to(ProbeChoice& choice) const {
    auto probed = members_;
    std::mt19937_64 engine(1);  // the same choice each time
    for (std::size_t i = 0; i < std::min(most_probed_scenes, probed.size()); ++i)
      std::swap(probed[i], probed[i + engine() % (probed.size() - i)]);
    probed.resize(std::min(most_probed_scenes, probed.size()));
    for (const auto member : members_) {
      const auto nearest = std::ranges::min_element(
          probed, {}, [&](std::size_t other) { return distance(scenes_[member], scenes_[other]); });
      choice.of[member] = choice.probed.size() + static_cast<std::size_t>(nearest - probed.begin());
    }
    choice.probed.insert(choice.probed.end(), probed.begin(), probed.end());
  }

 private:
  // Parameters that are no numbers, or that only one of the scenes has, count as far apart.
  [[nodiscard]] double distance(const SceneVariant& a, const SceneVariant& b) const {
    double sum = 0.0;
    const auto add = [&](const std::string& name, const auto& first, const auto& second) {
      const auto* x = std::get_if<double>(&first);
      const auto* y = std::get_if<double>(&second);
      const bool known = x != nullptr && y != nullptr;
      sum += known ? std::abs(ranks_.at(name).at(*x) - ranks_.at(name).at(*y)) : first == second ? 0.0 : 1.0;
    };
    for (const auto& [name, value] : a.values) {
      const auto other = b.values.find(name);
      if (other != b.values.end()) add(name, value, other->second);
      if (other == b.values.end()) sum += 1.0;
    }
    if (a.until && b.until) add("until", ParameterValue(*a.until), ParameterValue(*b.until));
    return sum;
  }

  const std::vector<SceneVariant>& scenes_;
  std::vector<std::size_t> members_;
  std::map<std::string, std::map<double, double>> ranks_{};
};

}  // namespace

ProbeChoice choose_probes(const std::vector<SceneVariant>& scenes) {
  std::vector<const SceneFactory*> factories;  // in the order of their first scenes
  std::map<const SceneFactory*, std::vector<std::size_t>> variants;
  for (std::size_t i = 0; i < scenes.size(); ++i) {
    auto& members = variants[scenes[i].factory];
    if (members.empty()) factories.push_back(scenes[i].factory);
    members.push_back(i);
  }
  ProbeChoice choice{.of = std::vector<std::size_t>(scenes.size())};
  for (const auto* factory : factories) VariantProbes(scenes, std::move(variants[factory])).add_to(choice);
  return choice;
}

}  // namespace fde::bench
