// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <ostream>

#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/reports/command/arguments.hpp"
#include "fdebench/reports/command/command.hpp"
#include "fdebench/reports/command/progress_display.hpp"
#include "fdebench/schemes/diagnostics/stability_region.hpp"

namespace fde::bench {
namespace {

constexpr Range orders{.low = 0.0, .high = 2.0, .open_low = true, .open_high = true};
constexpr CountRange boundary_counts{1, 100'000};

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

void print_stability(const Arguments& arguments, const Streams& streams) {
  const double gamma = parse_number("--gamma", arguments.gamma, orders);
  std::string rows =
      arguments.boundary ? "scheme,theta,re,im\n" : "scheme,interval,angle,exact_angle,left_at_100\n";
  const int points = arguments.boundary ? parse_count("--boundary", *arguments.boundary, boundary_counts) : 0;
  {
    const auto chosen = schemes_of(arguments, gamma);
    ProgressLine line(streams, "stability");
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      line.set(i, chosen.size(), std::string(chosen[i]->id));
      rows += points > 0 ? boundary_rows(*chosen[i], gamma, points) : region_row(*chosen[i], gamma);
    }
  }
  streams.out << rows;
}

}  // namespace

void add_stability_command(CommandLine& program, const Streams& streams, const SceneRegistry& /*known*/) {
  auto arguments = std::make_shared<Arguments>();
  Subcommand command(
      program, "stability",
      "Print the regions of linear stability of schemes for D^G y = lambda y, in z = lambda h^G");
  command.group("Look up");
  command.required("--gamma", arguments->gamma, "the order of the equation").takes("G", orders);
  command.list("--scheme", arguments->schemes, "id of a scheme")
      .takes("ID")
      .usual("all that take the order")
      .completed_by(Completion::scheme);
  command
      .option("--boundary", arguments->boundary,
              "in place of the table print the z with a mode at exp(i theta), theta = pi/K, ..., pi")
      .takes("K", boundary_counts);
  command.example(
      "fdebench stability --gamma 0.5",
      "prints CSV: the real interval (-x, 0), the angle about the negative axis in degrees, that of "
      "the exact equation, and |y_100 / y_0| as z goes to -infinity.");
  command.example("fdebench stability --gamma 1.5 --scheme l1 --boundary 200",
                  "prints 200 points of the curve that bounds the region of l1.");
  command.see_also({"schemes", "plot"});
  command.callback([=, &streams] { print_stability(*arguments, streams); });
}

}  // namespace fde::bench
