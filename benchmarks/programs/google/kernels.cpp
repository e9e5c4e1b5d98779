// SPDX-License-Identifier: MIT
// Time of one weight, and of one value of the Mittag-Leffler function, its derivatives, Prabhakar's function,
// and functions of matrices. For histories: histories.cpp.

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <Eigen/Core>
#include <cmath>

#include "fdebench/reference/special_functions/special_functions.hpp"
#include "fdebench/schemes/history/weights/weights.hpp"

namespace {

using namespace fde;

void weights(benchmark::State& state, const WeightFamily* family) {
  std::int64_t lag = 1;
  for (auto _ : state) {
    benchmark::DoNotOptimize(weight({family, 0.5}, lag));
    lag = lag % 100'000 + 1;
  }
}
BENCHMARK_CAPTURE(weights, rectangle, &families::rectangle);
BENCHMARK_CAPTURE(weights, trapezoid, &families::trapezoid);
BENCHMARK_CAPTURE(weights, grunwald_letnikov, &families::grunwald_letnikov);
BENCHMARK_CAPTURE(weights, l1, &families::l1);

// E_{a,1}(-x), x from 0 to 100. The argument of the benchmark is 10 a.
void mittag_leffler_double(benchmark::State& state) {
  const double alpha = 0.1 * static_cast<double>(state.range(0));
  double x = 0.0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(reference::mittag_leffler(alpha, 1.0, -x));
    x = std::fmod(x + 0.37, 100.0);
  }
}
BENCHMARK(mittag_leffler_double)->Arg(2)->Arg(5)->Arg(9)->Arg(13)->Arg(17);

void mittag_leffler_digits(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        reference::mittag_leffler("0.5", "1", "-1", "0", static_cast<int>(state.range(0))));
  }
}
BENCHMARK(mittag_leffler_digits)->Arg(50)->Arg(200)->Unit(benchmark::kMillisecond);

// Four rows. General ones have a complex pair of eigenvalues.
Eigen::MatrixXd general_matrix(int rows) {
  return Eigen::MatrixXd::NullaryExpr(
      rows, rows, [](int i, int j) { return i == j ? -2.0 : std::sin(1.0 + 3.0 * i + 5.0 * j); });
}
Eigen::MatrixXd symmetric_matrix() { return -general_matrix(4) * general_matrix(4).transpose(); }
Eigen::MatrixXd nilpotent_matrix() { return general_matrix(4).triangularView<Eigen::StrictlyUpper>(); }

// Eigenvalues -1, -1 + apart, ..., with ones beside them, in another basis.
Eigen::MatrixXd close_eigenvalues(double apart) {
  Eigen::MatrixXd block(4, 4), basis(4, 4), inverse(4, 4);
  block << -1, 1, 0, 0, 0, -1 + apart, 1, 0, 0, 0, -1 + 2.0 * apart, 1, 0, 0, 0, -1 + 3.0 * apart;
  basis << 1, 0, 0, 0, 1, 1, 0, 0, 1, 1, 1, 0, 1, 1, 1, 1;
  inverse << 1, 0, 0, 0, -1, 1, 0, 0, 0, -1, 1, 0, 0, 0, -1, 1;
  return basis * block * inverse;
}

void mittag_leffler_of_matrix(benchmark::State& state, const Eigen::MatrixXd& matrix) {
  for (auto _ : state) benchmark::DoNotOptimize(reference::mittag_leffler(0.7, 1.0, matrix));
}
BENCHMARK_CAPTURE(mittag_leffler_of_matrix, general, general_matrix(4));
BENCHMARK_CAPTURE(mittag_leffler_of_matrix, symmetric, symmetric_matrix());
BENCHMARK_CAPTURE(mittag_leffler_of_matrix, nilpotent, nilpotent_matrix());
BENCHMARK_CAPTURE(mittag_leffler_of_matrix, defective, close_eigenvalues(0.0));
BENCHMARK_CAPTURE(mittag_leffler_of_matrix, close_eigenvalues, close_eigenvalues(1e-9));
BENCHMARK_CAPTURE(mittag_leffler_of_matrix, 20_rows, general_matrix(20))->Unit(benchmark::kMillisecond);

// E_{1.2,1}(s A) of 20 rows to 30 digits.
void mittag_leffler_of_matrix_digits(benchmark::State& state) {
  const Eigen::MatrixXd matrix = static_cast<double>(state.range(0)) * general_matrix(20);
  std::vector<reference::DecimalComplex> entries;
  for (const auto& row : matrix.rowwise())
    for (const double x : row) entries.push_back({fmt::format("{:.4f}", x), "0", "0"});
  for (auto _ : state) benchmark::DoNotOptimize(reference::mittag_leffler("1.2", "1", entries, 30));
}
BENCHMARK(mittag_leffler_of_matrix_digits)->Arg(1)->Arg(1000)->Unit(benchmark::kMillisecond);

// Singularities 65,000 and 11,000 above the real axis.
void prabhakar_far_up(benchmark::State& state) {
  for (auto _ : state)
    benchmark::DoNotOptimize(reference::prabhakar("0.6538", "2", "-2.3", "726.5", "1202", 50));
}
BENCHMARK(prabhakar_far_up)->Unit(benchmark::kMillisecond);

void derivative_far_up(benchmark::State& state) {
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        reference::mittag_leffler_derivative(8, "1.953", "2", "-82300000", "6087000", 16));
  }
}
BENCHMARK(derivative_far_up)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
