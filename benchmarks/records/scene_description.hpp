// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fdebench/benchmarks/scenes/parameters.hpp"
#include "fdebench/benchmarks/scenes/scene_facts.hpp"
#include "fdebench/schemes/problem/resolution.hpp"

namespace fde::bench {

// Functions of time: for each name its values, at times that are given elsewhere; nullopt where a value is
// not finite.
struct SampledColumns {
  std::vector<std::string> names{};
  std::vector<std::vector<std::optional<double>>> values{};

  bool operator==(const SampledColumns&) const = default;
};

// The reference solution at times that suffice to draw it.
struct SampledSolution {
  std::vector<double> t{};
  SampledColumns columns{};    // of the scene, the first few
  double bound = 0.0;          // the largest bound of the reference
  SampledColumns energy{};     // without names: none, or constant
  SampledColumns reactions{};  // the multipliers; without names: none, or not known exactly
  SampledColumns motion{};     // two or three coordinates; without values: these are columns of the scene

  bool operator==(const SampledSolution&) const = default;
};

// A parameter of a scene with its value, a number, a word, a list or a formula, as text. `given`: the value
// is not the default.
struct DescribedParameter {
  std::string name, value, meaning;
  bool given = false;

  bool operator==(const DescribedParameter&) const = default;
};

// The runs of a scene that are trials: those with this number of steps or with this tolerance. `kind` is a
// heading, and `number` the place among all trials.
struct TrialRuns {
  int number = 0;
  std::string kind{};
  int steps = 1;
  Tolerance accuracy{};

  bool operator==(const TrialRuns&) const = default;
};

// What a results file says of a scene, so that its runs can be shown without it. Everything but the key may
// be empty.
struct SceneDescription {
  SceneSettings scene{};  // the key
  std::string title{}, source{};
  std::vector<DisplayEquation> equations{};
  std::vector<DescribedParameter> parameters{};
  std::vector<Discontinuity> discontinuities{};
  std::string evidence{};                     // what the reference rests on, as evidence_of
  std::optional<double> reference_seconds{};  // processor time to compute the reference by two methods
  std::optional<TrialRuns> trial{};
  std::optional<SampledSolution> solution{};

  bool operator==(const SceneDescription&) const = default;
};

}  // namespace fde::bench
