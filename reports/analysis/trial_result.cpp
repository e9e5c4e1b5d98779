// SPDX-License-Identifier: MIT
#include "fdebench/reports/analysis/trial_result.hpp"

namespace fde::bench {
namespace {

constexpr double surviving = 1e-2;

}  // namespace

TrialResult trial_result(const Record& run) {
  const OutcomeKind& kind = run.ending.kind;
  if (kind == SolveStatus::finished) {
    const auto error = run["error_relative"];
    if (!error) return not_judged;
    return *error <= surviving ? survives : inaccurate;
  }
  if (kind == SolveStatus::left_domain) return stops;
  if (kind == SolveStatus::refused) return refuses;
  const bool cannot_be_judged =
      kind == SolveStatus::terminal_event || kind == Verdict::overflow || kind == Verdict::no_reference;
  return cannot_be_judged ? not_judged : fails;
}

}  // namespace fde::bench
