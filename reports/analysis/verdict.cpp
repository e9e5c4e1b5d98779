#include "fdebench/reports/analysis/verdict.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "fdebench/reports/analysis/text.hpp"

namespace fde {
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

Verdict verdict(const MeasuredRun& run) {
  const auto error = run["error_relative"];
  switch (run.ending.kind) {
    case Ending::finished:
      if (!error) return not_judged;
      return *error <= surviving ? survives : inaccurate;
    case Ending::singular:
      return stops;
    case Ending::non_finite:
    case Ending::not_converged:
    case Ending::step_too_large:
    case Ending::step_too_small:
    case Ending::blow_up:
    case Ending::sliding:
    case Ending::out_of_budget:
    case Ending::accuracy_lost:
    case Ending::passed_singularity:
    case Ending::false_singularity:
    case Ending::program_failed:
      return fails;
    case Ending::refused:
      return refuses;
    case Ending::overflow:
    case Ending::no_reference:
    case Ending::event:
      return not_judged;
  }
  throw std::logic_error("an ending without a verdict");
}

std::string because(const MeasuredRun& run) {
  switch (run.ending.kind) {
    case Ending::refused:
      return run.ending.detail;
    case Ending::finished:
      return with_measures("", run);
    default:
      return with_measures(sentence(run.ending), run);
  }
}

}  // namespace fde
