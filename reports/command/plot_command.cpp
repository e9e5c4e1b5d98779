#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "analysis/runs.hpp"
#include "command/arguments.hpp"
#include "command/command.hpp"
#include "command/command_line.hpp"
#include "external/shell_command.hpp"
#include "external/temporary_file.hpp"
#include "page/assets.hpp"
#include "page/page_data.hpp"
#include "scenes/variant.hpp"

namespace fde {
namespace {

struct PlotArguments {
  SceneArguments scene;
  std::string results, kind, out;
};

// What a figure is called here, and the chart of the page that it is.
constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kinds{
    {{"work-precision", "error-against-time"},
     {"rate", "error-against-step"},
     {"accuracy", "delivered-against-asked"},
     {"energy", "energy-against-step"},
     {"solution", "solution"}}};
constexpr double most_seconds = 120.0;
constexpr std::uint64_t most_bytes = std::uint64_t{1} << 20;

std::string_view chart_named(const std::string& kind) {
  const auto* const found =
      std::ranges::find(kinds, kind, &std::pair<std::string_view, std::string_view>::first);
  if (found != kinds.end()) return found->second;
  std::vector<std::string_view> names;
  for (const auto& [name, chart] : kinds) names.push_back(name);
  throw std::invalid_argument(fmt::format("--kind = {}: must be one of {}", kind, fmt::join(names, ", ")));
}

void check_ending(const std::string& out) {
  if (out.ends_with(".svg") || out.ends_with(".vl.json")) return;
  throw std::invalid_argument(fmt::format("--out = {}: must end in .svg or .vl.json", out));
}

// Of this scene alone.
nlohmann::json data_of(const PlotArguments& arguments, const Scenes& known) {
  const SceneSettings scene = read_variant(arguments.scene, known).key();
  ReadRuns read = read_runs(arguments.results, known);
  for (auto* some : {&read.runs.finished, &read.runs.failed})
    std::erase_if(*some, [&](const MeasuredRun& run) { return run.key.scene != scene; });
  if (read.runs.finished.empty())
    throw std::invalid_argument(fmt::format("{}: has no run of {}", arguments.results, label_of(scene)));
  return page_data(std::move(read));
}

std::string first_line_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  return line;
}

void plot(const PlotArguments& arguments, const Streams& streams, const Scenes& known) {
  const auto chart = chart_named(arguments.kind);
  check_ending(arguments.out);
  const auto out = std::filesystem::absolute(arguments.out);
  const TemporaryFile script(".cjs"), request(".json"), said(".txt"), complained(".txt");
  script.write(assets::plot());
  request.write(nlohmann::json{{"data", data_of(arguments, known)},
                               {"charts", assets::charts()},
                               {"chart", chart},
                               {"kind", "error_maximum_mixed"},
                               {"modules", FDEBENCH_NODE_MODULES},
                               {"out", out.string()}}
                    .dump());
  const auto end = run_command(fmt::format("node '{}'", script.path().string()), request.path().string(),
                               said.descriptor(), complained.descriptor(), {most_seconds, most_bytes});
  if (end.how != CommandEnd::How::exited || end.code != 0) {
    throw std::invalid_argument(
        fmt::format("{}: cannot be drawn by node: {}", arguments.out, first_line_of(complained.path())));
  }
  streams.out << out.string() << '\n';
}

}  // namespace

void add_plot_command(CommandLine& program, const Streams& streams, const Scenes& known) {
  auto arguments = std::make_shared<PlotArguments>();
  Subcommand command(program, "plot", "A figure of a scene for a paper of two columns");
  add_scene(command, arguments->scene);
  command.required("--results", arguments->results, "results file");
  command.required("--kind", arguments->kind, "work-precision, rate, accuracy, energy or solution");
  command.required("--out", arguments->out, "the figure: .svg, or .vl.json for its Vega-Lite specification");
  command.callback([=, &known] { plot(*arguments, streams, known); });
}

}  // namespace fde
