// SPDX-License-Identifier: MIT
#include "certificate/points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>

#include "certificate/enclosure.hpp"
#include "certificate/random.hpp"

namespace fde::reference::certificate {
namespace {

using std::numbers::pi;
using Value = std::complex<double>;

// The betas that occur in equations, or any value between -2 and 4.
double usual_beta(Random& random, double alpha) {
  return random.one_of(std::array{1.0, alpha, 2.0, 1.0 + alpha, 0.5, random.between(-2.0, 4.0)});
}

// |z| such that |z|^(1/alpha) is between 10^low and 10^high.
double size_of_root(Random& random, double alpha, double low, double high) {
  return std::pow(random.power_of_ten(low, high), alpha);
}

// Whether e^(s*) s*^(1-beta) is far from overflow.
bool is_moderate(const Point& x) {
  double growth = 0.0;
  const double log_root = std::log(std::abs(x.z)) / x.alpha, turn = std::arg(x.z);
  for (int k = -3; k <= 3; ++k) {
    const double angle = (turn + 2.0 * pi * k) / x.alpha;
    if (std::abs(angle) > 0.75 * pi) continue;
    const double exponent = std::exp(log_root) * std::cos(angle) + (1.0 - x.beta) * log_root;
    growth = std::max(growth, exponent);
  }
  return growth < 690.0;
}

Point small_argument(Random& random) {
  const double alpha = random.between(0.01, 5.0);
  return {{}, alpha, usual_beta(random, alpha), Polar{random.power_of_ten(-10, -1), random.between(-pi, pi)}};
}

Point negative_moderate(Random& random) {
  const double alpha = random.between(0.05, 2.0);
  return {{}, alpha, usual_beta(random, alpha), -random.power_of_ten(-1, 2)};
}

Point negative_large(Random& random) {
  const double alpha = random.between(0.05, 2.0);
  return {{}, alpha, usual_beta(random, alpha), -random.power_of_ten(2, 10)};
}

Point positive(Random& random) {
  const double alpha = random.between(0.05, 5.0);
  return {{}, alpha, usual_beta(random, alpha), size_of_root(random, alpha, -1, 2.83)};
}

Point growing_sector(Random& random) {
  const double alpha = random.between(0.05, 2.0),
               turn = std::min(pi, alpha * pi / 2.0) * random.between(-1, 1);
  return {{}, alpha, usual_beta(random, alpha), Polar{size_of_root(random, alpha, -0.5, 2.83), turn}};
}

Point decaying_sector(Random& random) {
  const double alpha = random.between(0.05, 1.95);
  const double turn = random.with_random_sign(random.between(alpha * pi / 2.0, pi));
  return {{}, alpha, usual_beta(random, alpha), Polar{random.power_of_ten(-1, 3), turn}};
}

// |arg z| = alpha pi: the exponential is smallest compared with the powers, and a pole is on the branch cut
// of s^alpha.
Point stokes_line(Random& random) {
  const double alpha = random.between(0.05, 1.0),
               off = random.one_of(std::array{0.0, 1e-15, 1e-12, 1e-8, 1e-3});
  const double turn = random.with_random_sign(alpha * pi * (1.0 + random.with_random_sign(off)));
  return {{}, alpha, usual_beta(random, alpha), Polar{size_of_root(random, alpha, -1, 4), turn}};
}

// |arg z| = alpha pi/2: the exponential neither grows nor decays.
Point anti_stokes_line(Random& random) {
  const double alpha = random.between(0.02, 1.99),
               off = random.one_of(std::array{0.0, 1e-15, 1e-12, 1e-8, 1e-4});
  const double turn = random.with_random_sign(alpha * pi / 2.0 * (1.0 + random.with_random_sign(off)));
  return {{}, alpha, usual_beta(random, alpha), Polar{size_of_root(random, alpha, -1, 6), turn}};
}

Point small_order(Random& random) {
  const double alpha = random.between(0.01, 0.1), beta = usual_beta(random, alpha);
  if (random.flip_coin()) return {{}, alpha, beta, -random.power_of_ten(-3, 6)};
  return {{}, alpha, beta, Polar{random.between(0.3, 1.5), random.between(-pi, pi)}};
}

Point order_near_one(Random& random) {
  const double alpha = 1.0 + random.with_random_sign(random.power_of_ten(-12, -2)),
               beta = usual_beta(random, alpha);
  return {{}, alpha, beta, -random.power_of_ten(-2, 4)};
}

Point order_near_one_complex(Random& random) {
  const double alpha = 1.0 + random.with_random_sign(random.power_of_ten(-12, -2)),
               beta = usual_beta(random, alpha);
  return {{}, alpha, beta, Polar{random.power_of_ten(-1, 3), random.between(-pi, pi)}};
}

Point order_near_two(Random& random) {
  const double alpha = 2.0 + random.with_random_sign(random.power_of_ten(-12, -2)),
               beta = usual_beta(random, alpha);
  return {{}, alpha, beta, -random.power_of_ten(-1, 8)};
}

// A zero of E_{alpha,beta}(-x^alpha) between two x of different sign, to about 14 digits (Illinois method).
double zero_between(const std::function<double(double, int)>& f, double low, double high) {
  constexpr int digits = 18;
  double at_low = f(low, digits), at_high = f(high, digits);
  for (int i = 0; i < 40 && std::abs(high - low) > 1e-15 * high; ++i) {
    const double next = high - at_high * (high - low) / (at_high - at_low), at_next = f(next, digits);
    if (at_next * at_high < 0.0) {
      low = high;
      at_low = at_high;
    } else {
      at_low *= 0.5;
    }
    high = next;
    at_high = at_next;
  }
  return high;
}

// At a relative distance down to 1e-12 from the first zero after a random point.
Point near_zero(Random& random) {
  const double alpha = random.between(1.05, 2.0), beta = random.one_of(std::array{1.0, 1.0, alpha, 2.0, 0.5});
  const auto at = [&](double root, int digits) {
    return enclose(alpha, beta, -std::pow(root, alpha), digits).mid().real();
  };
  double low = random.between(0.1, 30.0), high = low;
  for (int i = 0; i < 10 && at(low, 3) * at(high, 3) > 0.0; ++i) {
    low = high;
    high += 0.4;
  }
  if (at(low, 3) * at(high, 3) > 0.0) return near_zero(random);  // too few zeros at this alpha
  const double zero = std::pow(zero_between(at, low, high), alpha);
  return {{}, alpha, beta, -zero * (1.0 + random.with_random_sign(random.power_of_ten(-12, -3)))};
}

Point beta_at_gamma_pole(Random& random) {
  const double alpha = random.between(0.05, 2.0), whole = random.one_of(std::array{0.0, -1.0, -2.0, -5.0});
  const double beta = whole + random.with_random_sign(random.one_of(std::array{0.0, 0.0, 1e-14, 1e-9, 1e-4}));
  if (random.flip_coin()) return {{}, alpha, beta, -random.power_of_ten(-3, 5)};
  return {{}, alpha, beta, Polar{size_of_root(random, alpha, -1, 2.5), random.between(-pi, pi)}};
}

Point kernel(Random& random) {
  const double alpha = random.between(0.02, 2.0);
  if (random.flip_coin()) return {{}, alpha, alpha, -random.power_of_ten(-3, 8)};
  return {{}, alpha, alpha, Polar{size_of_root(random, alpha, -1, 2.8), random.between(-pi, pi)}};
}

Point large_beta(Random& random) {
  const double alpha = random.between(0.05, 3.0), beta = random.between(4.0, 20.0);
  if (random.flip_coin()) return {{}, alpha, beta, -random.power_of_ten(-2, 6)};
  return {{}, alpha, beta, Polar{size_of_root(random, alpha, -1, 2.8), random.between(-pi, pi)}};
}

Point negative_beta(Random& random) {
  const double alpha = random.between(0.05, 3.0), beta = random.between(-10.0, 0.0);
  if (random.flip_coin()) return {{}, alpha, beta, -random.power_of_ten(-2, 6)};
  return {{}, alpha, beta, Polar{size_of_root(random, alpha, -1, 2.7), random.between(-pi, pi)}};
}

Point order_above_two(Random& random) {
  const double alpha = random.between(2.0, 5.0), beta = usual_beta(random, alpha);
  const double turn = random.one_of(std::array{pi, pi, random.between(-pi, pi)});
  const double size = size_of_root(random, alpha, -1, 3);
  return {{}, alpha, beta, turn == pi ? Value(-size) : std::polar(size, turn)};
}

Point whole_order(Random& random) {
  const double alpha = random.one_of(std::array{0.5, 1.0, 1.0, 2.0, 3.0, 4.0, 5.0});
  const double beta = std::floor(random.between(-2.0, 6.0));
  if (random.flip_coin()) return {{}, alpha, beta, -size_of_root(random, alpha, -1, 2.8)};
  return {{}, alpha, beta, Polar{size_of_root(random, alpha, -1, 2.8), random.between(-pi, pi)}};
}

Point huge_argument(Random& random) {
  const double alpha = random.between(0.02, 1.9),
               turn = random.with_random_sign(random.between(alpha * pi / 2.0 * 1.0001, pi));
  return {{}, alpha, usual_beta(random, alpha), Polar{random.power_of_ten(6, 10), turn}};
}

struct Region {
  std::string_view name;
  Point (*draw)(Random&);
};

constexpr std::array regions{Region{"small_argument", small_argument},
                             Region{"negative_moderate", negative_moderate},
                             Region{"negative_large", negative_large},
                             Region{"positive", positive},
                             Region{"growing_sector", growing_sector},
                             Region{"decaying_sector", decaying_sector},
                             Region{"stokes_line", stokes_line},
                             Region{"anti_stokes_line", anti_stokes_line},
                             Region{"small_order", small_order},
                             Region{"order_near_one", order_near_one},
                             Region{"order_near_one_complex", order_near_one_complex},
                             Region{"order_near_two", order_near_two},
                             Region{"near_zero", near_zero},
                             Region{"beta_at_gamma_pole", beta_at_gamma_pole},
                             Region{"kernel", kernel},
                             Region{"large_beta", large_beta},
                             Region{"negative_beta", negative_beta},
                             Region{"order_above_two", order_above_two},
                             Region{"whole_order", whole_order},
                             Region{"huge_argument", huge_argument}};

}  // namespace

std::vector<std::string_view> region_names() {
  std::vector<std::string_view> names;
  for (const Region& region : regions) names.push_back(region.name);
  return names;
}

Point point(int index) {
  const Region& region = regions.at(static_cast<std::size_t>(index / points_in_a_region));
  Random random(20261121 + static_cast<std::uint64_t>(index));
  Point point = region.draw(random);
  while (!is_moderate(point)) point = region.draw(random);
  point.region = region.name;
  return point;
}

}  // namespace fde::reference::certificate
