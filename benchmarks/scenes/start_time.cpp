// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/start_time.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "fdebench/reference/special_functions/numbers/rational.hpp"

namespace fde::bench {

double end_time(const Scene& scene) { return from_zero(scene, scene.problem.end); }

double from_start(const Scene& scene, double time) {
  using reference::shortest_decimal, reference::Rational;
  if (scene.start == 0.0) return time;
  const Rational after = shortest_decimal(time) - shortest_decimal(scene.start);
  return static_cast<double>(reference::rounded<long double>(after));
}

double from_zero(const Scene& scene, double after_start) {
  using reference::shortest_decimal, reference::Rational;
  if (scene.start == 0.0) return after_start;
  const Rational time = shortest_decimal(scene.start) + shortest_decimal(after_start);
  return static_cast<double>(reference::rounded<long double>(time));
}

std::string with_note_of_start(const Scene& scene, std::string message) {
  const bool has_time = message.find("t = ") != std::string::npos;
  if (scene.start != 0.0 && has_time)
    message += fmt::format("; this t counts from the start, {}", scene.start);
  return message;
}

void require_start_at_zero(const Scene& scene, std::string_view what) {
  if (scene.start == 0.0) return;
  throw std::invalid_argument(fmt::format(
      "start = {}: must be 0 for {}; solve, exact and choose take another one", scene.start, what));
}

}  // namespace fde::bench
