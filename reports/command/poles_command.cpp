// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

#include "fdebench/benchmarks/references/poles.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/reports/command/command.hpp"

namespace fde::bench {
namespace {

using reference::CharacteristicZero;

// Whether it is on the imaginary axis, to rounding.
bool is_on_axis(const CharacteristicZero& zero) {
  constexpr double rounding = 1e-12;
  return std::abs(zero.s.real()) <= rounding * std::abs(zero.s);
}

std::string verdict(const std::vector<CharacteristicZero>& zeros) {
  const auto growing = std::ranges::count_if(
      zeros, [](const CharacteristicZero& zero) { return !is_on_axis(zero) && zero.s.real() > 0.0; });
  if (growing > 0)
    return fmt::format("unstable: {} with a positive real part", growing > 1 ? "poles" : "a pole");
  if (std::ranges::any_of(zeros, is_on_axis))
    return "not asymptotically stable: a pole on the imaginary axis, to rounding";
  return "stable: no pole with a real part of 0 or above, so that without loads every solution tends to 0";
}

void print_poles(const Given& given, const Streams& streams, const SceneRegistry& known) {
  const auto variant = read_variant(given, known);
  const Scene scene = make_scene_unchecked(variant);
  const auto zeros = poles_of(scene);
  if (!zeros) {
    reject_text(
        "scene", variant.factory->id,
        "linear with constant coefficients, of up to 12 rows, without delays and events that set unknowns");
  }
  std::string rows = "re,im,multiplicity\n";
  for (const auto& [s, multiplicity] : *zeros)
    rows += fmt::format("{:.17g},{:.17g},{}\n", s.real(), s.imag(), multiplicity);
  streams.out << rows;
  say(streams, Message::note, verdict(*zeros));
}

void print_response(const Given& given, const Streams& streams, const SceneRegistry& known) {
  const auto variant = read_variant(given, known);
  const Scene scene = make_scene_unchecked(variant);
  if (scene.transfers.empty()) reject_text("scene", variant.factory->id, "one with a transfer function");
  constexpr double degree = std::numbers::pi / 180.0;
  std::string rows = "frequency";
  for (const auto& transfer : scene.transfers) rows += fmt::format(",magnitude_{0},phase_{0}", transfer.name);
  for (const double frequency : increasing(given.numbers("--frequencies"))) {
    rows += fmt::format("\n{:.17g}", frequency);
    for (const auto& transfer : scene.transfers) {
      const auto response = frequency_response(transfer, frequency);
      if (!std::isfinite(std::abs(response))) {
        throw NumericalFailure(
            fmt::format("the response of {} at frequency {} is not finite", transfer.name, frequency));
      }
      rows += fmt::format(",{:.17g},{:.17g}", std::abs(response), std::arg(response) / degree);
    }
  }
  streams.out << rows << '\n';
}

}  // namespace

Command poles_command() {
  return {
      {"poles",
       "Look up",
       "Print the poles of a linear scene, the zeros of its characteristic function; CSV",
       {scene_argument("id of a linear scene"), set_argument()},
       {{"fdebench poles bagley_torvik",
         "prints all s on the principal sheet for which e^(s t) is part of a solution, those to the right "
         "first, and says whether the equation is stable."},
        {"fdebench poles fractional_control --set K=200", "prints those of a loop with a larger gain."}},
       {"response", "exact", "stability"}},
      print_poles};
}

Command response_command() {
  return {
      {"response",
       "Look up",
       "Print the frequency response of the transfer functions of a scene; CSV",
       {scene_argument("id of a scene with a transfer function"),
        set_argument(),
        {"--frequencies W1,W2,...", "angular frequencies", positive}},
       {{"fdebench response fractional_control --frequencies 0.1,1,10",
         "prints |G(i w)| and the phase in degrees, in (-180, 180], of the plant and its controller without "
         "the feedback."},
        {"fdebench response fractional_control:mu=0.5 --frequencies 4",
         "prints those of another controller at one frequency."}},
       {"poles", "solve"}},
      print_response};
}

}  // namespace fde::bench
