// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <ostream>

#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/reports/command/arguments.hpp"
#include "fdebench/reports/command/command.hpp"
#include "fdebench/schemes/diagnostics/stability_region.hpp"

namespace fde::bench {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

struct Arguments {
  std::vector<std::string> schemes;
  std::string gamma;
  std::optional<std::string> boundary;
};

// The requested schemes; by default all that accept this order.
std::vector<const Scheme*> schemes_of(const Arguments& arguments, double gamma) {
  std::vector<const Scheme*> some;
  for (const auto& id : arguments.schemes) some.push_back(&scheme_named(id));
  if (!some.empty()) return some;
  for (const auto& scheme : schemes()) {
    if (!unsupported_reason(scheme, test_problem(scheme, gamma, -1.0), {})) some.push_back(&scheme);
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

std::string boundary_rows(const Scheme& scheme, double gamma, int points) {
  std::string rows;
  for (int i = 1; i <= points; ++i) {
    const double theta = std::numbers::pi * i / points;
    for (const ComplexValue z : root_locus(scheme, gamma, theta))
      rows += fmt::format("{},{:.17g},{:.17g},{:.17g}\n", scheme.id, theta, z.real(), z.imag());
  }
  return rows;
}

void print_stability(const Arguments& arguments, std::ostream& out) {
  const double gamma = parse_number("--gamma", arguments.gamma,
                                    {.low = 0.0, .high = 2.0, .open_low = true, .open_high = true});
  std::string rows =
      arguments.boundary ? "scheme,theta,re,im\n" : "scheme,interval,angle,exact_angle,left_at_100\n";
  const int points = arguments.boundary ? parse_count("--boundary", *arguments.boundary, 1, 100'000) : 0;
  for (const Scheme* scheme : schemes_of(arguments, gamma))
    rows += points > 0 ? boundary_rows(*scheme, gamma, points) : region_row(*scheme, gamma);
  out << rows;
}

}  // namespace

void add_stability_command(CommandLine& program, const Streams& streams, const SceneRegistry& /*known*/) {
  auto arguments = std::make_shared<Arguments>();
  Subcommand command(
      program, "stability",
      "Linear stability in z = lambda h^G of D^G y = lambda y, as CSV: the real interval (-x, 0), the angle "
      "about the negative axis in degrees, that of the exact equation, and |y_100 / y_0| as z -> -infinity");
  command.required("--gamma", arguments->gamma, "G: the order, in (0, 2)");
  command.list("--scheme", arguments->schemes, "id of a scheme; default: all that take the order");
  command.option("--boundary", arguments->boundary,
                 "K: in place of these, the z with a mode at exp(i theta), theta = pi/K, ..., pi");
  command.callback([=] { print_stability(*arguments, streams.out); });
}

}  // namespace fde::bench
