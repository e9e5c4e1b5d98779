#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "mittag_leffler/mittag_leffler.hpp"
#include "scenes/scene.hpp"

namespace fde {
namespace {

// u_t^g = kappa u_xx at n points inside (0, 1). The sine vectors sin(k pi x_j) are eigenvectors.
struct Rod {
  double order, diffusivity;
  int points, modes;

  [[nodiscard]] double intervals() const { return points + 1.0; }
  [[nodiscard]] double coupling() const { return diffusivity * intervals() * intervals(); }

  // sin(k pi x_j), its argument reduced in whole numbers to [0, pi/2].
  [[nodiscard]] double mode(int k, int j) const {
    const long half = points + 1, turned = static_cast<long>(k) * j % (2 * half);
    const long rest = turned % half, angle = std::min(rest, half - rest);
    const double sine = std::sin(std::numbers::pi * static_cast<double>(angle) / intervals());
    return turned < half ? sine : -sine;
  }

  // -lambda_k, lambda_k = 4 kappa / dx^2 sin^2(k pi dx / 2).
  [[nodiscard]] double decay(int k) const {
    const double sine = std::sin(std::numbers::pi * k / (2.0 * intervals()));
    return 4.0 * coupling() * sine * sine;
  }

  [[nodiscard]] Vec start() const {
    Vec u = Vec::Zero(points);
    for (int k = 1; k <= modes; ++k) {
      for (int j = 1; j <= points; ++j) u[j - 1] += mode(k, j) / k;
    }
    return u;
  }

  [[nodiscard]] SparseMatrix matrix() const {
    std::vector<Eigen::Triplet<double>> entries;
    for (int j = 0; j < points; ++j) {
      entries.emplace_back(j, j, -2.0 * coupling());
      if (j > 0) entries.emplace_back(j, j - 1, coupling());
      if (j + 1 < points) entries.emplace_back(j, j + 1, coupling());
    }
    SparseMatrix result(points, points);
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

  // sum_k E_g(-lambda_k t^g) sin(k pi x) / k. Rounding moves lambda_k t^g = z by less than 8 units, and with
  // it E by 8 units of |z E'| <= 2 (E(-z/2) - E(-z)), as E_g(-z) is convex for g <= 1.
  [[nodiscard]] ReferenceValue at(double t) const {
    constexpr double rounding = std::numeric_limits<double>::epsilon();
    Vec value = Vec::Zero(points);
    const double log_time = t > 0.0 ? std::abs(std::log(t)) : 0.0;
    double bound = 0.0;
    for (int k = 1; k <= modes; ++k) {
      const double z = decay(k) * std::pow(t, order);
      const auto factor = mittag_leffler(order, 1.0, std::complex<double>(-z));
      const double nearby = mittag_leffler(order, 1.0, -z / 2.0);
      const double of_argument = (8.0 + log_time) * rounding * 2.0 * std::abs(nearby - factor.value.real());
      bound += (factor.bound + of_argument + 4.0 * rounding * std::abs(factor.value.real())) / k;
      for (int j = 1; j <= points; ++j) value[j - 1] += factor.value.real() / k * mode(k, j);
    }
    return {.value = value, .bound = Vec::Constant(points, bound * (1.0 + modes * rounding))};
  }
};

}  // namespace

// Stiff: the eigenvalues reach from pi^2 to 4 (components + 1)^2, times the diffusivity.
SceneMaker fractional_diffusion() {
  return {
      .id = "fractional_diffusion",
      .title = "Fractional diffusion, semi-discretised",
      .source = "Lin & Xu, J. Comput. Phys. 225 (2007); second differences in space",
      .parameters = {{"gamma", 0.5, order_up_to_one, "order"},
                     {"diffusivity", 1.0, positive, "kappa in D^gamma u = kappa u_xx"},
                     {"components", 200.0, {.low = 2.0, .high = 2000.0}, "points inside (0, 1), whole"},
                     {"modes", 3.0, {.low = 1.0, .high = 2000.0}, "of u(x, 0) = sum sin(k pi x) / k, whole"}},
      .make = [](const Parameters& p) -> Scene {
        for (const auto* name : {"components", "modes"}) {
          if (!whole(p[name])) reject(name, p[name], "a whole number");
        }
        if (p["modes"] > p["components"]) {
          reject("modes", p["modes"], fmt::format("at most components = {}", p["components"]));
        }
        const Rod rod{.order = p["gamma"],
                      .diffusivity = p["diffusivity"],
                      .points = static_cast<int>(std::lround(p["components"])),
                      .modes = static_cast<int>(std::lround(p["modes"]))};
        Scene scene;
        const Vec start = rod.start();
        for (int j = 1; j <= rod.points; ++j) {
          scene.problem.components.push_back({rod.order, {start[j - 1]}});
          scene.outputs.names.push_back(fmt::format("u{}", j));
        }
        const SparseMatrix matrix = rod.matrix();
        scene.problem.rhs = [=](double, In y, Out f) { f.noalias() = matrix * y; };
        scene.problem.derivatives = SparseLinearPart{matrix};
        const auto powers = power_lattice({rod.order}, {rod.order}, rod.order + 2.0);
        scene.smoothness.powers.assign(static_cast<std::size_t>(rod.points), powers);
        scene.reference.at = [=](double t) { return rod.at(t); };
        return scene;
      }};
}

}  // namespace fde
