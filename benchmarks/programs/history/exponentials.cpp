// SPDX-License-Identifier: MIT
// Number of terms and error of the sums of exponentials for the kernel t^(a-1)/Gamma(a). CSV, one row a sum:
//
//   exponent   a
//   steps      number of steps of a run: the sum is for times from shortest_lag to steps + 2
//   tolerance  requested relative error
//   nodes      number of exponentials
//   bound      relative error of the construction, as computed with the sum
//   error      worst relative error of the sum as stored, with nodes and coefficients rounded to double. That
//              rounding is not in the bound

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <vector>

#include "fdebench/benchmarks/programs/figures.hpp"
#include "fdebench/schemes/history/exponential_memory.hpp"
#include "fdebench/schemes/history/weights/exponential_sum.hpp"

namespace fde::bench::figures {
namespace {

using Exact = boost::multiprecision::cpp_bin_float_quad;  // 34 digits

struct Sample {
  double time;
  Exact kernel;
};

// The kernel at geometrically spaced times from `low` to `high`. The error of the sum oscillates in log t
// with a period of about the distance of two nodes, a factor of at least 1.29, so that a ratio of 1.02
// resolves it.
std::vector<Sample> sample_kernel(double exponent, double low, double high) {
  constexpr double ratio = 1.02;
  const Exact a = exponent, scale = 1 / boost::math::tgamma(a);
  std::vector<Sample> samples;
  for (double time = low;; time = std::min(time * ratio, high)) {
    samples.push_back({time, scale * pow(Exact(time), a - 1)});
    if (time == high) return samples;
  }
}

Exact evaluate(const ExponentialSum& sum, double time) {
  constexpr double negligible = 100.0;  // exp(-100) is 4e-44; coefficients are moderate
  Exact total = 0;
  for (Eigen::Index m = 0; m < sum.nodes.size() && sum.nodes[m] * time < negligible; ++m) {
    total += sum.coefficients[m] * exp(-Exact(sum.nodes[m]) * time);
  }
  return total;
}

double worst_error(const ExponentialSum& sum, const std::vector<Sample>& samples) {
  Exact worst = 0;
  for (const auto& [time, kernel] : samples)
    worst = std::max<Exact>(worst, abs(evaluate(sum, time) / kernel - 1));
  return static_cast<double>(worst);
}

void print_rows(double exponent, double steps) {
  constexpr double low = ExponentialMemory::shortest_lag;
  const double high = steps + 2.0;
  const auto samples = sample_kernel(exponent, low, high);
  for (const double tolerance :
       {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15}) {
    const auto sum = exponential_sum(exponent, low, high, tolerance);
    fmt::print("{},{:.0e},{:.0e},{},{:.3e},{:.3e}\n", exponent, steps, tolerance, sum.nodes.size(), sum.bound,
               worst_error(sum, samples));
  }
}

}  // namespace

void exponentials(const Words& /*words*/) {
  fmt::print("exponent,steps,tolerance,nodes,bound,error\n");
  for (const double exponent : {0.05, 0.5, 0.95}) {
    for (const double steps : {1e4, 1e8}) print_rows(exponent, steps);
  }
}

}  // namespace fde::bench::figures
