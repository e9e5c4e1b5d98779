// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "support/testing.hpp"

// The scenes of the tests of rates.
namespace fde::bench {

// A scene with parameters and an end at which 256 ... 4096 steps are in the asymptotic range.
struct RateScene {
  std::string name, scene;
  ParameterValues values;
  double end;
  double grading = 1.0;
};

inline std::vector<RateScene> variants() {
  std::vector<RateScene> all;
  for (const double g : {0.2, 0.5, 0.8, 1.0, 1.3, 1.7}) {
    const auto tag = fmt::format("{:.0f}", 10 * g);
    all.push_back({"relaxation_" + tag, "relaxation", {{"gamma", g}}, 1.0});
    all.push_back({"diethelm_" + tag, "diethelm", {{"gamma", g}}, 1.0});
    all.push_back({"power_" + tag, "power", {{"gamma", g}, {"p", g + 2.0}}, 1.0});
    if (g <= 1.0) all.push_back({"relaxation_pair_" + tag, "relaxation_pair", {{"gamma", g}}, 1.0});
    if (g <= 1.0) all.push_back({"brusselator_" + tag, "brusselator", {{"gamma", g}, {"B", 2.0}}, 1.0});
    if (g > 0.2 && g <= 1.0) all.push_back({"van_der_pol_" + tag, "van_der_pol", {{"gamma", g}}, 1.0});
    if (g > 1.0) {
      const ParameterValues loaded{{"nu", g}, {"c0", 0.5}, {"c1", 0.25}};
      all.push_back({"fractional_oscillator_" + tag, "fractional_oscillator", loaded, 3.0});
    }
    if (g > 1.0) all.push_back({"bagley_torvik_" + tag, "bagley_torvik", {{"alpha", g}}, 2.0});
  }
  // Diffusion so slow that the steps resolve the fastest mode.
  for (const auto& [tenths, start] : {std::pair{5, "smooth"}, {8, "step"}, {15, "smooth"}}) {
    const ParameterValues values{
        {"gamma", tenths / 10.0}, {"start", start}, {"diffusivity", 0.02}, {"n", 3.0}};
    all.push_back({fmt::format("fractional_diffusion_2d_{}_{}", tenths, start), "fractional_diffusion_2d",
                   values, 1.0});
    const ParameterValues field{{"gamma", tenths / 10.0}, {"start", start}, {"n", 4.0}};
    all.push_back(
        {fmt::format("fractional_allen_cahn_{}_{}", tenths, start), "fractional_allen_cahn", field, 1.0});
  }
  all.push_back({"bagley_torvik_5", "bagley_torvik", {{"alpha", 0.5}}, 2.0});
  for (const auto& [first, second] : {std::pair{0.6, 1.5}, {0.5, 0.9}}) {
    const ParameterValues orders{{"gamma1", first}, {"gamma2", second}};
    all.push_back(
        {fmt::format("linear_system_{:.0f}_{:.0f}", 10 * first, 10 * second), "linear_system", orders, 1.0});
  }
  for (const auto& [alpha, beta] : {std::pair{1.5, 0.5}, {1.25, 0.75}, {1.9, 0.1}}) {
    const auto tag = fmt::format("{:.0f}_{:.0f}", 100 * alpha, 100 * beta);
    for (const auto* scene : {"damped_oscillator", "pendulum", "extensible_pendulum"}) {
      all.push_back({fmt::format("{}_{}", scene, tag), scene, {{"alpha", alpha}, {"beta", beta}}, 2.0});
    }
  }
  for (const auto& [tenths, form] : {std::pair{2, "integrated"},
                                     {5, "integrated"},
                                     {7, "integrated"},
                                     {3, "acceleration"},
                                     {3, "stabilised"},
                                     {7, "multiplier"},
                                     {15, "integrated"},
                                     {15, "multiplier"}}) {
    ParameterValues values{{"alpha", tenths / 10.0}, {"formulation", form}, {"kappa", 2.0}};
    if (tenths > 10) values["b2"] = 0.3;  // a.b > 0: no mode grows
    all.push_back({fmt::format("fractional_constraint_2d_{}_{}", tenths, form), "fractional_constraint_2d",
                   values, 1.0});
  }
  // Constraints of whole order, in every form: the last is with multipliers, for implicit schemes only.
  for (const auto* scene :
       {"nonholonomic_particle", "knife_edge", "rolling_disc", "loxodrome", "isokinetic"}) {
    for (const auto& form : parameter_named("formulation", scene, scene_factory(scene).parameters).choices) {
      ParameterValues values{{"formulation", form}};
      if (scene == std::string_view("rolling_disc")) values["pull"] = 0.6;
      if (scene == std::string_view("loxodrome")) values["speed"] = 0.5;
      all.push_back({fmt::format("{}_{}", scene, form), scene, values, 2.0});
    }
  }
  all.push_back({"vakonomic_particle", "vakonomic_particle", {{"mu0", 0.5}}, 2.0});
  for (const double alpha : {0.25, 0.5, 0.75, 2.25, 2.5, 2.75}) {
    all.push_back({fmt::format("fractional_constraint_1d_{:.0f}", 100 * alpha),
                   "fractional_constraint_1d",
                   {{"alpha", alpha}, {"b", 1.0}},
                   1.0});
  }
  for (const auto& [form, alpha] :
       {std::pair{"integrated", 0.3}, {"integrated", 0.6}, {"acceleration", 0.6}, {"multiplier", 0.6}}) {
    for (const auto* surface : {"plane", "sphere"}) {
      const ParameterValues values{{"alpha", alpha}, {"surface", surface}, {"formulation", form}};
      all.push_back({fmt::format("fractional_knife_edge_{}_{}_{:.0f}", surface, form, 10 * alpha),
                     "fractional_knife_edge", values, 1.0});
    }
  }
  for (const auto* form : {"acceleration", "stabilised", "multiplier"}) {
    all.push_back({fmt::format("fractional_constraint_nonlinear_{}", form),
                   "fractional_constraint_nonlinear",
                   {{"formulation", form}, {"kappa", 2.0}},
                   1.0});
  }
  for (const auto* form : {"reduced", "integrated", "multiplier"}) {
    all.push_back({fmt::format("nonlinear_fractional_oscillator_{}", form),
                   "nonlinear_fractional_oscillator",
                   {{"form", form}},
                   2.0});
  }
  return all;
}

// D^L u + 0.3 D^(0.8 L) u + 0.2 D^(0.2 L) u + u = 0.3, L the leading order.
inline ParameterValues multi_term_of(double leading) {
  const double high = 0.8 * leading, low = 0.2 * leading;
  ParameterValues values{{"order", leading}, {"force", "linear"}, {"load", "constant"}, {"du0", 0.5}};
  values["c"] = 0.0;
  values["alpha"] = high > 1.0 ? std::vector<double>{high} : std::vector<double>{1.5};
  values["b"] = high > 1.0 ? std::vector<double>{0.3} : std::vector<double>{0.0};
  values["beta"] = high > 1.0 ? std::vector<double>{low} : std::vector<double>{low, high};
  values["d"] = high > 1.0 ? std::vector<double>{0.2} : std::vector<double>{0.2, 0.3};
  return values;
}

// Solutions that start like t^g, on grids whose grading restores the rate, or a part of it.
inline std::vector<RateScene> graded_variants() {
  std::vector<RateScene> all;
  for (const double g : {0.4, 0.6, 0.8, 1.5}) {
    for (const double grading : {1.5, 2.5, 4.0}) {
      const auto tag = fmt::format("{:.0f}__graded_{:.0f}", 10 * g, 10 * grading);
      all.push_back({"relaxation_" + tag, "relaxation", {{"gamma", g}}, 1.0, grading});
      if (g > 1.0) continue;
      all.push_back({"power_" + tag, "power", {{"gamma", g}, {"p", g / 2 + 0.5}}, 1.0, grading});
    }
  }
  for (const auto* medium : {"even", "halves"}) {
    for (const double grading : {1.5, 3.0}) {
      const ParameterValues step{
          {"start", "step"}, {"diffusivity", 0.02}, {"contrast", 3.0}, {"medium", medium}, {"n", 3.0}};
      all.push_back({fmt::format("fractional_diffusion_2d_{}__graded_{:.0f}", medium, 10 * grading),
                     "fractional_diffusion_2d", step, 1.0, grading});
    }
  }
  return all;
}

// Equations of several leading orders, for the schemes that discretise these.
inline std::vector<RateScene> multi_term_variants() {
  std::vector<RateScene> all;
  for (const double leading : {0.5, 0.8, 1.3, 1.7, 2.0}) {
    for (const double grading : {1.0, 2.0}) {
      all.push_back({fmt::format("multi_term_{:.0f}__graded_{:.0f}", 10 * leading, 10 * grading),
                     "multi_term", multi_term_of(leading), 1.0, grading});
    }
  }
  return all;
}

// NOLINTNEXTLINE(readability-identifier-naming): GoogleTest looks for this name.
inline void PrintTo(const RateScene& variant, std::ostream* out) { *out << variant.name; }
inline constexpr auto name_of_variant = [](const auto& test) { return test.param.name; };

}  // namespace fde::bench
