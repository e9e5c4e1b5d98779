// SPDX-License-Identifier: MIT
// The tables of docs/stability.md, as Markdown. Argument: intervals, damping, reversal or delays.

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/programs/figures.hpp"
#include "fdebench/benchmarks/programs/stability/late_growth.hpp"
#include "fdebench/benchmarks/programs/stability/linear_multistep.hpp"
#include "fdebench/schemes/diagnostics/stability_region.hpp"
#include "fdebench/schemes/problem/scalar_equation.hpp"

namespace fde::bench::figures {
namespace {

const Scheme& scheme(std::string_view id) { return *find_scheme(id); }

double growth(std::string_view id, double order, double x) {
  return late_growth(scheme(id), scalar_equation(order, -x), 1.0, 20000).growth;
}

// Real stability intervals (-x, 0), with the growth in runs 0.1 % inside and outside.
void print_intervals() {
  fmt::print(
      "| order | adams_pc | inside, outside | decoupled_multi_order | inside, outside | "
      "commensurate_adams_pc | "
      "product_trapezoidal | inside, outside |\n|---|---|---|---|---|---|---|---|\n");
  for (int i = 1; i < 20; ++i) {
    const double order = 0.1 * i;
    fmt::print("| {:.1f}", order);
    for (const auto* id :
         {"adams_pc", "decoupled_multi_order", "commensurate_adams_pc", "product_trapezoidal"}) {
      const double x = real_stability_interval(scheme(id), order);
      fmt::print(" | {}", std::isinf(x) ? "∞" : fmt::format("{:#.5g}", x));
      if (!scheme(id).expansion_of.empty()) continue;
      if (std::isinf(x)) {
        fmt::print(" | –");
      } else {
        fmt::print(" | {:.2g}, {:.2g}", growth(id, order, 0.999 * x), growth(id, order, 1.001 * x));
      }
    }
    fmt::print(" |\n");
  }
}

// y_n / y_0 as z -> -infinity.
void print_damping() {
  fmt::print("| order | n = 1 | 10 | 100 | 1000 |\n|---|---|---|---|---|\n");
  for (const double order : {0.1, 0.3, 0.5, 0.7, 0.9, 0.95, 0.99, 1.0, 1.1, 1.5}) {
    const Vec y = stiff_limit(scheme("product_trapezoidal"), order, 1000).value();
    fmt::print("| {} | {:.3g} | {:.3g} | {:.3g} | {:.3g} |\n", order, y[1], y[10], y[100], y[1000]);
  }
}

// D^(1/2) y = rate y at t = 1, h = 0.01, against 1/(|rate| sqrt(pi)).
void print_reversal() {
  constexpr double order = 0.5;
  constexpr int steps = 100;
  fmt::print("| rule | λ = -1e2 | -1e4 | -1e6 | -1e8 |\n|---|---|---|---|---|\n");
  const auto print = [&](std::string_view name, const auto& value_at_one) {
    fmt::print("| {}", name);
    for (const double rate : {-1e2, -1e4, -1e6, -1e8}) fmt::print(" | {:.3e}", value_at_one(rate));
    fmt::print(" |\n");
  };
  print("exact, to 1/(2λ²)", [](double rate) { return -1.0 / (rate * std::sqrt(std::numbers::pi)); });
  for (const auto* id : {"l1", "grunwald_letnikov", "product_trapezoidal"}) {
    print(id, [&](double rate) {
      return scheme(id).solve(scalar_equation(order, rate), Grid{1.0, steps}, {}).y(0, steps);
    });
  }
  for (const auto& [name, rule] : {std::pair{"BDF2, start weights", Multistep::bdf2},
                                   {"Newton-Gregory, start weights", Multistep::newton_gregory},
                                   {"trapezoidal, start weights", Multistep::trapezoidal}}) {
    print(name, [which = rule](double rate) {
      return multistep_relaxation(which, order, rate / std::sqrt(steps), steps)[steps];
    });
  }
}

// Ends of the real intervals of D^order y = rate y(t - M h), in units of that of the equation.
void print_delays() {
  const std::vector<int> delays{1, 2, 8, 32};
  std::string header = "| scheme ", line = "|---";
  for (const auto* order : {"0.5", "0.9"}) {
    for (const int delay : delays) {
      header += fmt::format("| {}, M = {} ", order, delay);
      line += "|---";
    }
  }
  fmt::print("{}|\n{}|\n", header, line);
  for (const auto& one : schemes()) {
    if (!one.symbol || one.capabilities.discretises_equations) continue;
    fmt::print("| `{}`", one.id);
    for (const double order : {0.5, 0.9}) {
      for (const int delay : delays) {
        const bool taken = !unsupported_reason(one, test_problem(one, order, -1.0, 1.0, delay), {});
        fmt::print(" | {}", taken ? fmt::format("{:.5f}", real_stability_interval(one, order, delay) /
                                                              real_stability_interval(
                                                                  order, static_cast<double>(delay)))
                                  : "–");
      }
    }
    fmt::print(" |\n");
  }
}

}  // namespace

void stability_tables(const Words& words) {
  const std::string_view what = words.size() == 1 ? std::string_view(words[0]) : "";
  if (what == "intervals") {
    print_intervals();
  } else if (what == "damping") {
    print_damping();
  } else if (what == "reversal") {
    print_reversal();
  } else if (what == "delays") {
    print_delays();
  } else {
    throw std::invalid_argument("say intervals, damping, reversal or delays");
  }
}

}  // namespace fde::bench::figures
