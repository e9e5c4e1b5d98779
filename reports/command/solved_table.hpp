#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "command/asked_run.hpp"
#include "command/command.hpp"

namespace fde {

// What is printed of a run: at all its times, at those asked for, or at its events; or of several solutions.
struct SolvedTable {
  std::vector<std::string> names{};
  std::vector<double> times{};
  std::optional<std::vector<std::string>> events{};  // at these times, where events are printed
  std::optional<std::vector<int>> solutions{};       // of each row, from 1, where all are printed
  std::string ended{};    // by which event and when the run ended before its end; empty: it did not
  Rows values{};          // one row a name, one column a time
  Rows field{};           // the unknowns, one column a time, where they are asked for
  std::string warning{};  // of all that speaks against them; empty: nothing
  std::string cost{};     // one JSON object: time, calls, memory, rate
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
