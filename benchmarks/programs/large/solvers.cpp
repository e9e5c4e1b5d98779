// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/programs/large/solvers.hpp"

#include <fmt/format.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <ctime>
#include <functional>
#include <limits>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "fdebench/benchmarks/programs/large/step_matrix.hpp"
#include "fdebench/schemes/solvers/conjugate_gradients.hpp"
#include "fdebench/schemes/solvers/sparse_factors.hpp"

namespace fde::bench {
namespace {

constexpr double strength = 0.028;  // kappa of L1 of order 1/2 with 1000 steps

// CPU time: the least of up to five repetitions, as many as start within one second.
double nanoseconds(const std::function<void()>& work) {
  double least = std::numeric_limits<double>::infinity(), all = 0.0;
  for (int repetition = 0; repetition < 5 && all < 1.0; ++repetition) {
    const auto start = std::clock();
    work();
    const double taken = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    least = std::min(least, taken);
    all += taken;
  }
  return 1e9 * least;
}

Vec load(Eigen::Index size) {
  return Vec::LinSpaced(size, 0.0, 1.0).unaryExpr([](double x) {
    return std::sin(9.0 * x) + (x < 0.5 ? 1.0 : 0.0);
  });
}

struct Coefficients {
  const char* name;
  double (*diffusivity)(double, double);
  double (*reaction)(double, double);
};

double none(double /*x*/, double /*y*/) { return 0.0; }
double one(double /*x*/, double /*y*/) { return 1.0; }

const std::vector<Coefficients>& coefficients() {
  static const std::vector<Coefficients> all{
      {"constant", one, none},
      {"1 + 0.9 sin 6x cos 5y",
       [](double x, double y) { return 1.0 + 0.9 * std::sin(6.0 * x) * std::cos(5.0 * y); }, none},
      {"exp(4.6 sin(3x + 2y))",
       [](double x, double y) { return std::exp(4.6 * std::sin(3.0 * x + 2.0 * y)); }, none},
      {"10 in a disc, 1 around",
       [](double x, double y) { return std::hypot(x - 0.5, y - 0.5) < 0.3 ? 10.0 : 1.0; }, none},
      {"100 in a disc, 1 around",
       [](double x, double y) { return std::hypot(x - 0.5, y - 0.5) < 0.3 ? 100.0 : 1.0; }, none},
      {"0.01, Allen-Cahn", [](double, double) { return 0.01; },
       [](double x, double y) { return 3.0 * std::pow(std::sin(9.0 * x) * std::cos(7.0 * y), 2) - 1.0; }}};
  return all;
}

void print(const SparseMatrix& matrix, const char* of, std::string_view method, double made, double solved,
           long iterations, double error) {
  const auto unknowns = static_cast<double>(matrix.rows());
  fmt::print("{:.0e} | {} | {} | {:.0f} | {:.1f} | {} | {:.1e}\n", unknowns, of, method, made / unknowns,
             solved / unknowns, iterations, error);
  std::fflush(stdout);
}

// Measures solvers of one matrix. Errors are against a direct solution with one step of iterative refinement.
class Compared {
 public:
  explicit Compared(const SparseMatrix& matrix) : load_(load(matrix.rows())) {}
  void measure_direct(const SparseMatrix& matrix, const char* of) {
    CholeskyFactors factors(matrix);
    const double made = nanoseconds([&] { factors.factorise(matrix); });
    Vec x;
    const double solved = nanoseconds([&] { factors.solve(x = load_); });
    Vec correction = load_ - matrix * x;
    factors.solve(correction);
    best_ = x + correction;
    print(matrix, of, factors.active_method(), made, solved, 1, error(x));
  }
  void measure_chosen(const SparseMatrix& matrix, const char* of) const {
    auto factors = sparse_factors(matrix);
    if (factors->active_method() == "cholesky") return;
    const double made = nanoseconds([&] { factors->factorise(matrix); });
    Vec x;
    // An iterative solver is factorised again before each solve: it may change its method after a solve.
    const bool iterates = factors->active_method() == "conjugate_gradients";
    double solved = 0.0;
    if (iterates) {
      solved = nanoseconds([&] {
                 factors->factorise(matrix);
                 factors->solve(x = load_);
               }) -
               made;
    } else {
      solved = nanoseconds([&] { factors->solve(x = load_); });
    }
    const auto* gradients = dynamic_cast<const ConjugateGradients*>(factors.get());
    print(matrix, of, factors->active_method(), made, solved,
          gradients != nullptr ? gradients->iterations() : 1, error(x));
  }
  template <class Method>
  void measure_other(const SparseMatrix& matrix, const char* of, const char* name) const {
    Method method;
    constexpr bool iterates = requires { method.iterations(); };
    const double made = nanoseconds([&] { method.compute(matrix); });
    if constexpr (iterates) method.setTolerance(1e-14);
    Vec x;
    const double solved = nanoseconds([&] { x = method.solve(load_); });
    long iterations = 1;
    if constexpr (iterates) iterations = method.iterations();
    print(matrix, of, name, made, solved, iterations, error(x));
  }

