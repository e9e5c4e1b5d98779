// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/scene.hpp"
#include "fdebench/reference/linear/linear_system.hpp"

namespace fde::bench {

// D^g u = (lambda + i im) u, u(0) = y0, u'(0) = 0. After an initial layer of length |lambda|^(-1/g), u decays
// slowly, like -y0 / (lambda t^g Gamma(1-g)). An error made by a step larger than the layer persists.
SceneFactory stiff_relaxation() {
  return {
      .id = "stiff_relaxation",
      .title = "Stiff relaxation",
      .source = "Matignon, CESA'96 (1996), stability sector |arg lambda| > gamma pi/2",
      .parameters = {{"gamma", 0.5, order_up_to_two, "order"},
                     {"lambda", -1e6, any_number, "real part of the rate"},
                     {"im", 0.0, any_number, "imaginary part of the rate"},
                     {"y0", 1.0, any_number, "u(0)"}},
      .make = [](const Parameters& p) -> Scene {
        const double gamma = p["gamma"], re = p["lambda"], im = p["im"];
        const bool moves = p["y0"] != 0.0 && (re != 0.0 || im != 0.0);
        const auto start = moves ? std::vector<double>{gamma} : std::vector<double>{};
        const auto powers = power_lattice(start, {gamma}, gamma + 2.0);
        std::vector<double> real_part{p["y0"]}, imaginary_part{0.0};
        if (gamma > 1.0) real_part.push_back(0.0), imaginary_part.push_back(0.0);
        const bool is_real = im == 0.0;
        const Matrix rate =
            is_real ? Matrix::Constant(1, 1, re) : (Matrix(2, 2) << re, -im, im, re).finished();
        Scene scene{.problem = {.components = {{gamma, real_part}},
                                .rhs = [=](double, In y, Out f) { f = rate * y; },
                                .derivatives = DenseLinearPart{rate}},
                    .smoothness = {{powers}},
                    .outputs = {{"y"}}};
        reference::LinearSystem system{.orders = {gamma}, .initial = {real_part}, .matrix = rate};
        if (!is_real) {
          scene.problem.components.push_back({gamma, imaginary_part});
          scene.smoothness.powers.push_back(powers);
          scene.outputs.names.emplace_back("im_y");
          system.orders.push_back(gamma);
          system.initial.push_back(imaginary_part);
        }
        scene.reference = reference::linear_reference(system);
        return scene;
      },
      .equations = {
          {.unknown = "y", .terms = {{"1", "gamma"}}, .rhs = "lambda*y - im*im_y", .initial = {"y0", "0"}},
          {.unknown = "im_y",
           .terms = {{"1", "gamma"}},
           .rhs = "im*y + lambda*im_y",
           .initial = {"0", "0"}}}};
}

}  // namespace fde::bench
