// SPDX-License-Identifier: MIT
#include "fdebench/reports/analysis/trial_result.hpp"

#include <fmt/format.h>

#include "fdebench/reports/analysis/text.hpp"

namespace fde::bench {
namespace {

constexpr double surviving = 1e-2;

std::string with_measures(std::string text, const MeasuredRun& run) {
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  if (const auto error = run["error_relative"]) add(fmt::format("{} of the value", error_text(*error)));
  if (const auto from = run["rounding_from"]) add(fmt::format("rounding from t = {:.3g} on", *from));
  if (const auto seconds = run["time_minimum"])
    add(fmt::format("{}{}", time_text(*seconds), clock_note(run.wall_clock)));
  return text;
}

}  // namespace

TrialResult trial_result(const MeasuredRun& run) {
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

std::string reason_for(const MeasuredRun& run) {
  if (run.ending.kind == SolveStatus::refused) return run.ending.detail;
  return with_measures(run.ending.kind == SolveStatus::finished ? "" : sentence(run.ending), run);
}

}  // namespace fde::bench
