// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "fdebench/benchmarks/external/process_cleanup.hpp"
#include "fdebench/benchmarks/measures/measures.hpp"
#include "fdebench/benchmarks/records/external_trajectory.hpp"
#include "fdebench/benchmarks/records/record_validation.hpp"
#include "fdebench/benchmarks/records/results_file.hpp"
#include "fdebench/benchmarks/sweep/described_scene.hpp"
#include "fdebench/reports/command/command.hpp"
#include "fdebench/reports/command/progress_display.hpp"

namespace fde::bench {
namespace {

// Sets the end of the scene to the last time of the trajectory, so that the error at the end is at that time.
// Throws std::invalid_argument for a two-sided problem, whose solution depends on its end.
void end_with(const ExternalTrajectory& path, const std::string& file, SceneVariant& variant, Scene& scene) {
  const double last = path.times.back(), end = scene.problem.end;
  if (last == end) return;
  if (is_two_sided(scene.problem)) {
    throw std::invalid_argument(fmt::format("{}: ends at t = {}, scene {} is posed at both ends, 0 and {}",
                                            file, last, variant.factory->id, end));
  }
  variant.until = last;
  set_end(scene, last);
}

constexpr std::uintmax_t most_bytes_of_pipe = std::uintmax_t{1} << 30;

// Copies a pipe to a temporary file; nullptr if the name is not a pipe.
std::unique_ptr<const TemporaryFile> file_of_pipe(const std::string& name) {
  const std::filesystem::path path = name == "-" ? "/dev/stdin" : name;
  std::error_code ignored;
  if (!std::filesystem::is_fifo(path, ignored)) return nullptr;
  std::ifstream stream(path, std::ios::binary);
  auto file = std::make_unique<const TemporaryFile>(".csv");
  std::string buffer(std::size_t{1} << 16, '\0');
  for (std::uintmax_t bytes = 0; stream;) {
    stream.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
    const auto count = static_cast<std::size_t>(stream.gcount());
    bytes += count;
    if (bytes > most_bytes_of_pipe)
      throw std::invalid_argument(fmt::format("{}: is longer than {} bytes", name, most_bytes_of_pipe));
    file->write(std::string_view(buffer).substr(0, count));
  }
  return file;
}

ExternalTrajectory path_in(const std::string& file, const Scene& scene) {
  const auto piped = file_of_pipe(file);
  if (piped) return read_trajectory(piped->path(), scene, file == "-" ? "standard input" : file);
  return file == "-" ? read_trajectory("/dev/stdin", scene, "standard input") : read_trajectory(file, scene);
}

// How long to wait for the lock of the results file: each `judge` locks it only to append.
constexpr std::chrono::seconds longest_wait{60};

// A run without an assessment. The settings of the other program are unknown.
Record run_of(const SceneVariant& scene, const std::string& name, const ExternalTrajectory& path) {
  const auto steps = static_cast<int>(path.times.size());
  return {.key = {.scene = scene.key(), .scheme = name, .settings = {.resolution = steps}, .external = true},
          .steps = steps,
          .end = path.times.back(),
          .program = path.report.facts};
}

void print(const SceneVariant& scene, const Record& run, std::ostream& out) {
  const auto print_values = [&](const QuantityValues& values) {
    for (const auto& [quantity, value] : values) {
      const auto unit = unit_of(quantity);
      out << fmt::format("{} {}{}{}\n", quantity, value, unit.empty() ? "" : " ", unit);
    }
  };
  out << fmt::format("scene {}\nrows {}\n", scene.label(), run.steps);
  print_values(run.values);
  out << fmt::format("ending {}\n", sentence(run.ending));
  print_values(run.timing.values);
}

void judge(const Given& given, const Streams& streams, const SceneRegistry& known) {
  auto variant = read_variant(given, known);
  Scene scene = make_scene(variant);
  const auto file_name = given.text("file");
  const auto out = given.find("--out");
  const auto name = given.find("--name").value_or(std::filesystem::path(file_name).stem().string());
  if (given.has("--name") || out) require_external_name("--name", name);
  std::vector<double> seconds;
  if (given.has("--seconds")) seconds = given.numbers("--seconds");
  const auto path = path_in(file_name, scene);
  if (!given.has("--seconds")) seconds = path.report.seconds;
  end_with(path, file_name, variant, scene);
  MemoizedReference reference(scene);
  const auto judgement = [&] {
    ProgressLine line(streams, "evaluates the reference");
    return judge_trajectory(scene, at_comparison_times(path), reference);
  }();
  Record run = assessed(run_of(variant, name, path), judgement);
  if (!seconds.empty() && is_compared(run.ending.kind)) run.timing = timing_of({.seconds = seconds});
  std::optional<ResultsFile> file;
  if (out) file.emplace(*out, longest_wait);
  if (file) warn(streams, file->warning());
  if (file && !file->describes(run.key.scene)) file->append(describe(variant, scene, reference));
  if (file) file->append(run);
  print(variant, run, streams.out);
}

}  // namespace

Command judge_command() {
  return {{"judge",
           "Measure",
           "Judge a trajectory that another program wrote",
           {scene_argument(),
            set_argument(),
            {"FILE", "CSV with the header t,COLUMN,... of the scene; - is standard input", Completion::file},
            {"[--seconds S1,S2,...]", "time of the other program, or the times of its repeats", positive,
             "that of the file's line '# seconds: S'"},
            {"[--name NAME]", "what to call the other program", {}, "the name of the file"},
            {"[--out RESULTS]", "results file that the run is added to", Completion::results}},
           {{"fdebench judge relaxation mine.csv", "prints the errors of a solution in a file."},
            {"fdebench judge relaxation - --seconds 0.0052 --name numpy --out results.jsonl < mine.csv",
             "adds errors and time to a results file."}},
           {"run", "report", "accuracy"}},
          judge};
}

}  // namespace fde::bench
