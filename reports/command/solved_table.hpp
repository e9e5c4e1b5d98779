#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "command/arguments.hpp"
#include "command/command.hpp"
#include "scenes/scene.hpp"
#include "stepping/scheme.hpp"

namespace fde {

// What `solve` is told of a run, as texts; --until belongs to the scene.
struct RunArguments {
  std::string scheme;
  std::optional<std::string> steps, accuracy, at, every, points, threads, checkpoint, checkpoint_every;
  MeansArguments means{.budget = "3600"};
  bool check = false;
};

// What is printed of a run: at all its times, or at those asked for.
struct SolvedTable {
  std::vector<std::string> names{};
  std::vector<double> times{};
  Rows values{};                       // one row a name, one column a time
  std::string warning{};               // of all that speaks against them; empty: nothing
  std::string cost{};                  // one JSON object: time, calls, memory, rate
  std::filesystem::path checkpoint{};  // of no use once the table is written; empty: there is none
};

// A run that did not come to its end.
struct RunFailure : NumericalFailure {
  RunFailure(const std::string& message, std::string_view scheme_id, const Trajectory& path)
      : NumericalFailure(message), scheme(scheme_id), step(path.steps + 1), time(path.failed_at) {}
  std::string scheme;
  std::int64_t step;           // without a result
  std::optional<double> time;  // of that step
};

// Solves a scene. A checkpoint that cannot be written is not thrown but said. Throws std::invalid_argument
// naming the argument, the text and what is allowed, RunFailure, and NumericalFailure where a column is not
// finite.
SolvedTable solved_table(const Scene& scene, const RunArguments& arguments,
                         const std::function<void(const std::string&)>& say = {});

}  // namespace fde
