#include <fmt/ostream.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <optional>
#include <ostream>

#include "answer.hpp"
#include "arguments.hpp"
#include "command.hpp"
#include "record.hpp"
#include "report.hpp"
#include "sweep.hpp"

namespace fde {
namespace {

constexpr int most_repeats = 1000;
const std::vector<int> default_steps{64, 128, 256, 512, 1024, 2048, 4096, 8192, 32768, 131072, 524288};

struct RunArguments {
  std::vector<std::string> scenes, schemes;
  std::optional<std::string> steps;
  std::string repeats = "3", out;
};

struct ChooseArguments {
  std::string scene, error;
  std::optional<std::string> results;
};

std::vector<SceneVariant> chosen_scenes(const std::vector<std::string>& texts) {
  if (texts.empty()) return sweep_scenes();
  std::vector<SceneVariant> variants;
  for (const auto& text : texts) variants.push_back(parse_variant(text));
  return variants;
}

std::vector<const Scheme*> chosen_schemes(const std::vector<std::string>& ids) {
  std::vector<const Scheme*> entries;
  if (ids.empty()) {
    for (const auto& scheme : schemes()) entries.push_back(&scheme);
  }
  for (const auto& id : ids) entries.push_back(&scheme_named(id));
  return entries;
}

void run(const RunArguments& arguments, const Streams& streams) {
  Sweep sweep{.scenes = chosen_scenes(arguments.scenes),
              .schemes = chosen_schemes(arguments.schemes),
              .steps = default_steps,
              .repeats = parse_count("--repeat", arguments.repeats, 1, most_repeats)};
  if (arguments.steps) {
    sweep.steps.clear();
    for (const auto& text : split_list(*arguments.steps)) {
      sweep.steps.push_back(parse_count("--steps", text, 1, most_steps));
    }
  }
  ResultsFile file(arguments.out);
  run_sweep(sweep, {.has = [&](const auto& scene, const auto& scheme,
                               int steps) { return file.has(scene, scheme, steps); },
                    .append = [&](const auto& rows) { file.append(rows); },
                    .progress = progress_line(streams)});
  fmt::print(streams.out, "{}\n", std::filesystem::absolute(arguments.out).string());
}

// The results of the default sweep of one scene, measured now.
Results measure(const SceneVariant& scene, const Streams& streams) {
  Results results;
  results.sessions.push_back(this_session());
  Sweep sweep{.scenes = {scene}, .schemes = chosen_schemes({}), .steps = default_steps};
  run_sweep(
      sweep,
      {.has = [](const auto&, const auto&, int) { return false; },
       .append = [&](const auto& rows) { std::ranges::copy(rows, std::back_inserter(results.records)); },
       .progress = progress_line(streams)});
  return results;
}

void choose(const ChooseArguments& arguments, const Streams& streams) {
  const auto scene = parse_variant(arguments.scene);
  const double error = parse_number("--error", arguments.error, positive);
  const Results results = arguments.results ? read_results(*arguments.results) : measure(scene, streams);
  streams.out << advice(results, scene.label(), error);
}

}  // namespace

void add_sweep_commands(CLI::App& app, const Streams& streams) {
  auto of_run = std::make_shared<RunArguments>();
  auto* run_command = app.add_subcommand("run", "Measure schemes on scenes; a file that exists is continued");
  run_command->add_option("--scene", of_run->scenes, "ids of scenes, or ID:NAME=VALUE,...; default all")
      ->take_all();
  run_command->add_option("--scheme", of_run->schemes, "ids of schemes; default all")->take_all();
  run_command->add_option("--steps", of_run->steps, "numbers of steps N1,N2,...");
  run_command->add_option("--repeat", of_run->repeats, "timed repeats of each run");
  run_command->add_option("--out", of_run->out, "results file")->required();
  run_command->callback([=] { run(*of_run, streams); });

  auto file = std::make_shared<std::string>(), folder = std::make_shared<std::string>();
  auto* report_command = app.add_subcommand("report", "Write the report page of a results file");
  report_command->add_option("file", *file, "results file")->required();
  report_command->add_option("--out", *folder, "folder of the page")->required();
  report_command->callback(
      [=] { fmt::print(streams.out, "{}\n", write_report(read_results(*file), *folder).string()); });

  auto of_choose = std::make_shared<ChooseArguments>();
  auto* choose_command = app.add_subcommand("choose", "The cheapest scheme for a scene and an accuracy");
  choose_command->add_option("scene", of_choose->scene, "id of the scene, or ID:NAME=VALUE,...")->required();
  choose_command->add_option("--error", of_choose->error, "largest error wanted at the end")->required();
  choose_command->add_option("--results", of_choose->results, "results file; default: measure now");
  choose_command->callback([=] { choose(*of_choose, streams); });
}

}  // namespace fde
