#include "fdebench/benchmarks/measures/ending.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <vector>

namespace fde {
namespace {

struct EndingText {
  Ending ending;
  std::string_view name, words;  // `detail` follows the words
};
constexpr std::array all_words{
    EndingText{Ending::finished, "finished", "finished"},
    EndingText{Ending::non_finite, "not_finite", "not finite"},
    EndingText{Ending::not_converged, "not_converged", "Newton's method did not converge"},
    EndingText{Ending::step_too_large, "outran_growth", "steps are too long for a mode that grows"},
    EndingText{Ending::step_too_small, "step_too_small", "the error test failed down to the smallest step"},
    EndingText{Ending::blow_up, "blow_up", "the solution grows without bound: it blows up"},
    EndingText{Ending::sliding, "sliding", "the solution slides along a switch of its right-hand side"},
    EndingText{Ending::singular, "singular", "ran into the singularity"},
    EndingText{Ending::out_of_budget, "out_of_budget", "out of its budget of time"},
    EndingText{Ending::event, "event", "ended by an event"},
    EndingText{Ending::accuracy_lost, "accuracy_lost", "accuracy lost"},
    EndingText{Ending::overflow, "overflow", "the solution overflows"},
    EndingText{Ending::no_reference, "no_reference", "no reference:"},
    EndingText{Ending::passed_singularity, "passed_singularity", "passed a singularity of the solution:"},
    EndingText{Ending::false_singularity, "false_singularity",
               "unlike the solution, ran into the singularity"},
    EndingText{Ending::program_failed, "program_failed", "the program failed:"},
    EndingText{Ending::refused, "refused", "refused:"}};

const EndingText& words_of(Ending ending) {
  return *std::ranges::find(all_words, ending, &EndingText::ending);
}

}  // namespace

std::string_view name(Ending ending) { return words_of(ending).name; }

std::optional<Ending> ending_named(std::string_view name) {
  const auto* found = std::ranges::find(all_words, name, &EndingText::name);
  return found == all_words.end() ? std::nullopt : std::optional(found->ending);
}

std::string sentence(const RunOutcome& ending) {
  const auto words = words_of(ending.kind).words;
  return ending.detail.empty() ? std::string(words) : fmt::format("{} {}", words, ending.detail);
}

bool is_compared(Ending ending) { return ending == Ending::finished || ending == Ending::accuracy_lost; }

RunOutcome ending_of(const Problem& problem, const Trajectory& path) {
  std::vector<std::string> detail;
  if (path.ending == Ending::singular) detail.push_back(problem.domain.edge);
  if (path.ending == Ending::event) detail.push_back(fmt::format("at t = {:.17g}", path.reached));
  if (path.failure_time) detail.push_back(at_step(path.steps + 1, *path.failure_time));
  if (path.residual) {
    detail.push_back(
        fmt::format("for all times at once, from any of its starts: a residual of {:.2g} is left; "
                    "try another number of steps, another end or other coefficients",
                    *path.residual));
  }
  return {path.ending, fmt::format("{}", fmt::join(detail, " "))};
}

std::string describe(const Problem& problem, const Trajectory& path) {
  return sentence(ending_of(problem, path));
}

std::string at_step(std::int64_t step, double t) { return fmt::format("at step {}, t = {:.6g}", step, t); }

std::string at_time(const std::optional<Grid>& grid, double t) {
  return grid ? at_step(grid->number(t), t) : fmt::format("at t = {:.6g}", t);
}

}  // namespace fde
