// SPDX-License-Identifier: MIT
#include "fdebench/reports/analysis/families.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <variant>

#include "fdebench/reports/analysis/scene_numbers.hpp"

namespace fde::bench {
namespace {

// What the scenes of a family have in common: all but the numbers, of which they have the same names.
struct Kin {
  SceneSettings scene{};
  std::vector<std::string> names{};

  auto operator<=>(const Kin&) const = default;
};

// A scene by its settings, with its numbers.
using Numbers = std::map<std::string, double>;
using Scenes = std::map<SceneSettings, Numbers>;

std::map<Kin, Scenes> related(const std::set<SceneSettings>& scenes, const Runs& described) {
  std::map<Kin, Scenes> found;
  for (const auto& scene : scenes) {
    Kin kin{.scene = with_defaults(described, scene)};
    const auto numbers = numbers_of(kin.scene);
    for (const auto& [name, value] : numbers) kin.names.push_back(name);
    std::erase_if(kin.scene.values, [](const auto& of) { return std::holds_alternative<double>(of.second); });
    kin.scene.until.reset();
    found[kin].emplace(scene, numbers);
  }
  return found;
}

bool differs(const Scenes& scenes, const std::string& name) {
  return std::ranges::any_of(
      scenes, [&](const auto& of) { return of.second.at(name) != scenes.begin()->second.at(name); });
}

}  // namespace

Runs take_families(Runs& runs) {
  std::set<SceneSettings> wanted;
  for (const auto& [kin, scenes] : related(scenes_of(runs), runs)) {
    if (scenes.size() < fewest_scenes) continue;
    for (const auto& [scene, numbers] : scenes) wanted.insert(scene);
  }
  Runs taken;
  if (wanted.empty()) return taken;
  const auto take = [&](std::vector<Record>& from, std::vector<Record>& to) {
    to = std::exchange(from, {});
    std::erase_if(to, [&](Record& run) {
      if (wanted.contains(run.key.scene)) return false;
      from.push_back(std::move(run));
      return true;
    });
  };
  take(runs.finished, taken.finished);
  take(runs.failed, taken.failed);
  return taken;
}

std::vector<Family> families(const Runs& taken, const Runs& described) {
  std::map<SceneSettings, RunSpan> finished;
  for (const RunSpan scene : by_scene(taken.finished)) finished.emplace(scene.front().key.scene, scene);
  std::vector<Family> found;
  for (const auto& [kin, scenes] : related(scenes_of(taken), described)) {
    Family family{.scene = scenes.begin()->first};
    for (const auto& name : kin.names) {
      if (!differs(scenes, name)) continue;
      family.parameters.push_back(name);
      family.scene = without(std::move(family.scene), name);
    }
    for (const auto& [scene, numbers] : scenes) {
      FamilyMember member{.scene = scene, .runs = finished[scene]};
      for (const auto& name : family.parameters) member.values.push_back(numbers.at(name));
      family.members.push_back(std::move(member));
    }
    found.push_back(std::move(family));
  }
  return found;
}

std::optional<FamilyPart> where_mostly(const Family& family, const std::vector<bool>& holds) {
  const auto all = std::ranges::count(holds, true);
  const auto size = std::ssize(holds);
  std::optional<FamilyPart> best;
  double most = 0.0;
  std::vector<std::size_t> order(holds.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t parameter = 0; parameter < family.parameters.size(); ++parameter) {
    const auto value = [&](std::size_t member) { return family.members[member].values[parameter]; };
    std::ranges::stable_sort(order, {}, value);
    std::ptrdiff_t held = 0;
    for (std::ptrdiff_t below = 1; below < size; ++below) {
      const auto last = order[static_cast<std::size_t>(below - 1)],
                 next = order[static_cast<std::size_t>(below)];
      held += holds[last] ? 1 : 0;
      if (value(last) == value(next)) continue;
      const double low = static_cast<double>(held) / static_cast<double>(below);
      const double high = static_cast<double>(all - held) / static_cast<double>(size - below);
      const bool from = high > low;
      const FamilyPart part{parameter, from, from ? value(next) : value(last), std::max(low, high),
                            std::min(low, high)};
      const double gain = static_cast<double>(below) * static_cast<double>(size - below) *
                          (part.inside - part.outside) * (part.inside - part.outside);
      if (gain <= most) continue;
      most = gain;
      best = part;
    }
  }
  return best;
}

}  // namespace fde::bench
