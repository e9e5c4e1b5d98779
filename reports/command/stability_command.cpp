// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <ostream>

#include "fdebench/reports/command/command.hpp"
#include "fdebench/reports/command/progress_display.hpp"
#include "fdebench/schemes/diagnostics/stability_region.hpp"

namespace fde::bench {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

// The requested schemes; by default all that accept this order and delay.
std::vector<const Scheme*> schemes_of(const Given& given, double gamma, int delay) {
  std::vector<const Scheme*> some;
  for (const auto& id : given.all("--scheme")) some.push_back(&scheme_named(id));
  if (!some.empty()) return some;
  for (const auto& scheme : schemes()) {
    if (!unsupported_reason(scheme, test_problem(scheme, gamma, -1.0, 1.0, delay), {}))
      some.push_back(&scheme);
  }
  return some;
}

std::string region_row(const Scheme& scheme, double gamma) {
  constexpr int steps = 100;
  const auto response = stiff_limit(scheme, gamma, steps);
  return fmt::format("{},{:.10g},{:.10g},{:.10g},{}\n", scheme.id, real_stability_interval(scheme, gamma),
                     stability_angle(scheme, gamma) / degree, 180.0 - 90.0 * gamma,
                     response ? fmt::format("{:.3g}", std::abs((*response)[steps])) : "");
}

std::string delayed_row(const Scheme& scheme, double gamma, int delay) {
  return fmt::format("{},{:.10g},{:.10g}\n", scheme.id, real_stability_interval(scheme, gamma, delay),
                     real_stability_interval(gamma, delay));
}

std::string boundary_rows(const Scheme& scheme, double gamma, int delay, int count) {
  std::string rows;
  for (int i = 1; i <= count; ++i) {
    const double theta = std::numbers::pi * i / count;
    for (const ComplexValue z : root_locus(scheme, gamma, theta, delay))
      rows += fmt::format("{},{:.17g},{:.17g},{:.17g}\n", scheme.id, theta, z.real(), z.imag());
  }
  return rows;
}

void print_stability(const Given& given, const Streams& streams, const SceneRegistry& /*known*/) {
  const double gamma = given.number("--gamma");
  const int count = given.find_count("--boundary").value_or(0);
  const int delay = given.find_count("--delay").value_or(0);
  std::string rows = count > 0   ? "scheme,theta,re,im\n"
                     : delay > 0 ? "scheme,interval,exact_interval\n"
                                 : "scheme,interval,angle,exact_angle,left_at_100\n";
  {
    const auto chosen = schemes_of(given, gamma, delay);
    ProgressLine line(streams, "stability");
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      line.set(i, chosen.size(), std::string(chosen[i]->id));
      const Scheme& scheme = *chosen[i];
      rows += count > 0   ? boundary_rows(scheme, gamma, delay, count)
              : delay > 0 ? delayed_row(scheme, gamma, delay)
                          : region_row(scheme, gamma);
    }
  }
  streams.out << rows;
}

}  // namespace

Command stability_command() {
  return {
      {"stability",
       "Look up",
       "Print the regions of linear stability of schemes for D^G y = lambda y, in z = lambda h^G",
       {{"--gamma G", "the order of the equation", order_below_two},
        {"[--scheme ID]...", "id of a scheme", Completion::scheme, "all that take the order"},
        {"[--delay M]", "for D^G y = lambda y(t - M h) instead, with steps of length h",
         CountRange{1, 10'000}},
        {"[--boundary K]",
         "in place of the table print the z with a mode at exp(i theta), theta = pi/K, ..., pi",
         CountRange{1, 100'000}}},
       {{"fdebench stability --gamma 0.5",
         "prints CSV: the real interval (-x, 0), the angle about the negative axis in degrees, that of "
         "the exact equation, and |y_100 / y_0| as z goes to -infinity."},
        {"fdebench stability --gamma 0.9 --delay 8",
         "prints the ends x of the real intervals (-x, 0) for a delay of 8 steps, of the scheme and of the "
         "equation."},
        {"fdebench stability --gamma 1.5 --scheme l1 --boundary 200",
         "prints 200 points of the curve that bounds the region of l1."}},
       {"schemes", "plot"}},
      print_stability};
}

}  // namespace fde::bench
