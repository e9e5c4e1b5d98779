// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/records/run_settings.hpp"

#include <fmt/format.h>

#include "fdebench/benchmarks/text/number_text.hpp"

namespace fde::bench {
namespace {

constexpr std::string_view uniform = "uniform", graded = "graded:";

}  // namespace

Options RunSettings::options() const {
  return {.history = history, .newton_tolerance = newton_tolerance, .budget = budget};
}

Resolution resolution_of(const RunSettings& settings, double end) {
  if (const auto* steps = std::get_if<int>(&settings.resolution))
    return Grid{.end = end, .steps = *steps, .grading = settings.grading};
  return std::get<Tolerance>(settings.resolution);
}

bool same_series(RunSettings a, const RunSettings& b) {
  if (a.resolution.index() != b.resolution.index()) return false;
  a.resolution = b.resolution;
  return a == b;
}

std::string grid_text(double grading) {
  return grading == 1.0 ? std::string(uniform) : fmt::format("{}{}", graded, grading);
}

std::string resolution_text(const RunSettings& settings) {
  if (const auto* steps = std::get_if<int>(&settings.resolution)) return fmt::format("N = {}", *steps);
  const auto& [relative, absolute] = std::get<Tolerance>(settings.resolution);
  return fmt::format("accuracy {}, {}", relative, absolute);
}

double parse_grading(std::string_view text, std::string_view allowed_besides) {
  if (text == uniform) return 1.0;
  if (text.starts_with(graded)) {
    const auto grading = try_parse_number(text.substr(graded.size()));
    if (grading && *grading >= 1.0 && *grading <= 100.0) return *grading;
  }
  reject_text("grid", text, fmt::format("uniform or graded:R with R in [1, 100]{}", allowed_besides));
}

HistoryKind parse_history(std::string_view text) {
  for (const auto kind : {HistoryKind::automatic, HistoryKind::direct, HistoryKind::exponentials}) {
    if (name(kind) == text) return kind;
  }
  reject_text("history", text, "auto, direct or exponentials");
}

}  // namespace fde::bench
