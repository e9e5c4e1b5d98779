// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fdebench/reports/analysis/runs.hpp"

namespace fde::bench {

// One scene of a family.
struct FamilyMember {
  SceneSettings scene{};
  std::vector<double> values{};  // of the family's parameters
  RunSpan runs{};                // finished; empty if none is
};

// Scenes that differ in numeric parameters only: a lattice of them, or random draws.
struct Family {
  SceneSettings scene{};                  // what all have in common
  std::vector<std::string> parameters{};  // those that differ, "until" for the end time
  std::vector<FamilyMember> members{};
};

// As many scenes or more that differ in numeric parameters only are a family; fewer are shown one by one.
inline constexpr std::size_t fewest_scenes = 20;

// Removes the runs of families from `runs`, whose descriptions of scenes stay.
Runs take_families(Runs& runs);

// The families of the runs that take_families() took, described by `described`. `taken` must outlive the
// result. A scene without a value has the default of the parameter.
std::vector<Family> families(const Runs& taken, const Runs& described);

// The part of a family with values of one parameter up to a bound, or from it on, and the shares of it and of
// the rest for which something holds.
struct FamilyPart {
  std::size_t parameter = 0;
  bool from = false;  // the values >= bound, otherwise those <= bound
  double bound = 0.0, inside = 0.0, outside = 0.0;
};

// Where `holds`, an element for each member, is mostly true: the part that maximises
// n_inside n_outside (inside - outside)^2, the criterion of a regression tree's first split (Breiman,
// Friedman, Olshen & Stone, 1984). nullopt if it holds for all or for none.
std::optional<FamilyPart> where_mostly(const Family& family, const std::vector<bool>& holds);

}  // namespace fde::bench
