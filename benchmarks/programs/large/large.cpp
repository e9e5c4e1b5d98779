// SPDX-License-Identifier: MIT
// The cost of a step of a large problem: diffusion on a line and on a square, L1 with order 1/2, 1000 steps.
// Each row is measured in a separate process, so that its memory is not mixed with other rows'. Prints the
// wall time of the run in seconds, then CPU nanoseconds per unknown and step (whole run, its parts run
// separately, bare loops) and bytes per unknown.
//   fde_figures large             10^3 ... 10^6 unknowns, on the line and on the square
//   fde_figures large D N [T]     one row: D = 1 or 2 dimensions, N unknowns, T threads
//   fde_figures large solvers [N] solvers for the equations of a step, on squares of up to N x N points
//   fde_figures large transforms  sine transforms by matrix products and by a fast Fourier transform
//   fde_figures large direct      the history by direct sums instead of exponentials

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <stdexcept>
#include <string>

#include "fdebench/benchmarks/programs/figures.hpp"
#include "fdebench/benchmarks/programs/google/bare_loop.hpp"
#include "fdebench/benchmarks/programs/large/solvers.hpp"
#include "fdebench/benchmarks/scenes/registry.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/schemes/history/exponential_memory.hpp"
#include "fdebench/schemes/history/history.hpp"
#include "fdebench/schemes/history/weights/weights.hpp"
#include "fdebench/schemes/solvers/sparse_factors.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench::figures {
namespace {

constexpr int all_steps = 1000;
constexpr double order_of_l1 = 0.5;

struct Row {
  int dimensions;
  Eigen::Index unknowns;
  int threads;
};

double seconds_of(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// CPU time of all threads of this process: the machine may have other load.
double processor_seconds_of(const auto& work) {
  const auto start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

Scene scene_of(const Row& row) {
  const auto points = std::round(std::pow(static_cast<double>(row.unknowns), 1.0 / row.dimensions));
  const bool line = row.dimensions == 1;
  const auto& factory = built_in_scenes().named(line ? "fractional_diffusion" : "fractional_diffusion_2d");
  return make_scene(factory, {{"gamma", order_of_l1}, {line ? "components" : "n", points}});
}

// Mean CPU seconds of a step of the history alone, over `count` steps.
double history_seconds(const Row& row, HistoryKind kind, int count) {
  const auto size = static_cast<std::size_t>(row.unknowns);
  const auto history = make_history(kind, {std::vector<WeightTable>(size, {&families::l1, order_of_l1})},
                                    step_plan({.end = 1.0, .steps = all_steps}), 1e-15);
  const Vec sample = Vec::LinSpaced(row.unknowns, 0.5, 1.5);
  Vec sums(row.unknowns);
  const auto some = [&](int from, int to) {
    for (int n = from; n < to; ++n) {
      history->push(n, sample);
      history->convolve(n + 1, 0, sums);
    }
  };
  some(0, 33);  // touches all of its memory
  return processor_seconds_of([&] { some(33, 33 + count); }) / count;
}

// The matrix 1 - kappa A of a step.
SparseMatrix matrix_of_step(const Scene& scene) {
  const auto& matrix = std::get<SparseLinearPart>(scene.problem.derivatives).matrix;
  StepFactors factors({WeightTable{&families::l1, order_of_l1}});
  SparseMatrix step(matrix.rows(), matrix.cols());
  step.setIdentity();
  step -= factors.at(1.0 / all_steps)[0] * matrix;
  return step;
}

int count_of_solves(Eigen::Index unknowns) {
  return static_cast<int>(std::clamp<Eigen::Index>(2'000'000 / unknowns, 4, 400));
}

struct Solving {
  std::string_view method;
  double once, each;  // CPU seconds: of the factorisation, and of a solve
};

Solving solving_seconds(const Scene& scene) {
  const SparseMatrix step = matrix_of_step(scene);
  std::unique_ptr<SparseFactors> made;
  const double once = processor_seconds_of([&] { made = sparse_factors(step); });
  Vec b = Vec::LinSpaced(step.rows(), -1.0, 1.0);
  const int count = count_of_solves(step.rows());
  const double each = processor_seconds_of([&] {
    for (int i = 0; i < count; ++i) made->solve(b);
  });
  return {made->active_method(), once, each / count};
}

Eigen::Index exponentials() {
  return exponential_sum(order_of_l1, ExponentialMemory::shortest_lag, all_steps + 2.0, 1e-15).nodes.size();
}

// Lower bound by memory bandwidth, per step: the states of the exponentials and their compensation terms are
// read and written once per block of steps.
double streaming_seconds(Eigen::Index unknowns) {
  Vec states = Vec::Ones(2 * exponentials() * unknowns);
  const auto stream = [&] { states.array() += 1.0; };
  stream();
  const int count = static_cast<int>(std::clamp<Eigen::Index>(20'000'000 / unknowns / 40, 2, 1000));
  const double taken = processor_seconds_of([&] {
    for (int i = 0; i < count; ++i) stream();
  });
  return taken / count / ExponentialMemory::block;
}

// Lower bound by arithmetic: the multiply-adds of a step in a vectorised loop on data in the cache.
double arithmetic_seconds(Eigen::Index unknowns) {
  constexpr Eigen::Index block = ExponentialMemory::block, columns = 8;
  const Eigen::Index near = ExponentialMemory::recent + block / 2, inner = 2 * exponentials() + near;
  const Matrix a = Matrix::Random(block, inner), b = Matrix::Random(inner, columns);
  Matrix c = Matrix::Zero(block, columns);
  constexpr int count = 20'000;
  const double taken = processor_seconds_of([&] {
    for (int i = 0; i < count; ++i) bare_multiply_add(inner, columns, a.data(), b.data(), c.data());
  });
  return taken / count / (block * columns) * static_cast<double>(unknowns);
}

// Peak resident memory of this process.
double bytes_in_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

void measure(const Row& row) {
  const double before = bytes_in_memory(), unknowns = static_cast<double>(row.unknowns);
  Trajectory path;
  double taken = 0.0, whole = 0.0, most = 0.0;
  Solving solving{};
  double error = 0.0;
  {
    const Scene scene = scene_of(row);
    const Options options{.threads = row.threads, .output_times = {1.0}};
    const auto run = [&] { path = find_scheme("l1")->solve(scene.problem, Grid{1.0, all_steps}, options); };
    taken = seconds_of([&] { whole = processor_seconds_of(run); });
    most = bytes_in_memory() - before;
    error =
        (columns_at(scene.outputs, 1.0, path.y.col(0)) - scene.reference.at(1.0).value).cwiseAbs().maxCoeff();
    solving = solving_seconds(scene);
  }
  const int blocks = static_cast<int>(std::clamp<Eigen::Index>(10'000'000 / row.unknowns / 32, 2, 30));
  const double known = history_seconds(row, HistoryKind::exponentials, 32 * blocks);
  const auto each = [&](double seconds) { return 1e9 * seconds / unknowns; };
  const double rest = (whole - solving.once) / all_steps - known - solving.each;
  fmt::print(
      "{} | {:.0e} | {} | {:.1f} | {:.1f} | {:.1f} | {:.1f} | {:.1f} | {:.1f} | {:.1f} | {} | {:.1f} | "
      "{:.0f} | {:.0f} | {:.2e}\n",
      row.dimensions, unknowns, row.threads, taken, each(whole / all_steps), each(known), each(solving.each),
      each(rest), each(streaming_seconds(row.unknowns)), each(arithmetic_seconds(row.unknowns)),
      solving.method, solving.once, static_cast<double>(*path.cost.history_bytes) / unknowns, most / unknowns,
      error);
}

// Direct history sums for 10^4 unknowns; the cost is linear in the unknowns and quadratic in the steps.
void measure_direct() {
  const Row row{1, 10'000, 1};
  const double mean = history_seconds(row, HistoryKind::direct, all_steps - 33);
  fmt::print("direct: {:.1f} ns an unknown and step, of {} steps; 10^6 unknowns: {:.0f} s and {:.1f} GB\n",
             1e9 * mean / 1e4, all_steps, 100.0 * mean * all_steps, 8e-9 * 1e6 * all_steps);
}

// Runs `work` in a child process.
void apart(const auto& work) {
  std::fflush(stdout);
  if (const pid_t child = fork(); child == 0) {
    work();
    std::fflush(stdout);
    _exit(0);
  } else {
    waitpid(child, nullptr, 0);
  }
}

void measure_all() {
  for (const int dimensions : {1, 2}) {
    for (const Eigen::Index unknowns : {1'000, 10'000, 100'000, 1'000'000}) {
      const auto points = std::lround(std::sqrt(unknowns));
      apart([&] { measure({dimensions, dimensions == 1 ? unknowns : points * points, 1}); });
    }
  }
  for (const int dimensions : {1, 2}) apart([&] { measure({dimensions, 1'000'000, 2}); });
  apart(measure_direct);
}

}  // namespace

void large(const Words& words) {
  const std::string what = words.empty() ? "" : words[0];
  if (what == "solvers") return measure_solvers(words.size() > 1 ? std::stoi(words[1]) : 1000);
  if (what == "transforms") return measure_transforms();
  if (what == "direct") return measure_direct();
  if (words.size() == 1) throw std::invalid_argument("large [solvers [N] | transforms | direct | D N [T]]");
  fmt::print(
      "dimensions | unknowns | threads | run [s] | step | history | solve | rest | bare streaming | bare "
      "arithmetic | "
      "solver | factors [s] | history bytes | bytes | error\n");
  if (words.empty()) return measure_all();
  measure({std::stoi(words[0]), std::stol(words[1]), words.size() > 2 ? std::stoi(words[2]) : 1});
}

}  // namespace fde::bench::figures
