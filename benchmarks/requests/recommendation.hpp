// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/measures/error_kind.hpp"
#include "fdebench/benchmarks/requests/recommended_run.hpp"
#include "fdebench/benchmarks/scenes/parameters.hpp"
#include "fdebench/benchmarks/search/error_estimate.hpp"

namespace fde::bench {

// A scheme without a run within the accuracy: its finest run (with 0 steps where it has none), and why.
struct RejectedScheme {
  RecommendedRun finest{};
  std::string reason{};
  bool refused = false;  // the scheme does not accept the problem
};

// A compared column for which the accuracy allows an error above a tenth of its largest value.
struct SmallColumn {
  std::string name{};
  double largest = 0.0;  // over all compared times
  double allowed = 0.0;  // the error
};

// Those of these columns, with their largest values. A scale that depends on the size of the values has none.
std::vector<SmallColumn> small_columns(const ErrorKind& kind, double accuracy,
                                       const std::vector<std::string>& names,
                                       const std::vector<double>& largest);

// Which scheme to use for a scene and an accuracy, and why.
struct Recommendation {
  SceneSettings scene{};
  ErrorKind kind{};
  double accuracy = 0.0;
  std::vector<std::string> columns{};      // the compared columns; empty: all
  std::vector<SmallColumn> small{};        // for which the accuracy is coarse
  std::vector<RecommendedRun> options{};   // within the accuracy, the quickest first
  std::vector<RecommendedRun> expected{};  // predictions for other schemes, which are slower
  std::vector<RejectedScheme> rejected{};  // the schemes without an option
  std::vector<std::string> missing{};      // without options: the best error, and what would be needed
  bool constant = false;                   // the solution equals its initial value at all times
  std::optional<double>
      reference_bound{};  // at the times at which the quickest run is compared; nullopt: not known here
  bool examined_at_points_only = false;     // the reference; see is_examined_at_points_only
  std::optional<ErrorEstimate> estimate{};  // the basis of all errors; nullopt: there is a reference
};

// The word for its errors: "error" or "estimated error".
std::string_view error_word(const Recommendation& made);

// Other schemes whose time interval overlaps the first option's. Precondition: there is an option.
std::vector<std::string> within_noise(const Recommendation& made);

// The first option of another scheme, otherwise the first expected one; nullptr if there is none.
// Precondition: there is an option.
const RecommendedRun* runner_up(const Recommendation& made);

// A sentence that says how the errors were estimated.
std::string estimate_text(const ErrorEstimate& estimate);

// "maximum over all steps, mixed scale".
std::string kind_text(const ErrorKind& kind);

// How the labels and the command of a text are shown: as they are, unless a terminal has colours.
struct Emphasis {
  using Shown = std::function<std::string(const std::string& text)>;
  Shown label = [](const std::string& text) { return text; };
  Shown command = label;
};

// The recommendation as text: three lines (what to run, what it delivers, how sure that is), a line where the
// accuracy is coarse for a column, then a table of
// the schemes. With `verbose` also why it is quickest, all grids, and the schemes that refuse the problem.
// Precondition: there is an option.
std::string to_text(const Recommendation& made, bool verbose = false, const Emphasis& emphasis = {});

}  // namespace fde::bench
