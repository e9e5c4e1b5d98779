// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <ostream>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "fdebench/benchmarks/external/process_cleanup.hpp"
#include "fdebench/benchmarks/files/atomic_file.hpp"
#include "fdebench/benchmarks/measures/error_kind.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/benchmarks/text/printable.hpp"
#include "fdebench/reports/analysis/compared_columns.hpp"
#include "fdebench/reports/command/command.hpp"
#include "fdebench/reports/command/data_file.hpp"
#include "fdebench/reports/command/drawing_program.hpp"
#include "fdebench/reports/command/figure_style.hpp"
#include "fdebench/reports/command/orders_table.hpp"
#include "fdebench/reports/command/plot_data.hpp"
#include "fdebench/reports/command/progress_display.hpp"
#include "fdebench/reports/command/recorded_scene.hpp"
#include "fdebench/reports/page/assets.hpp"

namespace fde::bench {
namespace {

// The source of a figure's data.
enum class FigureData { runs, drifts, orders, solution, measurements, regions };
struct FigureKind {
  std::string_view name, chart,
      family;  // the charts of the page that it draws: for one scene; for several values of a parameter
  FigureData of;
  bool depends_on_columns_only = false;
};
constexpr std::array kinds{FigureKind{"work-precision", "error-against-time", "", FigureData::runs},
                           FigureKind{"memory", "error-against-memory", "", FigureData::runs},
                           FigureKind{"rate", "error-against-step", "", FigureData::runs},
                           FigureKind{"accuracy", "delivered-against-requested", "", FigureData::runs},
                           FigureKind{"energy", "energy-against-step", "", FigureData::runs},
                           FigureKind{"drift", "drift-against-step", "", FigureData::drifts},
                           FigureKind{"drift-over-time", "drift-over-time", "", FigureData::drifts},
                           FigureKind{"orders", "", "", FigureData::orders},
                           FigureKind{"solution", "solution", "family", FigureData::solution, true},
                           FigureKind{"phase", "phase-portrait", "family-phase", FigureData::solution, true},
                           FigureKind{"motion", "motion", "", FigureData::solution},
                           FigureKind{"residuals", "residuals", "", FigureData::measurements},
                           FigureKind{"stability", "stability-regions", "", FigureData::regions}};

Words kind_names() {
  Words names;
  for (const FigureKind& kind : kinds) names.emplace_back(kind.name);
  return names;
}

const FigureKind& kind_named(const std::string& name) {
  return *std::ranges::find(kinds, name, &FigureKind::name);
}

ErrorKind error_kind(const Given& given) {
  return {.norm = parse_norm(given.word("--norm")), .scale = parse_scale(given.word("--scale"))};
}

void check(const Given& given, const FigureKind& kind) {
  error_kind(given);
  const auto out = given.text("--out");
  const auto ends = [&](std::string_view end) { return out.ends_with(end); };
  const bool is_table = kind.of == FigureData::orders;
  if (is_table ? !ends(".tex") && !ends(".csv") : !ends(".svg") && !ends(".pdf") && !ends(".vl.json")) {
    throw std::invalid_argument(fmt::format(
        "--out = {}: must end in {}", out, is_table ? ".tex or .csv, as a table" : ".svg, .pdf or .vl.json"));
  }
  const bool measured = is_table || kind.of == FigureData::runs || kind.of == FigureData::drifts;
  if (measured && !given.has("--results")) {
    throw std::invalid_argument(
        fmt::format("--results: --kind {} draws runs, and needs a results file", kind.name));
  }
  if (kind.of == FigureData::measurements && !given.has("--data")) {
    throw std::invalid_argument(
        fmt::format("--data: --kind {} draws measurements, and needs a file of them", kind.name));
  }
  const auto refuse = [&](const std::string& option, const char* what) {
    throw std::invalid_argument(fmt::format("{} = {}: --kind {} draws no {}: must not be given", option,
                                            given.all(option).front(), kind.name, what));
  };
  if (given.has("--data") && kind.of != FigureData::measurements) refuse("--data", "measurements");
  if (given.has("--scheme") && (kind.of == FigureData::solution || kind.of == FigureData::measurements))
    refuse("--scheme", "schemes");
  for (const auto* option : {"--scale", "--norm"})
    if (given.has(option) && kind.of != FigureData::runs && !is_table) refuse(option, "errors");
  if (given.find("--legend") == "labels" && kind.of != FigureData::runs)
    refuse("--legend", "errors, whose lines have labels");
  if (is_table) {
    for (const ArgumentText& option : style_arguments())
      if (given.has(option.name)) refuse(option.name, "figure");
    if (given.all("scene").size() > 1)
      throw std::invalid_argument("SCENE: --kind orders writes a table of one scene");
  }
  if (given.has("--columns") && !kind.depends_on_columns_only) {
    throw std::invalid_argument(fmt::format(
        "--columns = {}: must be given with --kind solution or phase only", given.text("--columns")));
  }
}

nlohmann::json data_of_results(const std::string& named, const Given& given, const FigureKind& kind,
                               const Streams& streams, const SceneRegistry& known) {
  const auto results = given.text("--results");
  ReadRuns read = read_runs(results);
  warn(streams, read.warning);
  // A figure of drifts has all formulations of the scene.
  const auto* any = kind.of == FigureData::drifts ? "formulation" : "";
  const auto scene = recorded_scene(read.runs, results, named, given.all("--set"), known, any);
  if (kind.of == FigureData::runs) warn(streams, not_compared_text(read.runs, scene));
  return kind.of == FigureData::runs ? data_of_runs(std::move(read), scene)
                                     : data_of_drifts(std::move(read), scene);
}

nlohmann::json data_of(const std::string& named, const Given& given, const FigureKind& kind,
                       const Streams& streams, const SceneRegistry& known) {
  switch (kind.of) {
    case FigureData::runs:
    case FigureData::drifts:
      return data_of_results(named, given, kind, streams, known);
    case FigureData::orders:  // a table, of no data for a chart
      break;
    case FigureData::solution:
      return data_of_solutions(read_variants(named, given.all("--set"), known), given.has("--columns"));
    case FigureData::measurements: {
      const auto variant = read_variant(named, given.all("--set"), known);
      return data_of_measurements(
          variant, read_data(given.text("--data"), make_scene(variant), TrajectorySource::measured));
    }
    case FigureData::regions:
      return data_of_regions(read_variant(named, given.all("--set"), known));
  }
  return {};
}

// Throws std::invalid_argument if a requested scheme is not among the schemes with data.
void require_schemes(const std::vector<std::string>& requested, const std::set<std::string>& there) {
  for (const auto& name : requested) {
    if (!there.contains(name)) reject_text("--scheme", name, fmt::format("of {}", fmt::join(there, ", ")));
  }
}

std::vector<std::string> columns_in(const Given& given, const FigureKind& kind) {
  if (!given.has("--columns")) return {};
  auto names = split_names(given.text("--columns"));
  if (kind.name == "phase" && names.size() != 2) given.refuse("--columns", "two");
  return names;
}

// The page's data of one scene, with what is wanted of it. Throws std::invalid_argument if it lacks some.
nlohmann::json panel_of(const std::string& named, const Given& given, const FigureKind& kind,
                        const std::vector<std::string>& columns, const Streams& streams,
                        const SceneRegistry& known) {
  auto data = data_of(named, given, kind, streams, known);
  require_schemes(given.all("--scheme"), schemes_in(data));
  const auto& section = data["sections"].front();
  const auto known_of = known_columns(section);
  for (const auto& name : columns) {
    if (std::ranges::find(known_of, name) == known_of.end())
      reject_text("--columns", name, fmt::format("of {}", fmt::join(known_of, ", ")));
  }
  if (section.contains("family") && kind.family.empty())
    throw std::invalid_argument(fmt::format("--kind = {}: one value of each parameter", kind.name));
  data["scene"] = named;
  return data;
}

// Writes the figure and returns its absolute path.
std::filesystem::path figure(const Given& given, const FigureKind& kind, nlohmann::json style,
                             const std::vector<std::string>& columns, const Streams& streams,
                             const SceneRegistry& known) {
  nlohmann::json panels = nlohmann::json::array();
  for (const auto& named : given.all("scene"))
    panels.push_back(panel_of(named, given, kind, columns, streams, known));
  style["names"] = own_names(given, panels);
  const bool is_family = panels.front()["sections"].front().contains("family");
  const auto name = given.text("--out");
  auto out = std::filesystem::absolute(name);
  const bool on_paper = name.ends_with(".pdf");
  const TemporaryFile script(".cjs"), request(".json"), drawn(".svg");
  script.write(assets::plot());
  request.write(nlohmann::json{{"panels", panels},
                               {"style", style},
                               {"charts", assets::charts()},
                               {"chart", is_family ? kind.family : kind.chart},
                               {"kind", error_measure(error_kind(given))},
                               {"columns", columns},
                               {"schemes", given.all("--scheme")},
                               {"vega", assets::vega()},
                               {"out", on_paper ? drawn.path().string() : out.string()}}
                    .dump());
  warn(streams, draw_by_node(script.path(), request.path(), name));
  if (on_paper) print_on_paper(drawn.path(), name);
  return out;
}

void write_orders(const Given& given, const Streams& streams, const SceneRegistry& known) {
  const auto results = given.text("--results"), out = given.text("--out");
  const ReadRuns read = read_runs(results);
  warn(streams, read.warning);
  const auto scene = recorded_scene(read.runs, results, given.text("scene"), given.all("--set"), known, "");
  warn(streams, not_compared_text(read.runs, scene));
  std::set<std::string> measured;
  for (const Record& run : of_scene(read.runs.finished, scene)) measured.insert(run.key.scheme);
  require_schemes(given.all("--scheme"), measured);
  const ErrorKind kind = error_kind(given);
  const auto orders = observed_orders(read.runs, scene, error_measure(kind),
                                      kind.norm == Norm::end ? "expected_rate_end" : "expected_rate_maximum",
                                      given.all("--scheme"));
  if (orders.lines.empty()) {
    throw std::invalid_argument(
        fmt::format("--results: has no run of {} over a grid with an error", label_of(scene)));
  }
  AtomicFile file(out);
  file.write(out.ends_with(".csv") ? csv_of(orders) : latex_of(orders));
  file.commit();
  streams.out << std::filesystem::absolute(out).string() << '\n';
}

void plot(const Given& given, const Streams& streams, const SceneRegistry& known) {
  const FigureKind& kind = kind_named(given.word("--kind"));
  const auto style = style_in(given);
  check(given, kind);
  refuse_overwriting(given, "--out", {"--results", "--data", "scene"});
  if (kind.of == FigureData::orders) return write_orders(given, streams, known);
  const auto columns = columns_in(given, kind);
  const auto path = [&] {
    ProgressLine line(streams, fmt::format("draws {}", given.text("--out")));
    return figure(given, kind, style, columns, streams, known);
  }();
  streams.out << path.string() << '\n';
}

}  // namespace

Command plot_command() {
  return {
      {"plot",
       "Measure",
       "Draw a figure of a scene, or of several side by side, for a paper",
       joined(
           {{{"scene:SCENE...", scene_argument().what, Completion::scene},
             set_argument(),
             {"--kind KIND", "what is drawn; all but the last five draw runs of --results", kind_names()},
             {"[--results FILE]", "results file; kinds that draw no runs do not read it",
              Completion::results},
             {"[--data FILE]", "measurements of the kind residuals, as `fit` takes them", Completion::file},
             {"[--scale SCALE]", "what an error is divided by: 1, |y|, 1 + |y| or the largest |y|",
              scale_names(), "mixed"},
             {"[--norm NORM]", "the error that is drawn: the largest over all steps, or that at the end",
              Words{"maximum", "end"}, "maximum"},
             {"[--scheme ID]...", "id of a scheme to draw", Completion::scheme, "all"},
             {"[--columns A,B,...]",
              "of the kinds solution and phase: columns, energy, multipliers and coordinates of the motion"}},
            style_arguments(),
            {{"--out FILE",
              "the figure, whose name ends in .svg, .pdf, or .vl.json for its Vega-Lite specification; a "
              "table of orders ends in .tex or .csv",
              Completion::file}}}),
       {{"fdebench plot pendulum --kind solution --columns phi --set beta=0:1:0.25 --out family.svg",
         "draws one curve for each of five values of a parameter."},
        {"fdebench plot pendulum --results results.jsonl --kind work-precision --scheme l1 --out l1.pdf",
         "draws the error of l1 against its run time."},
        {"fdebench plot pendulum loxodrome --results results.jsonl --kind work-precision --width 7 --out "
         "two.pdf",
         "draws two scenes side by side, over both columns."},
        {"fdebench plot relaxation --results results.jsonl --kind orders --norm end --out orders.tex",
         "writes errors and observed orders as a table for LaTeX."},
        {"fdebench plot relaxation --kind residuals --data data.csv --set gamma=0.7 --out fit.svg",
         "draws measurements over the solution, and below what it leaves of them."}},
       {"run", "report", "output"}},
      plot};
}

}  // namespace fde::bench
