#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <variant>

#include "analysis/text.hpp"
#include "page/page_data.hpp"

namespace fde {
namespace {

using nlohmann::json;

// A logarithmic axis shows positive values only.
std::optional<double> above_zero(const MeasuredRun& run, std::string_view quantity) {
  const auto value = run[quantity];
  return value && *value > 0.0 ? value : std::nullopt;
}

// The slope between a run and the next coarser one of its line.
std::optional<double> rate_between(const MeasuredRun& coarse, const MeasuredRun& fine,
                                   std::string_view quantity) {
  const auto before = above_zero(coarse, quantity), now = above_zero(fine, quantity);
  if (!before || !now || coarse.h == fine.h) return std::nullopt;
  return std::log(*before / *now) / std::log(coarse.h / fine.h);
}

// As many digits as a chart can show: a page has thousands of these numbers.
double in_chart(double value) { return std::strtod(fmt::format("{:.5g}", value).c_str(), nullptr); }

// The words of a tooltip but for the errors, a name and a text each.
json tooltip(const PageInput& page, const MeasuredRun& run, const MeasuredRun* coarser) {
  json words = json::array();
  const auto add = [&](std::string name, std::string text) {
    words.push_back({std::move(name), std::move(text)});
  };
  const auto time = [&](double seconds) {
    return fmt::format("{}{}", time_text(seconds), clock_note(run.wall_clock));
  };
  add("title", page.label(run.key));  // shown as the heading
  const auto* accuracy = std::get_if<Accuracy>(&run.key.setup.resolution);
  if (accuracy != nullptr) add("asked", error_text(accuracy->relative));
  add("N", count_text(run.steps));
  add("h", fmt::format("{:.3g}", run.h));
  if (const auto residual = run["energy_residual"]) add("energy residual", error_text(*residual));
  if (const auto drift = run["drift_internal"]) add("internal drift", error_text(*drift));
  if (const auto drift = run["drift_independent"]) add("independent drift", error_text(*drift));
  if (const auto seconds = run["time_minimum"]) add("time", time(*seconds));
  if (const auto seconds = run["time_median"]) add("median time", time(*seconds));
  if (coarser != nullptr && accuracy == nullptr) {
    const std::string since = fmt::format("from N = {}", count_text(coarser->steps));
    if (const auto rate = rate_between(*coarser, run, "error_end"))
      add("rate at the end " + since, fmt::format("{:.2f}", *rate));
    if (const auto rate = rate_between(*coarser, run, "error_maximum"))
      add("maximum rate " + since, fmt::format("{:.2f}", *rate));
  }
  if (page.sessions.size() > 1) add("session", std::to_string(run.session + 1));
  return words;
}

json point(const PageInput& page, const MeasuredRun& run, const MeasuredRun* coarser) {
  json shown{{"line", page.label(run.key)}, {"steps", run.steps}, {"h", in_chart(run.h)}};
  shown["errors"] = errors_of(run);
  if (const auto* accuracy = std::get_if<Accuracy>(&run.key.setup.resolution))
    shown["asked"] = accuracy->relative;
  if (const auto value = above_zero(run, "time_minimum")) shown["seconds"] = in_chart(*value);
  if (const auto value = above_zero(run, "energy_residual")) shown["energy"] = in_chart(*value);
  shown["words"] = tooltip(page, run, coarser);
  return shown;
}

json points(const PageInput& page, RunSpan scene) {
  json shown = json::array();
  for (const RunSpan line : by_line(scene)) {
    for (auto run = line.begin(); run != line.end(); ++run) {
      shown.push_back(point(page, *run, run == line.begin() ? nullptr : &*std::prev(run)));
    }
  }
  return shown;
}

// The theoretical slope of each line and kind of error, from its finest point to its coarsest step.
json guides(const PageInput& page, RunSpan scene) {
  json shown = json::array();
  for (const RunSpan line : by_line(scene)) {
    const RateRow rate = rate_of(line);
    const MeasuredRun& finest = line.back();
    for (const ErrorKind& kind : error_kinds()) {
      const auto& expected = (kind.norm == Norm::end ? rate.end : rate.maximum).expected;
      const auto anchor = above_zero(finest, error_measure(kind));
      if (!expected || !anchor || line.size() < 2 || !(finest.h > 0.0)) continue;
      for (const double h : {finest.h, line.front().h}) {
        shown.push_back({{"line", page.label(finest.key)},
                         {"kind", error_measure(kind)},
                         {"h", in_chart(h)},
                         {"error", in_chart(*anchor * std::pow(h / finest.h, *expected))}});
      }
    }
  }
  return shown;
}

// Runs that a logarithmic chart cannot show are named, not dropped in silence.
std::string not_drawn(const PageInput& page, RunSpan scene) {
  std::vector<std::string> names;
  for (const MeasuredRun& run : scene) {
    if (run["error_end"] && !above_zero(run, "error_end")) {
      names.push_back(fmt::format("{} at N = {}", page.label(run.key), count_text(run.steps)));
    }
  }
  if (names.empty()) return {};
  return fmt::format("Not in the charts, because the error at the end is exactly 0: {}.",
                     fmt::join(names, ", "));
}

// Times that are not of solves alone.
std::string on_wall_clock(const PageInput& page, RunSpan scene) {
  std::set<std::string> names;
  for (const MeasuredRun& run : scene) {
    if (run.wall_clock) names.insert(page.label(run.key));
  }
  if (names.empty()) return {};
  return fmt::format("Times of whole processes, by the wall clock and with their start: {}.",
                     fmt::join(names, ", "));
}

}  // namespace

json errors_of(const MeasuredRun& run) {
  json errors = json::object();
  for (const ErrorKind& kind : error_kinds()) {
    if (const auto value = above_zero(run, error_measure(kind)))
      errors[error_measure(kind)] = in_chart(*value);
  }
  return errors;
}

json scene_sections(const PageInput& page) {
  json sections = json::array();
  for (const RunSpan scene : by_scene(page.runs.finished)) {
    const SceneSettings& solved = scene.front().key.scene;
    const auto label = label_of(solved);
    const auto [title, source] = name_of_scene(solved);
    std::vector<std::string> paragraphs;
    for (const auto& text : {source, not_drawn(page, scene), on_wall_clock(page, scene)}) {
      if (!text.empty()) paragraphs.push_back(text);
    }
    const SceneLines lines(page.runs, solved);
    json answers = json::object();
    for (const ErrorKind& kind : error_kinds())
      answers[error_measure(kind)] = to_json(scene_answers(page, lines, kind));
    sections.push_back({{"id", section_of(solved)},
                        {"title", title},
                        {"tables", answers},
                        {"name", label},
                        {"paragraphs", paragraphs},
                        {"points", points(page, scene)},
                        {"guides", guides(page, scene)}});
  }
  return sections;
}

}  // namespace fde
