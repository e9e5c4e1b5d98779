// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <string>
#include <utility>

#include "fdebench/benchmarks/files/atomic_file.hpp"
#include "fdebench/benchmarks/requests/answers_json.hpp"
#include "fdebench/benchmarks/requests/fit.hpp"
#include "fdebench/benchmarks/text/printable.hpp"
#include "fdebench/reports/command/command.hpp"
#include "fdebench/reports/command/data_file.hpp"
#include "fdebench/reports/command/progress_display.hpp"

namespace fde::bench {
namespace {

// NAME, or NAME=LOW:HIGH, where one of the limits may be left out.
VariedParameter varied(const std::string& text) {
  const auto reject = [&] { reject_text("--vary", text, "NAME or NAME=LOW:HIGH, with commas between them"); };
  const auto equals = text.find('='), colon = text.find(':');
  VariedParameter made{.name = text.substr(0, equals)};
  if (made.name.empty()) reject();
  if (equals == std::string::npos) return made;
  if (colon == std::string::npos || colon < equals) reject();
  const auto limit = [&](const std::string& number) -> std::optional<double> {
    if (number.empty()) return std::nullopt;
    const auto value = try_parse_number(number);
    if (!value || !std::isfinite(*value)) reject();
    return value;
  };
  made.low = limit(text.substr(equals + 1, colon - equals - 1));
  made.high = limit(text.substr(colon + 1));
  return made;
}

void print(const FittedScene& fitted, std::ostream& out) {
  const bool estimated = fitted.measured.deviations.size() == 0;
  out << fmt::format("scene {}\nrows {}\n", fitted.variant.label(), fitted.measured.times.size());
  for (std::size_t c = 0; c < fitted.names.size(); ++c) {
    const ColumnMisfit& of = fitted.misfits[c];
    out << fmt::format("column {} measurements {} rms {:.6g}", fitted.names[c], of.count, of.rms());
    if (estimated)
      out << fmt::format(" deviation {:.6g}", fitted.deviations(static_cast<Eigen::Index>(c), 0));
    out << '\n';
  }
  if (!estimated) out << text_of(fitted.chi_squared);
  for (const FittedParameter& one : fitted.parameters) {
    out << fmt::format("parameter {} {:.10g}", one.name, one.value);
    out << (one.is_at_limit ? " at_limit\n"
                            : fmt::format(" standard_error {:.4g} low {:.10g} high {:.10g}\n",
                                          one.standard_error, one.low, one.high));
  }
  for (Eigen::Index j = 0; j < fitted.correlation.rows(); ++j) {
    for (Eigen::Index i = 0; i < j; ++i) {
      out << fmt::format("correlation {} {} {:.3f}\n", fitted.parameters[static_cast<std::size_t>(i)].name,
                         fitted.parameters[static_cast<std::size_t>(j)].name, fitted.correlation(j, i));
    }
  }
  for (const FittedParameter& one : fitted.parameters)
    if (!one.is_at_limit) out << fmt::format("solver_error {} {:.1e}\n", one.name, one.solver_error);
  out << fmt::format("solver {} --accuracy {}, {} solves, {} iterations; its error by {}\n", fitted.scheme,
                     fitted.accuracy, fitted.solves, fitted.iterations,
                     fitted.by_reference ? "the reference" : "a smaller accuracy");
}

// One line a measurement, which plotting programs read without joins.
void write_residuals(const FittedScene& fitted, const std::string& path) {
  AtomicFile file(path);
  file.write("t,column,measured,sd,model,residual\n");
  for (Eigen::Index c = 0; c < fitted.measured.values.rows(); ++c) {
    for (Eigen::Index i = 0; i < fitted.measured.values.cols(); ++i) {
      const double value = fitted.measured.values(c, i), model = fitted.model(c, i);
      if (std::isnan(value)) continue;
      file.write(fmt::format("{},{},{},{:.6g},{},{:.6g}\n",
                             fitted.measured.times[static_cast<std::size_t>(i)],
                             csv_names({fitted.names[static_cast<std::size_t>(c)]}), value,
                             fitted.deviations(c, i), model, value - model));
    }
  }
  file.commit();
}

void warn_of(const FittedScene& fitted, const Streams& streams) {
  constexpr double rounding = 1e-13;
  for (const FittedParameter& one : fitted.parameters) {
    if (one.is_at_limit) {
      warn(streams,
           fmt::format(
               "{} is at an end of its range, {:.6g}, where the sum of squares is least: it counts as known",
               one.name, one.value));
    }
    if (one.solver_error > std::max(0.1 * one.standard_error, rounding * std::abs(one.value))) {
      warn(streams, fmt::format("the error of the solver moves {} by {:.1e}, of a standard error of {:.1e}",
                                one.name, one.solver_error, one.standard_error));
    }
  }
}

FittedScene fitted(const Given& given, const Streams& streams, const SceneRegistry& known) {
  const auto file = given.text("file");
  refuse_overwriting(given, "--residuals", {"file", "scene"});
  FitRequest request{
      .variant = read_variant(given, known),
      .vary = {},
      .data = [&](const Scene& scene) { return read_data(file, scene, TrajectorySource::measured); },
      .scheme = given.find("--scheme"),
      .confidence = given.number("--confidence"),
      .budget = given.number("--budget")};
  for (const auto& one : split_names(given.text("--vary"))) request.vary.push_back(varied(one));
  ProgressLine line(streams, "fits");
  try {
    return fit(request,
               [&](int solves) { line.set({.current_run = fmt::format("fits: {} solves", solves)}); });
  } catch (const Refusal& refusal) {
    given.refuse(refusal, {{"data", file}});
  }
}

void print_fitted(const Given& given, const Streams& streams, const SceneRegistry& known) {
  const FittedScene made = fitted(given, streams, known);
  if (const auto path = given.find("--residuals")) write_residuals(made, *path);
  if (given.has("--json")) {
    streams.out << json_of(made).dump() << '\n';
  } else {
    print(made, streams.out);
  }
  warn_of(made, streams);
}

}  // namespace

Command fit_command() {
  return {
      {"fit",
       "Measure",
       "Estimate parameters and orders of a scene from measurements",
       {scene_argument(),
        set_argument(),
        {"FILE",
         "CSV with the header t,COLUMN,... of the scene, and sd_COLUMN where known; - is standard input",
         Completion::file},
        {"--vary NAME,...", "parameters to estimate, each with limits where it is written NAME=LOW:HIGH"},
        {"[--scheme ID]", "scheme with adaptive step size", Completion::scheme,
         "the first that takes the scene"},
        {"[--confidence P]", "probability of the intervals", order_below_one, "0.95"},
        {"[--budget SECONDS]", "largest time of the fit, after which no further run is made", positive,
         "600"},
        {"[--residuals OUT]", "CSV of all measurements with the model and what it leaves", Completion::file},
        {"[--json]", "print one JSON object"}},
       {{"fdebench fit zener.toml creep.csv --vary alpha=0:1,E0,E1,tau",
         "estimates four parameters, an order among them, with intervals."},
        {"fdebench fit relaxation data.csv --vary gamma,lambda --set gamma=0.8 --residuals left.csv",
         "starts from another order and writes the residuals."}},
       {"judge", "plot", "equation-files"}},
      print_fitted};
}

}  // namespace fde::bench
