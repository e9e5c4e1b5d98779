// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <ostream>
#include <string>

#include "fdebench/benchmarks/records/record_validation.hpp"
#include "fdebench/benchmarks/records/results_file.hpp"
#include "fdebench/benchmarks/requests/judged_trajectory.hpp"
#include "fdebench/reports/command/command.hpp"
#include "fdebench/reports/command/data_file.hpp"
#include "fdebench/reports/command/progress_display.hpp"

namespace fde::bench {
namespace {

// How long to wait for the lock of the results file: each `judge` locks it only to append.
constexpr std::chrono::seconds longest_wait{60};

void print(const Record& run, const std::optional<ChiSquared>& chi_squared, std::ostream& out) {
  const auto print_values = [&](const QuantityValues& values) {
    for (const auto& [quantity, value] : values) {
      const auto unit = unit_of(quantity);
      out << fmt::format("{} {}{}{}\n", quantity, value, unit.empty() ? "" : " ", unit);
    }
  };
  out << fmt::format("scene {}\nrows {}\n", label_of(run.key.scene), run.steps);
  print_values(run.values);
  if (chi_squared) out << text_of(*chi_squared);
  out << fmt::format("ending {}\n", sentence(run.ending));
  print_values(run.timing.values);
}

JudgedTrajectory judged(const Given& given, const Streams& streams, const SceneRegistry& known) {
  const auto file = given.text("file");
  std::optional<ProgressLine> line;
  JudgeRequest request{.variant = read_variant(given, known), .trajectory = [&](const Scene& scene) {
                         auto path = read_data(file, scene);
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
  const auto [run, description, chi_squared] = judged(given, streams, known);
  if (const auto out = given.find("--out")) {
    ResultsFile file(*out, longest_wait);
    warn(streams, file.warning());
    if (!file.describes(run.key.scene)) file.append(description());
    file.append(run);
  }
  print(run, chi_squared, streams.out);
}

}  // namespace

Command judge_command() {
  return {
      {"judge",
       "Measure",
       "Judge a trajectory that another program wrote",
       {scene_argument(),
        set_argument(),
        {"FILE",
         "CSV with the header t,COLUMN,... of the scene, of measurements also sd_COLUMN; - is standard input",
         Completion::file},
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
