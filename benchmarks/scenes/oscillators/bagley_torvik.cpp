// SPDX-License-Identifier: MIT
#include <utility>

#include "fdebench/benchmarks/scenes/scene.hpp"
#include "fdebench/reference/linear/linear_equation.hpp"
#include "fdebench/schemes/problem/chain_problem.hpp"

namespace fde::bench {
namespace {

Problem loaded_problem(const Chain& chain, double stiffness, double load, double until) {
  const auto force = [=](double t, In y) {
    const double share = t < until ? 1.0 : (t == until ? 0.5 : 0.0);
    return share * load - stiffness * y[0];
  };
  Problem problem =
      chain_problem({{.chain = chain, .force = force, .derivatives = LinearForce{-stiffness}}}, 16.0);
  if (load != 0.0) problem.jump_times = {until};
  return problem;
}

}  // namespace

// A y'' + B D^alpha y + C y = load for t < load_until, then 0: a plate in a viscous fluid. At t = load_until
// the load has its mean value, so that a grid with this time keeps its rate; otherwise the jump is inside a
// step and lowers the rate.
SceneFactory bagley_torvik() {
  return {.id = "bagley_torvik",
          .title = "Bagley-Torvik plate",
          .source = "Torvik & Bagley 1984; load of Podlubny 1999, section 8.3.2",
          .parameters = {{"A", 1.0, positive, "mass"},
                         {"B", 0.5, any_number, "damping"},
                         {"C", 0.5, any_number, "stiffness"},
                         {"alpha",
                          1.5,
                          {.low = 0.0, .high = 2.0, .open_low = true, .open_high = true},
                          "order of damping; at 1 not the limit from above"},
                         {"y0", 0.0, any_number, "y(0)"},
                         {"dy0", 0.0, any_number, "y'(0)"},
                         {"load", 8.0, any_number, "load"},
                         {"load_until", 1.0, positive, "time at which the load ends"}},
          .make = [](const Parameters& p) -> Scene {
            const double stiffness = p["C"], load = p["load"], until = p["load_until"];
            const Chain chain({p["A"], 2.0}, {{p["B"], p["alpha"]}}, {p["y0"], p["dy0"]});
            std::vector<std::string> names{"y", "dy"};
            std::vector<double> orders{0.0, 1.0};
            if (p["B"] != 0.0) {
              names.emplace_back("Dalpha_y");
              orders.push_back(p["alpha"]);
            }
            std::vector<Eigen::Index> rows;
            for (const double order : orders) rows.push_back(*chain.row(order));
            std::vector<Discontinuity> discontinuities;
            if (p["alpha"] == 1.0 && p["B"] * p["dy0"] != 0.0)
              discontinuities = {{"alpha", "D^alpha y tends to y' - y'(0) from above"}};
            Smoothness smoothness = smoothness_of_chains({chain});
            if (load != 0.0) smoothness.jumps = {chain.size() - 1};
            return {.problem = loaded_problem(chain, stiffness, load, until),
                    .smoothness = smoothness,
                    .outputs = select_components(names, rows),
                    .reference = reference::linear_reference(
                        {.terms = {{p["A"], 2.0}, {p["B"], p["alpha"]}, {stiffness, 0.0}},
                         .initial = {p["y0"], p["dy0"]},
                         .loads = {{load}, {.coefficient = -load, .start_time = until}}},
                        orders),
                    .discontinuities = std::move(discontinuities)};
          },
          .equations = {{.unknown = "y",
                         .terms = {{"A", "2"}, {"B", "alpha"}},
                         .rhs = "load*step(load_until - t) - C*y",
                         .initial = {"y0", "dy0"}}}};
}

}  // namespace fde::bench
