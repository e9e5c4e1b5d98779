#include "measures/ending.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <vector>

namespace fde {
namespace {

struct Words {
  Ending ending;
  std::string_view name, words;  // `detail` follows the words
};
constexpr std::array all_words{
    Words{Ending::finished, "finished", "finished"},
    Words{Ending::not_finite, "not_finite", "not finite"},
    Words{Ending::not_converged, "not_converged", "Newton's method did not converge"},
    Words{Ending::outran_growth, "outran_growth", "steps are too long for a mode that grows"},
    Words{Ending::step_too_small, "step_too_small", "the error test failed down to the smallest step"},
    Words{Ending::blow_up, "blow_up", "the solution grows without bound: it blows up"},
    Words{Ending::sliding, "sliding", "the solution slides along a switch of its right-hand side"},
    Words{Ending::singular, "singular", "ran into the singularity"},
    Words{Ending::out_of_budget, "out_of_budget", "out of its budget of time"},
    Words{Ending::event, "event", "ended by an event"},
    Words{Ending::accuracy_lost, "accuracy_lost", "accuracy lost"},
    Words{Ending::overflow, "overflow", "the solution overflows"},
    Words{Ending::no_reference, "no_reference", "no reference:"},
    Words{Ending::passed_singularity, "passed_singularity", "passed a singularity of the solution:"},
    Words{Ending::false_singularity, "false_singularity", "unlike the solution, ran into the singularity"},
    Words{Ending::program_failed, "program_failed", "the program failed:"},
    Words{Ending::refused, "refused", "refused:"}};

const Words& words_of(Ending ending) { return *std::ranges::find(all_words, ending, &Words::ending); }

}  // namespace

std::string_view name(Ending ending) { return words_of(ending).name; }

std::optional<Ending> ending_named(std::string_view name) {
  const auto* found = std::ranges::find(all_words, name, &Words::name);
  return found == all_words.end() ? std::nullopt : std::optional(found->ending);
}

std::string sentence(const RunEnding& ending) {
  const auto words = words_of(ending.kind).words;
  return ending.detail.empty() ? std::string(words) : fmt::format("{} {}", words, ending.detail);
}

bool is_compared(Ending ending) { return ending == Ending::finished || ending == Ending::accuracy_lost; }

RunEnding ending_of(const Problem& problem, const Trajectory& path) {
  std::vector<std::string> detail;
  if (path.ending == Ending::singular) detail.push_back(problem.domain.edge);
  if (path.ending == Ending::event) detail.push_back(fmt::format("at t = {:.17g}", path.reached));
  if (path.failed_at) detail.push_back(at_step(path.steps + 1, *path.failed_at));
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
