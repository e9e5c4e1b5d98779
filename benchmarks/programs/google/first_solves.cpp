// SPDX-License-Identifier: MIT
// What the first solve of a process takes, in processor time.
//   first/PROBLEM/ACCURACY   the first solve by spectral_collocation, with its tables, page faults and cold
//                            caches, each in a process of its own
//   later/PROBLEM/ACCURACY   the fastest of many solves after the first
//   rows/FORM/N              spectral_collocation for N rows of stiff diffusion, to 1e-11; FORM of the
//                            Jacobian: sparse or dense
//   panel_rule/POINTS        the tables of the panels, which a process retains
//   start/COMMAND            a whole process, in the folder of this program

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <string>
#include <variant>

#include "fdebench/benchmarks/equation_files/equation_scene.hpp"
#include "fdebench/benchmarks/scenes/registry.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
#include "fdebench/schemes/rules/spectral/panel_rule.hpp"
#include "fdebench/schemes/stepping/scheme.hpp"
#include "fdebench/schemes/stepping/setup_time.hpp"

namespace {

using namespace fde;
using namespace fde::bench;

double seconds_of_solve(const Problem& problem, double accuracy) {
  const Options options{.output_times = {problem.end}};
  const double start = thread_seconds();
  const Trajectory path =
      find_scheme("spectral_collocation")->solve(problem, Tolerance{accuracy, accuracy}, options);
  const double seconds = thread_seconds() - start;
  return path.status == SolveStatus::finished ? seconds : std::numeric_limits<double>::quiet_NaN();
}

// In a process of its own: prints the seconds of the first solve and of the fastest later one.
void print_times(const std::string& id, double accuracy) {
  constexpr int repetitions = 32;
  const Problem problem = make_scene(with_equation_files(built_in_scenes()).named(id)).problem;
  const double first = seconds_of_solve(problem, accuracy);
  double later = first;
  for (int k = 0; k < repetitions; ++k) later = std::min(later, seconds_of_solve(problem, accuracy));
  fmt::print("{} {}\n", first, later);
}

struct Command {
  explicit Command(const std::string& line) : output(popen(line.c_str(), "r")) {}
  ~Command() { pclose(output); }
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;
  std::FILE* output;
};

void solve(benchmark::State& state, const std::string& program, const std::string& id, double accuracy,
           bool first) {
  for (auto _ : state) {
    const Command process(fmt::format("{} --times {} {}", program, id, accuracy));
    double of_first = 0.0, of_later = 0.0;
    if (std::fscanf(process.output, "%lf %lf", &of_first, &of_later) != 2 || std::isnan(of_later))
      return state.SkipWithError("the solve fails");
    state.SetIterationTime(first ? of_first : of_later);
  }
}

void solve_rows(benchmark::State& state, bool dense) {
  Problem problem =
      make_scene(parse_variant(fmt::format("fractional_diffusion:components={}", state.range(0)))).problem;
  if (dense) problem.derivatives = DenseLinearPart{std::get<SparseLinearPart>(problem.derivatives).matrix};
  for (auto _ : state) benchmark::DoNotOptimize(seconds_of_solve(problem, 1e-11));
}
BENCHMARK_CAPTURE(solve_rows, sparse, false)
    ->Name("rows/sparse")
    ->Arg(11)
    ->Arg(24)
    ->Arg(96)
    ->Arg(384)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve_rows, dense, true)
    ->Name("rows/dense")
    ->Arg(11)
    ->Arg(24)
    ->Arg(96)
    ->Unit(benchmark::kMillisecond);

void make_panel_rule(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(PanelRule(state.range(0)));
}
BENCHMARK(make_panel_rule)->Name("panel_rule")->Arg(12)->Arg(20)->Unit(benchmark::kMicrosecond);

void start_process(benchmark::State& state, const std::string& command) {
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  for (auto _ : state) {
    const pid_t child = fork();
    if (child == 0) {
      execl("/bin/sh", "sh", "-c", ("exec " + command + " > /dev/null").c_str(), nullptr);
      _exit(EXIT_FAILURE);
    }
    int status = 0;
    rusage used{};
    wait4(child, &status, 0, &used);
    if (status != 0) return state.SkipWithError("the command fails");
    state.SetIterationTime(seconds(used.ru_utime) + seconds(used.ru_stime));
  }
}

// To be read by their medians.
void set_repetitions(benchmark::internal::Benchmark& benchmark) {
  constexpr int processes = 21;
  benchmark.Iterations(1)->Repetitions(processes)->DisplayAggregatesOnly()->UseManualTime();
}

void register_benchmarks(const std::string& program) {
  for (const std::string id :
       {"relaxation", "diethelm", "pendulum", "brusselator", "docs/examples/multi_order.toml"}) {
    for (const double accuracy : {1e-8, 1e-10, 1e-12}) {
      for (const bool first : {true, false}) {
        const auto name = fmt::format("{}/{}/{:.0e}", first ? "first" : "later", id, accuracy);
        set_repetitions(*benchmark::RegisterBenchmark(name.c_str(), solve, program, id, accuracy, first)
                             ->Unit(benchmark::kMicrosecond));
      }
    }
  }
  const std::string folder = program.substr(0, program.rfind('/'));
  for (const std::string command :
       {"--version", "solve relaxation --scheme spectral_collocation --accuracy 1e-12 --at 1"}) {
    set_repetitions(*benchmark::RegisterBenchmark(("start/fdebench " + command).c_str(), start_process,
                                                  fmt::format("{}/fdebench {}", folder, command))
                         ->Unit(benchmark::kMillisecond));
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count == 4 && std::string(arguments[1]) == "--times") {
    print_times(arguments[2], std::stod(arguments[3]));
    return 0;
  }
  register_benchmarks(*arguments);
  benchmark::Initialize(&count, arguments);
  if (benchmark::ReportUnrecognizedArguments(count, arguments)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  return 0;
}
