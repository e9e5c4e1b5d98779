#include "verdict.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "text.hpp"

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
  if (run.status.starts_with("refused")) return Verdict::refuses;
  if (run.status.find("no reference") != std::string::npos) return Verdict::unknown;
  if (run.status != "finished") return Verdict::fails;
  return run["error_relative"].value_or(0.0) <= surviving ? Verdict::survives : Verdict::inaccurate;
}

std::string name(Verdict verdict) {
  switch (verdict) {
    case Verdict::survives:
      return "survives";
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
  constexpr std::string_view refused = "refused: ";
  if (run.status.starts_with(refused)) return run.status.substr(refused.size());
  return with_measures(run.status == "finished" ? "" : run.status, run);
}

}  // namespace fde
