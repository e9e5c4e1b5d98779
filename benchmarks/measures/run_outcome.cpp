// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/measures/run_outcome.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace fde::bench {
namespace {

struct OutcomeText {
  OutcomeKind kind;
  std::string_view name, words;  // `detail` follows the words
};
const std::array all_words{
    OutcomeText{SolveStatus::finished, "finished", "finished"},
    OutcomeText{SolveStatus::non_finite, "not_finite", "not finite"},
    OutcomeText{SolveStatus::not_converged, "not_converged", "Newton's method did not converge"},
    OutcomeText{SolveStatus::undetermined, "undetermined",
                "the values at the end do not determine the missing initial values:"},
    OutcomeText{SolveStatus::step_too_large, "step_too_large", "steps are too long for a mode that grows"},
    OutcomeText{SolveStatus::step_too_small, "step_too_small",
                "the error test failed down to the smallest step"},
    OutcomeText{SolveStatus::blow_up, "blow_up", "the solution grows without bound: it blows up"},
    OutcomeText{SolveStatus::sliding, "sliding", "the solution slides along a switch of its right-hand side"},
    OutcomeText{SolveStatus::left_domain, "singular", "ran into the singularity"},
    OutcomeText{SolveStatus::out_of_budget, "out_of_budget", "out of its budget of time"},
    OutcomeText{SolveStatus::terminal_event, "event", "ended by an event"},
    OutcomeText{Verdict::accuracy_lost, "accuracy_lost", "accuracy lost"},
    OutcomeText{Verdict::overflow, "overflow", "the solution overflows"},
    OutcomeText{Verdict::no_reference, "no_reference", "no reference:"},
    OutcomeText{Verdict::passed_singularity, "passed_singularity", "passed a singularity of the solution:"},
    OutcomeText{Verdict::false_singularity, "false_singularity",
                "unlike the solution, ran into the singularity"},
    OutcomeText{Verdict::program_failed, "program_failed", "the program failed:"},
    OutcomeText{SolveStatus::refused, "refused", "refused:"}};

const OutcomeText& words_of(const OutcomeKind& kind) {
  return *std::ranges::find(all_words, kind, &OutcomeText::kind);
}

// The smallest order, if a row of this order changes by a part of itself up to t that is no rounding error,
// although t is so early that rows of order 1/2 do not.
std::optional<double> order_of_earliest_change(const Problem& problem, double t) {
  constexpr double part = 1e-16;
  const double least = smallest_order(problem);
  const bool is_early = std::sqrt(t / problem.end) < part && std::pow(t / problem.end, least) > part;
  return is_early ? std::optional(least) : std::nullopt;
}

}  // namespace

std::string_view name(const OutcomeKind& kind) {
  return kind.unknown() != nullptr ? std::string_view(*kind.unknown()) : words_of(kind).name;
}

OutcomeKind outcome_named(std::string_view name) {
  const auto* found = std::ranges::find(all_words, name, &OutcomeText::name);
  return found == all_words.end() ? OutcomeKind(std::string(name)) : found->kind;
}

std::string sentence(const RunOutcome& outcome) {
  const auto words = outcome.kind.unknown() != nullptr ? std::string_view(*outcome.kind.unknown())
                                                       : words_of(outcome.kind).words;
  return outcome.detail.empty() ? std::string(words) : fmt::format("{} {}", words, outcome.detail);
}

bool is_compared(const OutcomeKind& kind) {
  return kind == SolveStatus::finished || kind == Verdict::accuracy_lost;
}

RunOutcome outcome_of(const Problem& problem, const Trajectory& path) {
  std::vector<std::string> detail;
  if (path.status == SolveStatus::left_domain) detail.push_back(problem.domain.edge);
  if (path.status == SolveStatus::terminal_event)
    detail.push_back(fmt::format("at t = {:.17g}", path.last_time));
  if (path.failure_time) {
    detail.push_back(at_step(path.steps + 1, *path.failure_time));
    if (const auto order = order_of_earliest_change(problem, *path.failure_time))
      detail.push_back(fmt::format("(a row of order {:.4g} changes as early as that)", *order));
  }
  if (is_solved_by_shooting(problem)) {
    if (path.failure_time && path.status != SolveStatus::out_of_budget)
      detail.emplace_back("with 0 for the missing initial values, from which Newton's method starts");
    if (path.status == SolveStatus::not_converged && path.residual) {
      detail.push_back(
          fmt::format("for the missing initial values: the values at the end are missed by {:.2g}; "
                      "there may be no solution",
                      *path.residual));
    }
    if (path.status == SolveStatus::undetermined)
      detail.emplace_back("with another resolution these change by a large part of the solution");
  } else if (path.residual) {
    detail.push_back(
        fmt::format("for all times at once, from any of its starts: a residual of {:.2g} is left; "
                    "try another number of steps, another end or other coefficients",
                    *path.residual));
  }
  return {path.status, fmt::format("{}", fmt::join(detail, " "))};
}

std::string describe(const Problem& problem, const Trajectory& path) {
  return sentence(outcome_of(problem, path));
}

std::string at_step(std::int64_t step, double t) { return fmt::format("at step {}, t = {:.6g}", step, t); }

std::string at_time(const std::optional<Grid>& grid, double t) {
  return grid ? at_step(grid->nearest_index(t), t) : fmt::format("at t = {:.6g}", t);
}

}  // namespace fde::bench
