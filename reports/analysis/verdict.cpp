#include "analysis/verdict.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "analysis/text.hpp"
#include "sweep/ending.hpp"

namespace fde {
namespace {

constexpr double surviving = 1e-2;

std::string with_measures(std::string text, const MeasuredRun& run) {
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  if (const auto error = run["error_relative"]) add(fmt::format("{} of the value", error_text(*error)));
  if (const auto from = run["rounding_from"]) add(fmt::format("rounding from t = {:.3g} on", *from));
  if (const auto seconds = run["time_minimum"]) add(time_text(*seconds));
  return text;
}

}  // namespace

Verdict verdict(const MeasuredRun& run) {
  const auto error = run["error_relative"];
  switch (ending_of(run.status)) {
    case Ending::finished:
      if (!error) return Verdict::unknown;
      return *error <= surviving ? Verdict::survives : Verdict::inaccurate;
    case Ending::singular:
      return Verdict::stops;
    case Ending::not_finite:
    case Ending::not_converged:
    case Ending::out_of_budget:
    case Ending::accuracy_lost:
    case Ending::failed:
      return Verdict::fails;
    case Ending::refused:
      return Verdict::refuses;
    case Ending::overflow:
    case Ending::no_reference:
      return Verdict::unknown;
  }
  throw std::logic_error("an ending without a verdict");
}

std::string name(Verdict verdict) {
  switch (verdict) {
    case Verdict::survives:
      return "survives";
    case Verdict::stops:
      return "stops rightly";
    case Verdict::inaccurate:
      return "inaccurate";
    case Verdict::fails:
      return "fails";
    case Verdict::refuses:
      return "refuses";
    case Verdict::unknown:
      return "not judged";
  }
  throw std::logic_error("a verdict without a name");
}

std::string because(const MeasuredRun& run) {
  switch (ending_of(run.status)) {
    case Ending::refused:
      return run.status.substr(words(Ending::refused).size());
    case Ending::finished:
      return with_measures("", run);
    default:
      return with_measures(run.status, run);
  }
}

}  // namespace fde
