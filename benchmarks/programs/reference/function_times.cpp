// SPDX-License-Identifier: MIT
// Time of one call of the Mittag-Leffler function in double at random points with z < 0. CSV, one row a
// region, in microseconds. A slow call is repeated and the shortest of four times counts: the machine may
// have other load.

#include <fmt/core.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <random>
#include <string_view>
#include <vector>

#include "fdebench/benchmarks/programs/figures.hpp"
#include "fdebench/reference/special_functions/mittag_leffler/mittag_leffler.hpp"
#include "fdebench/reference/special_functions/prabhakar_and_matrix/mittag_leffler_matrix.hpp"
#include "fdebench/reference/special_functions/prabhakar_and_matrix/prabhakar.hpp"

namespace fde::bench::figures {
namespace {

struct Arguments {
  double alpha, beta, z;
};

using Random = std::function<double()>;  // uniform in (0, 1)

struct Region {
  std::string_view name;
  std::function<Arguments(const Random&)> draw;
  std::function<double(const Arguments&)> call = [](const Arguments& x) {
    return fde::reference::mittag_leffler(x.alpha, x.beta, x.z);
  };
};

double seconds_of(const Region& region, const Arguments& x) {
  const auto start = std::chrono::steady_clock::now();
  [[maybe_unused]] const volatile double value = region.call(x);
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double undisturbed_seconds(const Region& region, const Arguments& x) {
  constexpr double long_time = 20e-6;
  double seconds = seconds_of(region, x);
  for (int repeat = 0; seconds > long_time && repeat < 3; ++repeat)
    seconds = std::min(seconds, seconds_of(region, x));
  return seconds;
}

double power_of_ten(double from, double to, const Random& random) {
  return std::pow(10.0, std::lerp(from, to, random()));
}

double any_beta(double alpha, const Random& random) {
  const std::array<double, 7> betas{1.0, alpha, 2.0, 0.5, alpha + 1.0, 0.0, 20.0 * random() - 10.0};
  return betas.at(static_cast<std::size_t>(random() * betas.size()));
}

Region with_orders(std::string_view name, const std::function<double(const Random&)>& order) {
  return {name, [=](const Random& random) {
            const double alpha = order(random);
            return Arguments{alpha, any_beta(alpha, random), -power_of_ten(-3.0, 6.0, random)};
          }};
}

std::vector<Region> regions() {
  const auto near = [](double whole) {
    return [=](const Random& random) {
      const double distance = power_of_ten(-12.0, -1.0, random);
      return random() < 0.5 ? whole - distance : whole + distance;
    };
  };
  return {with_orders("0 < alpha <= 1", [](const Random& random) { return 1.0 - 0.999 * random(); }),
          with_orders("1 < alpha <= 2", [](const Random& random) { return 2.0 - random(); }),
          with_orders("2 < alpha <= 5", [](const Random& random) { return 5.0 - 3.0 * random(); }),
          with_orders("alpha small", [](const Random& random) { return power_of_ten(-4.0, -1.0, random); }),
          with_orders("alpha near 1", near(1.0)),
          with_orders("alpha near 2", near(2.0)),
          {"z of any size", [](const Random& random) {
             const double alpha = 2.0 - 1.999 * random();
             return Arguments{alpha, any_beta(alpha, random), -power_of_ten(-300.0, 300.0, random)};
           }}};
}

// One entry of the function of an n x n matrix without symmetries, whose eigenvalues are about |z| or
// smaller.
template <int n>
double of_matrix(const Arguments& x) {
  Eigen::MatrixXd matrix(n, n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j)
      matrix(i, j) = x.z * (i == j ? 1.0 / (1.0 + i) : 0.3 * std::sin(1.0 + 3.0 * i + 5.0 * j));
  }
  return fde::reference::mittag_leffler(x.alpha, x.beta, matrix).value(0, n - 1).real();
}

// Random arguments of the other functions, with |z| up to 10^largest.
Arguments arguments_up_to(double largest, const Random& random) {
  const double alpha = 2.0 - 1.8 * random();
  return {alpha, any_beta(alpha, random), -power_of_ten(-3.0, largest, random)};
}

std::vector<Region> other_functions() {
  const auto derivative = [](int k) {
    return [k](const Arguments& x) {
      return fde::reference::mittag_leffler_derivative(k, x.alpha, x.beta, x.z).value.real();
    };
  };
  const auto far = [](const Random& random) { return arguments_up_to(4.0, random); };
  const auto near = [](const Random& random) { return arguments_up_to(0.0, random); };
  const auto prabhakar = [](double gamma) {
    return [gamma](const Arguments& x) {
      return fde::reference::prabhakar(x.alpha, x.beta, gamma, x.z).value.real();
    };
  };
  return {{"first derivative", far, derivative(1)},
          {"second derivative", far, derivative(2)},
          {"fourth derivative", far, derivative(4)},
          {"Prabhakar gamma = 1.5, |z| <= 1", near, prabhakar(1.5)},
          {"Prabhakar gamma = 1.5", far, prabhakar(1.5)},
          {"Prabhakar gamma = 0.5", far, prabhakar(0.5)},
          {"Prabhakar gamma = 2.7", far, prabhakar(2.7)},
          {"2 x 2 matrix", far, of_matrix<2>},
          {"3 x 3 matrix", far, of_matrix<3>},
          {"4 x 4 matrix", far, of_matrix<4>}};
}

void print_row(const Region& region, int points) {
  std::mt19937_64 generator(
      4);  // NOLINT(bugprone-random-generator-seed,cert-msc51-cpp): the same rows each time
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const Random random = [&] { return uniform(generator); };
  std::vector<double> times;
  for (int i = 0; i < points; ++i) times.push_back(1e6 * undisturbed_seconds(region, region.draw(random)));
  std::ranges::sort(times);
  const auto quantile = [&](double part) { return times[static_cast<std::size_t>(part * (points - 1))]; };
  fmt::print("{},{},{:.2f},{:.2f},{:.2f},{:.2f}\n", region.name, points, quantile(0.5), quantile(0.95),
             quantile(0.999), times.back());
}

}  // namespace

void function_times(const Words& /*words*/) {
  constexpr int points = 20000;
  reference::mittag_leffler(0.5, 1.0, -1.0);  // computes the tables, not to be timed
  fmt::print("region,points,median,95 %,99.9 %,worst\n");
  reference::prabhakar(0.5, 1.0, 1.5, -1.0);
  for (const Region& region : regions()) print_row(region, points);
  for (const Region& region : other_functions()) print_row(region, points / 20);
}

}  // namespace fde::bench::figures
