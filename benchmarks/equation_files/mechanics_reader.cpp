// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/mechanics_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "fdebench/benchmarks/equation_files/toml_text.hpp"
#include "fdebench/benchmarks/mechanics/mechanical_system.hpp"

namespace fde::bench {
namespace {

class MechanicsReader : TomlReader {
 public:
  using TomlReader::TomlReader;

  [[nodiscard]] MechanicsText read(const toml::node& node,
                                   const std::vector<UnknownText>& coordinates) const {
    const auto& of = table(node, "mechanics");
    require_keys(of, "mechanics",
                 {"lagrangian", "forces", "constraints", "principle", "multipliers", "formulation",
                  "initial_velocity"});
    MechanicsText mechanics{.position = position_of(node)};
    mechanics.lagrangian = formula(required(of, mechanics.position, "mechanics", "lagrangian"), "lagrangian");
    if (const auto* forces = of.get("forces")) mechanics.forces = forces_of(*forces, coordinates);
    if (const auto* constraints = of.get("constraints"))
      mechanics.constraints = formulas(*constraints, "constraints");
    if (mechanics.constraints.size() >= coordinates.size() && !mechanics.constraints.empty()) {
      reject(mechanics.constraints.front().position,
             fmt::format("there are {} constraints: must be fewer than the {} coordinates",
                         mechanics.constraints.size(), coordinates.size()));
    }
    if (const auto* principle = of.get("principle"))
      mechanics.is_vakonomic = word(*principle, "principle", {"dalembert", "vakonomic"}) == "vakonomic";
    if (const auto* multipliers = of.get("multipliers"))
      mechanics.multipliers = formulas(*multipliers, "multipliers");
    if (const auto* formulation = of.get("formulation"))
      mechanics.formulation = formulation_of(*formulation, mechanics);
    if (const auto* velocity = of.get("initial_velocity")) {
      mechanics.projects_velocity =
          word(*velocity, "initial_velocity", {"given", "projected"}) == "projected";
      if (mechanics.constraints.empty())
        reject(position_of(*velocity), "initial_velocity: there must be constraints");
    }
    return mechanics;
  }

 private:
  [[nodiscard]] std::vector<NamedFormula> forces_of(const toml::node& node,
                                                    const std::vector<UnknownText>& coordinates) const {
    std::vector<NamedFormula> forces;
    for (const auto& entry : entries(node, "forces")) {
      if (std::ranges::find(coordinates, entry.name, &UnknownText::name) == coordinates.end())
        reject(entry.position, fmt::format("forces {}: must be the name of a coordinate", entry.name));
      forces.push_back({entry.name, entry.position, formula(*entry.node, entry.name)});
    }
    return forces;
  }

  // One of these words.
  [[nodiscard]] std::string word(const toml::node& node, std::string_view name,
                                 const std::vector<std::string>& allowed) const {
    const auto text = node.value_exact<std::string>();
    if (!text) reject_kind(node, name, fmt::format("one of {}", fmt::join(allowed, ", ")));
    if (std::ranges::find(allowed, *text) == allowed.end()) {
      reject(position_of(node),
             fmt::format("{} = {}: must be one of {}", name, *text, fmt::join(allowed, ", ")));
    }
    return *text;
  }

  [[nodiscard]] std::string formulation_of(const toml::node& node, const MechanicsText& mechanics) const {
    std::vector<std::string> names;
    for (const auto formulation : mechanics::all_formulations()) names.push_back(name_of(formulation));
    auto name = word(node, "formulation", names);
    if (mechanics.constraints.empty() || mechanics.is_vakonomic) {
      reject(position_of(node),
             fmt::format("formulation = {}: there must be constraints with principle = dalembert", name));
    }
    return name;
  }
};

}  // namespace

MechanicsText read_mechanics(const std::string& file, std::string_view text, const toml::node& node,
                             const std::vector<UnknownText>& coordinates) {
  return MechanicsReader(file, text).read(node, coordinates);
}

}  // namespace fde::bench
