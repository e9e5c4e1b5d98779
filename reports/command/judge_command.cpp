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

#include "fdebench/benchmarks/external/process_cleanup.hpp"
#include "fdebench/benchmarks/records/record_validation.hpp"
#include "fdebench/benchmarks/records/results_file.hpp"
#include "fdebench/benchmarks/requests/judged_trajectory.hpp"
#include "fdebench/reports/command/command.hpp"
#include "fdebench/reports/command/progress_display.hpp"

namespace fde::bench {
namespace {

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

void print(const Record& run, std::ostream& out) {
  const auto print_values = [&](const QuantityValues& values) {
    for (const auto& [quantity, value] : values) {
      const auto unit = unit_of(quantity);
      out << fmt::format("{} {}{}{}\n", quantity, value, unit.empty() ? "" : " ", unit);
    }
  };
  out << fmt::format("scene {}\nrows {}\n", label_of(run.key.scene), run.steps);
  print_values(run.values);
  out << fmt::format("ending {}\n", sentence(run.ending));
  print_values(run.timing.values);
}

JudgedTrajectory judged(const Given& given, const Streams& streams, const SceneRegistry& known) {
  const auto file = given.text("file");
  std::optional<ProgressLine> line;
  JudgeRequest request{.variant = read_variant(given, known), .trajectory = [&](const Scene& scene) {
                         auto path = path_in(file, scene);
                         line.emplace(streams, "evaluates the reference");
                         return path;
                       }};
  if (given.has("--name") || given.has("--out"))
    request.name = given.find("--name").value_or(std::filesystem::path(file).stem().string());
  if (given.has("--seconds")) request.seconds = given.numbers("--seconds");
  try {
    return judge(request);
  } catch (const Refusal& refusal) {
    given.refuse(refusal, {{"trajectory", file}});
  }
}

void print_judged(const Given& given, const Streams& streams, const SceneRegistry& known) {
  const auto [run, description] = judged(given, streams, known);
  if (const auto out = given.find("--out")) {
    ResultsFile file(*out, longest_wait);
    warn(streams, file.warning());
    if (!file.describes(run.key.scene)) file.append(description());
    file.append(run);
  }
  print(run, streams.out);
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
          print_judged};
}

}  // namespace fde::bench