 private:
  [[nodiscard]] double error(const Vec& x) const {
    return (x - best_).cwiseAbs().maxCoeff() / best_.cwiseAbs().maxCoeff();
  }
  Vec load_, best_;
};

SparseMatrix line(Eigen::Index n) {
  SparseMatrix matrix(n, n);
  matrix.reserve(Eigen::VectorXi::Constant(static_cast<int>(n), 3));
  const double c = strength * static_cast<double>(n + 1) * static_cast<double>(n + 1);
  for (Eigen::Index i = 0; i < n; ++i) {
    if (i > 0) matrix.insert(i - 1, i) = -c;
    matrix.insert(i, i) = 1.0 + 2.0 * c;
    if (i + 1 < n) matrix.insert(i + 1, i) = -c;
  }
  matrix.makeCompressed();
  return matrix;
}

// The sine transform of a column by the FFT of its odd extension, with Eigen's kissfft: of real values if the
// length is a multiple of 4, otherwise of two columns as the real and imaginary part of one.
double fourier_nanoseconds(const Matrix& fields) {
  const Eigen::Index n = fields.rows(), length = 2 * (n + 1);
  Eigen::internal::kissfft_impl<double> fourier;
  std::vector<std::complex<double>> pair(static_cast<std::size_t>(length)), result(pair.size());
  std::vector<double> real(pair.size());
  const auto continued = [&](auto& values, Eigen::Index i, auto value) {
    values[static_cast<std::size_t>(i + 1)] = value;
    values[static_cast<std::size_t>(length - 1 - i)] = -value;
  };
  return nanoseconds([&] {
    const bool of_real = length % 4 == 0;
    for (Eigen::Index j = 0; j + 1 < fields.cols(); j += of_real ? 1 : 2) {
      for (Eigen::Index i = 0; i < n; ++i) {
        if (of_real) {
          continued(real, i, fields(i, j));
        } else {
          continued(pair, i, std::complex<double>(fields(i, j), fields(i, j + 1)));
        }
      }
      if (of_real) {
        fourier.fwd(result.data(), real.data(), static_cast<int>(length));
      } else {
        fourier.fwd(result.data(), pair.data(), static_cast<int>(length));
      }
    }
  });
}

}  // namespace

void measure_solvers(int largest) {
  using Iterations =
      Eigen::ConjugateGradient<SparseMatrix, Eigen::Lower | Eigen::Upper, Eigen::IncompleteCholesky<double>>;
  fmt::print("unknowns | coefficients | method | made | solve | iterations | error\n");
  for (const Eigen::Index n : {1'000, 100'000}) {
    const SparseMatrix matrix = line(n);
    Compared compared(matrix);
    compared.measure_direct(matrix, "line");
    compared.measure_chosen(matrix, "line");
  }
  for (const int n : {32, 50, 100, 316, 1000}) {
    if (n > largest) break;
    for (const auto& [name, diffusivity, reaction] : coefficients()) {
      const SparseMatrix matrix = step_matrix(n, n, strength, diffusivity, reaction);
      Compared compared(matrix);
      compared.measure_direct(matrix, name);
      compared.measure_chosen(matrix, name);
      if (diffusivity != one || n > 100) continue;
      compared.measure_other<Eigen::SparseLU<SparseMatrix>>(matrix, name, "lu");
      compared.measure_other<Iterations>(matrix, name, "conjugate gradients, incomplete Cholesky");
    }
  }
}

void measure_transforms() {
  fmt::print("values | products | fast Fourier transform\n");
  for (const Eigen::Index n : {31, 100, 127, 255, 300, 316, 511, 767, 999, 1000, 1023, 2047}) {
    const Matrix fields = Matrix::Random(n, std::max<Eigen::Index>(64, 100'000 / n));
    const SineTransform transform(n);
    Matrix modes(transform.rows(), fields.cols());
    const double products = nanoseconds([&] { transform.forward(fields.data(), modes); });
    const auto values = static_cast<double>(fields.size());
    fmt::print("{} | {:.1f} | {:.1f}\n", n, products / values, fourier_nanoseconds(fields) / values);
  }
}

}  // namespace fde::bench
