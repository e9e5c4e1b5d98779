// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "fdebench/benchmarks/scenes/equations/linear_field.hpp"
#include "fdebench/benchmarks/scenes/equations/sine_modes.hpp"

namespace fde::bench {
namespace {

// Cells of a line or a square with a no-flux border: n an axis of the unit interval, with midpoints x_i = (i
// - 1/2) / n. In each cell the discrete Laplacian of a field u is coupling n^2 times the sum over the
// neighbours of (u_neighbour - u_cell). Its sum over all cells is 0; in a square, the Laplacian of a field
// that does not vary with y equals that on a line.
class NoFluxCells {
 public:
  NoFluxCells(FieldShape shape, double coupling);

  [[nodiscard]] const FieldShape& shape() const { return shape_; }
  // The midpoints of the cells of an axis.
  [[nodiscard]] Vec midpoints() const;
  // Sets f to the discrete Laplacian of u; and the matrix of this linear map.
  void apply_laplacian(In u, Out f) const;
  [[nodiscard]] SparseMatrix matrix() const;

 private:
  FieldShape shape_;
  double coupling_;  // coupling times n^2
};

NoFluxCells::NoFluxCells(FieldShape shape, double coupling)
    : shape_(shape), coupling_(coupling * shape.points * shape.points) {}

Vec NoFluxCells::midpoints() const {
  const double n = shape_.points;
  return Vec::LinSpaced(shape_.points, 0.5 / n, (n - 0.5) / n);
}

void NoFluxCells::apply_laplacian(In u, Out f) const {
  const Eigen::Index n = shape_.points, lines = shape_.size() / n;
  // Adds the flux between each of `count` cells and the cell `apart` indices further on.
  const auto exchange = [&](Eigen::Index first, Eigen::Index count, Eigen::Index apart) {
    const auto here = u.segment(first, count), there = u.segment(first + apart, count);
    f.segment(first, count) += coupling_ * (there - here);
    f.segment(first + apart, count) -= coupling_ * (there - here);
  };
  f.setZero();
  for (Eigen::Index j = 0; j < lines; ++j) {
    exchange(j * n, n - 1, 1);
    if (j + 1 < lines) exchange(j * n, n, n);
  }
}

SparseMatrix NoFluxCells::matrix() const {
  const Eigen::Index n = shape_.points;
  const Vec beside = Vec::Constant(n + 1, coupling_);
  return five_point_matrix(shape_, beside, beside, [&](Eigen::Index place) {
    const std::array sides{place % n > 0, place % n + 1 < n, place >= n, place + n < shape_.size()};
    return -coupling_ * static_cast<double>(std::ranges::count(sides, true));
  });
}

constexpr double longest_side = 1000.0;

FieldShape shape_of(const Parameters& p) {
  const bool square = p.choice("domain") == "square";
  if (square && p["n"] > longest_side) reject("n", p["n"], "at most 1000 in a square");
  return {points_of(p, "n").points, square ? 2 : 1};
}

// The initial values along one axis; in a square, the product of two.
Vec initial_cells(const std::string& start, const Vec& x) {
  if (start == "even") return Vec::Ones(x.size());
  if (start == "step") return x.unaryExpr([](double at) { return at < 0.5 ? 1.0 : -1.0; });
  return x.unaryExpr([](double at) {
    return std::cos(std::numbers::pi * at) + 0.5 * std::cos(2.0 * std::numbers::pi * at);
  });
}

Problem allen_cahn(const NoFluxCells& cells, std::vector<Component> components) {
  Problem problem{.components = std::move(components), .end = 5.0};
  problem.rhs = [cells](double, In u, Out f) {
    cells.apply_laplacian(u, f);
    f.array() += u.array() - u.array().cube();
  };
  const auto differences = std::make_shared<const SparseMatrix>(cells.matrix());
  problem.derivatives = SparseJacobian{[differences](double, In u, SparseMatrix& jacobian) {
    jacobian = *differences;
    for (Eigen::Index i = 0; i < u.size(); ++i) jacobian.coeffRef(i, i) += 1.0 - 3.0 * u[i] * u[i];
  }};
  return problem;
}

}  // namespace

// u = 1 and u = -1 are stationary states, separated by fronts of width epsilon. Up to order 1, |u| stays
// below 1, and the free energy below its initial value.
SceneFactory fractional_allen_cahn() {
  return {
      .id = "fractional_allen_cahn",
      .title = "Fractional Allen-Cahn equation, semi-discretised",
      .source = "Tang, Yu & Zhou, SIAM J. Sci. Comput. 41 (2019); second differences, insulated borders",
      .parameters =
          {{"gamma", 0.8, order_up_to_two, "order; a wave above 1, which starts at rest"},
           {"epsilon", 0.1, positive, "width of a front, in D^gamma u = epsilon^2 Laplace(u) + u - u^3"},
           choice("domain", {"line", "square"}, "of cells inside (0, 1), or inside the unit square"),
           {"n", 8.0, {.low = 2.0, .high = 1e6}, "cells of an axis, whole; at most 1000 in a square"},
           choice("start", {"smooth", "step", "even"},
                  "u(x, 0) / amplitude, of a square in x times in y: cos(pi x) + cos(2 pi x) / 2, 1 below x "
                  "= 1/2 and -1 above, or 1"),
           {"amplitude", 0.5, any_number, "of the start"}},
      .make = [](const Parameters& p) -> Scene {
        const double gamma = p["gamma"], epsilon = p["epsilon"], amplitude = p["amplitude"];
        const FieldShape shape = shape_of(p);
        const NoFluxCells cells(shape, epsilon * epsilon);
        auto components = field_components(shape, initial_cells(p.choice("start"), cells.midpoints()), gamma);
        for (auto& component : components) component.initial.front() *= amplitude;
        Scene scene{.problem = allen_cahn(cells, std::move(components))};
        scene.smoothness.powers.assign(scene.problem.components.size(),
                                       power_lattice({gamma}, {gamma}, gamma + 2.0));
        scene.outputs = field_outputs(shape, shape.points, true);
        return scene;
      },
      .display_equations = {{"D(u, gamma)", "epsilon^2*div(grad(u)) + u - u^3"}}};
}

}  // namespace fde::bench
