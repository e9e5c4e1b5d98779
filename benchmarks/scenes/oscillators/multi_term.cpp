// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <iterator>

#include "fdebench/benchmarks/scenes/scene.hpp"
#include "fdebench/reference/linear/linear_equation.hpp"
#include "fdebench/schemes/problem/chain.hpp"

namespace fde::bench {
namespace {

// The force f(u), its derivative and its potential.
struct Force {
  std::function<double(double u)> value, slope, potential;
};

Force force_named(const std::string& name, double k) {
  if (name == "linear") {
    return {[=](double u) { return k * u; }, [=](double) { return k; },
            [=](double u) { return k * u * u / 2; }};
  }
  if (name == "sine") {
    return {[=](double u) { return k * std::sin(u); }, [=](double u) { return k * std::cos(u); },
            [=](double u) { return k * (1.0 - std::cos(u)); }};
  }
  return {[=](double u) { return k * u * u * u; }, [=](double u) { return 3.0 * k * u * u; },
          [=](double u) { return k * u * u * u * u / 4; }};
}

std::function<double(double t)> load_named(const std::string& name, double size, double omega) {
  if (name == "ramp") return [=](double t) { return size * t; };
  if (name == "cosine") return [=](double t) { return size * std::cos(omega * t); };
  return [size = name == "none" ? 0.0 : size](double) { return size; };
}

// A term and the name of the column of its derivative.
struct NamedTerm {
  Term term;
  std::string column;
};

// Appends the terms coefficient_k D^order_k u with columns prefix1_u, prefix2_u, ...; terms with coefficient
// 0 are left out.
void add_terms(const Parameters& p, const char* orders, const char* coefficients, const std::string& prefix,
               std::vector<NamedTerm>& terms) {
  const auto &of_orders = p.numbers(orders), &of_terms = p.numbers(coefficients);
  if (of_terms.size() != of_orders.size())
    reject(coefficients, of_terms, std::string("as many numbers as ") + orders);
  for (std::size_t k = 0; k < of_orders.size(); ++k) {
    if (of_terms[k] == 0.0) continue;
    if (!(of_orders[k] < p["order"])) reject(orders, of_orders, "a list of orders below `order`");
    terms.push_back({{of_terms[k], of_orders[k]}, prefix + std::to_string(k + 1) + "_u"});
  }
}

// All terms below the leading one; u and, above order 1, u' always have a column.
std::vector<NamedTerm> terms_of(const Parameters& p) {
  std::vector<NamedTerm> terms{{{0.0, 0.0}, "u"}};
  add_terms(p, "beta", "d", "Dbeta", terms);
  if (p["order"] > 1.0) {
    terms.push_back({{p["c"], 1.0}, "du"});
  } else if (p["c"] != 0.0) {
    reject("c", p["c"], "0 where `order` is not above 1");
  }
  add_terms(p, "alpha", "b", "Dalpha", terms);
  return terms;
}

// For the leading order 2: a u'^2/2 + the potential of the force; its rate is u' (g - damping terms).
Energy energy_of(const std::vector<NamedTerm>& terms, double a, const Force& force,
                 const std::function<double(double t)>& load) {
  Vec weights(std::ssize(terms));
  std::ranges::transform(terms, weights.begin(), [](const NamedTerm& one) { return one.term.coefficient; });
  const auto velocity = std::ranges::find(terms, "du", &NamedTerm::column) - terms.begin();
  return {.value = [=](In c) { return a * c[velocity] * c[velocity] / 2 + force.potential(c[0]); },
          .power = [=](double t, In c) { return c[velocity] * (load(t) - weights.dot(c)); }};
}

reference::Reference linear_motion(const Parameters& p, const std::vector<NamedTerm>& terms) {
  reference::LinearEquation equation{.terms = {{p["a"], p["order"]}, {p["k"], 0.0}},
                                     .initial = {p["u0"], p["du0"]}};
  std::vector<double> orders;
  for (const auto& [term, column] : terms) {
    equation.terms.push_back({term.coefficient, term.order});
    orders.push_back(term.order);
  }
  if (p.choice("load") == "constant") equation.loads.push_back({p["g0"], 0.0});
  if (p.choice("load") == "ramp") equation.loads.push_back({p["g0"], 1.0});
  return reference::linear_reference(equation, orders);
}

Scene scene_of(const Parameters& p) {
  const auto terms = terms_of(p);
  const double a = p["a"], order = p["order"], k = p["k"];
  const Force force = force_named(p.choice("force"), k);
  const auto load = load_named(p.choice("load"), p["g0"], p["omega"]);
  std::vector<Term> lower;
  std::vector<std::string> names;
  for (const auto& [term, column] : terms) {
    lower.push_back(term);
    names.push_back(column);
  }
  std::vector<double> initial{p["u0"], p["du0"]};
  initial.resize(initial_count(order));
  const Chain chain({a, order}, lower, initial);
  std::vector<Eigen::Index> rows;
  for (const Term& term : lower) rows.push_back(*chain.row(term.order));

  MultiTermEquation forced{.chain = chain,
                           .force = [=](double t, In y) { return load(t) - force.value(y[0]); }};
  const bool linear = p.choice("force") == "linear";
  if (linear) {
    forced.derivatives = LinearForce{-k};
  } else {
    forced.derivatives =
        ForceGradient{[=](double, In y, double, Out gradient) { gradient[0] -= force.slope(y[0]); }};
  }
  Scene scene{.problem = chain_problem({forced}, 20.0),
              .smoothness = smoothness_of_chains({chain}),
              .outputs = select_components(names, rows)};
  if (linear && p.choice("load") != "cosine") scene.reference = linear_motion(p, terms);
  if (order == 2.0) scene.energy = energy_of(terms, a, force, load);
  return scene;
}

}  // namespace

// a D^order u + sum_k b_k D^alpha_k u + c u' + sum_l d_l D^beta_l u + f(u) = g(t), with any number of terms,
// as the chain (2.1). Equation (1.4), after Wang, is `order` = n/m with orders k/m below it; (1.6), after
// Diethelm, has any `order`.
SceneFactory multi_term() {
  return {.id = "multi_term",
          .title = "Multi-term equation of any number of orders",
          .source = "Yin, Liu & Anh 2007, eqs 1.1, 2.1; 1.4 and 1.6 with other leading orders",
          .parameters = {{"order", 2.0, order_up_to_two, "the leading order"},
                         {"a", 1.0, positive, "coefficient of the leading derivative"},
                         list_of_numbers("alpha", {1.2, 1.6}, {.low = 1.0, .high = 2.0, .open_high = true},
                                         "orders alpha_k"),
                         list_of_numbers("b", {0.1, 0.05}, any_number, "coefficients b_k"),
                         {"c", 0.1, any_number, "coefficient of u'"},
                         list_of_numbers("beta", {0.3, 0.7}, {.low = 0.0, .high = 1.0}, "orders beta_l"),
                         list_of_numbers("d", {0.1, 0.05}, any_number, "coefficients d_l"),
                         choice("force", {"sine", "linear", "cubic"}, "f(u) = k sin u, k u, k u^3"),
                         {"k", 1.0, any_number, "size of the force"},
                         choice("load", {"cosine", "none", "constant", "ramp"},
                                "g(t) = g0 cos(omega t), 0, g0, g0 t"),
                         {"g0", 0.3, any_number, "size of the load"},
                         {"omega", 0.7, any_number, "frequency of the load"},
                         {"u0", 1.0, any_number, "u(0)"},
                         {"du0", -0.3, any_number, "u'(0); not where `order` is up to 1"}},
          .make = scene_of,
          .display_equations = {
              {"a*D(u, order) + sum(k, b_k*D(u, alpha_k)) + c*D(u, 1) + sum(l, d_l*D(u, beta_l)) + f(u)",
               "g(t)"}}};
}

}  // namespace fde::bench
