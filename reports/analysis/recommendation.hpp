#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/option.hpp"
#include "search/estimated_reference.hpp"
#include "search/question.hpp"
#include "search/search.hpp"

namespace fde {

// Which scheme to use for a scene and an accuracy, and why.
struct Recommendation {
  SceneSettings scene{};
  ErrorKind kind{};
  double accuracy = 0.0;
  std::vector<std::string> columns{};  // that count; empty: all
  std::vector<Option> options{};       // within the accuracy, the quickest first
  std::vector<Option> expected{};      // of other schemes, by their errors so far: slower, and not made
  std::vector<std::string> others{};   // a line for each other scheme: what became of it
  bool constant = false;               // the solution is its initial value at all times
  std::optional<Estimate> estimate{};  // by which all errors are estimated; empty: they are known
};

// Of the results of a sweep. Without options `others` say what is missing.
Recommendation recommend(const Runs& runs, const SceneSettings& scene, const ErrorKind& kind,
                         double accuracy);

// Of a search in a scene with these columns, whose errors may be estimated.
Recommendation recommend(const std::vector<SearchedWay>& searched, const SceneSettings& scene,
                         const std::vector<std::string>& columns, const Question& question,
                         const std::optional<Estimate>& estimate = {});

// What its errors are called: "error" or "estimated error".
std::string_view error_word(const Recommendation& made);

// Schemes other than the first option's whose interval of time meets its own.
std::vector<std::string> within_noise(const Recommendation& made);

// The first option of another scheme than the first, or the first that is expected; nullptr: there is none.
const Option* runner_up(const Recommendation& made);

// The options of `fdebench solve` that, behind the scheme's, make the run again; empty for one of another
// program.
std::string options_of(const Option& option);

// The command that makes the run again; empty for one of another program.
std::string command_of(const SceneSettings& scene, const Option& option);

// What estimated errors stand on, as a sentence.
std::string estimate_text(const Estimate& estimate);

// "maximum over all steps, mixed scale".
std::string kind_text(const ErrorKind& kind);

// "l1 = commensurate_l1, graded:2".
std::string name_of(const Option& option);

// All of it as lines for people. Preconditions of both: there is an option.
std::string text_of(const Recommendation& made);

// As one JSON object: docs/command.md lists its fields.
std::string json_of(const Recommendation& made);

}  // namespace fde
