// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "fdebench/schemes/stepping/trajectory.hpp"

namespace fde::bench {

// A measure of the caller, as a value: what it gives for a finished run is recorded beside our measures under
// its id, a word that none of ours has. values and reference have one row a column of the scene and one
// column a time; reference has no columns where there is none. nullopt: it does not apply. A number that is
// not finite ends the run as one of ours does. Several threads of a sweep may call it at the same time.
struct OwnMeasure {
  using Value = std::function<std::optional<double>(const std::vector<double>& times, const Rows& values,
                                                    const Rows& reference)>;
  std::string id;
  Value value;
};

// Throws Refusal naming `measures` unless each id is a word that no other measure has.
void require_own_measures(const std::vector<OwnMeasure>& own);

}  // namespace fde::bench
