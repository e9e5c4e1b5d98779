#include <fmt/ostream.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <ostream>

#include "command/arguments.hpp"
#include "command/command.hpp"
#include "references/reference_of.hpp"
#include "references/written_bound.hpp"
#include "scenes/number_text.hpp"
#include "scenes/registry.hpp"
#include "sweep/experiment.hpp"

namespace fde {
namespace {

struct ExactArguments {
  std::string scene, at;
  std::optional<std::string> digits;
  std::vector<std::string> settings;
};

// The columns may be finite, and what is said of them not.
void require_finite(bool finite, std::string_view what, std::string_view range, double t) {
  if (!finite) throw NumericalFailure(fmt::format("the {} is beyond {} at t = {}", what, range, t));
}

// The multipliers and their power where they are known as exactly as the columns.
bool knows_reactions(const Scene& scene) {
  return scene.reactions && (scene.reactions.of_columns() || scene.reactions.exact.at);
}

// Their bound is that of the multipliers, 0 where these are functions of the columns.
ReferenceValue exact_reactions(const Scene& scene, double t, In columns) {
  const auto size = std::ssize(scene.reactions.names);
  if (scene.reactions.of_columns() || t == 0.0)
    return {reaction_values(scene, t, columns, std::nullopt), Vec::Zero(size)};
  const auto [lambda, bound] = scene.reactions.exact.at(t);
  return {with_power(scene, t, columns, lambda), bound};
}

void print_doubles(const Scene& scene, const Reference& exact, const std::vector<double>& times,
                   std::ostream& out) {
  constexpr std::string_view range = "double";
  auto names = printed_names(scene);
  const bool reactions = knows_reactions(scene);
  if (reactions) std::ranges::copy(reaction_names(scene), std::back_inserter(names));
  std::string rows = fmt::format("t,{},bound\n", fmt::join(names, ","));
  for (const double t : times) {
    const auto [value, bounds] = exact.at(t);
    require_finite(value.allFinite(), "exact solution", range, t);
    const Vec values = printed_values(scene, t, value);
    for (Eigen::Index c = value.size(); c < values.size(); ++c)
      require_finite(std::isfinite(values[c]), "exact " + names[static_cast<std::size_t>(c)], range, t);
    double largest = bounds.maxCoeff<Eigen::PropagateNaN>();
    rows += fmt::format("{:.17g},{:.17g}", t, fmt::join(values, ","));
    if (reactions) {
      const auto [reaction, reaction_bound] = exact_reactions(scene, t, value);
      rows += fmt::format(",{:.17g}", fmt::join(reaction, ","));
      largest = std::max(largest, reaction_bound.maxCoeff());
    }
    const std::string bound = bound_text(largest);
    require_finite(is_finite_bound(bound), "bound of the exact solution", range, t);
    rows += "," + bound + "\n";
  }
  out << rows;
}

// Energies and constraints are doubles, so with digits they have no columns.
void print_digits(const Scene& scene, const std::vector<double>& times, int digits, std::ostream& out) {
  std::string rows = fmt::format("t,{},bound\n", fmt::join(scene.outputs.names, ","));
  for (const double t : times) {
    const auto decimals = scene.reference.digits(t, digits);
    rows += fmt::format("{}", t);
    std::string bound = "0";
    for (std::size_t c = 0; c < scene.outputs.names.size(); ++c) {
      rows += "," + decimals[c].value;
      bound = larger_bound(bound, decimals[c].bound);
    }
    require_finite(is_finite_bound(bound), "exact solution", "all exponents of --digits", t);
    rows += "," + bound + "\n";
  }
  out << rows;
}

void exact(const ExactArguments& arguments, const Streams& streams, const Scenes& known) {
  const auto& maker = scene_named(arguments.scene, known);
  Scene scene = make_known_scene(maker, parse_settings(maker, arguments.settings));
  const auto times = parse_numbers("--at", arguments.at, not_negative);
  const double last = std::ranges::max(times);
  const bool two_ends = two_sided(scene.problem);
  if (two_ends && last > scene.problem.end)
    reject("--at", last, fmt::format("in [0, {}], the time of the scene", scene.problem.end));
  if (!arguments.digits) {
    if (!two_ends && last > 0.0) scene.problem.end = last;
    print_doubles(scene, reference_of(scene), times, streams.out);
    return;
  }
  const int digits = parse_count("--digits", *arguments.digits, 1, most_digits);
  if (!scene.no_reference.empty()) throw std::runtime_error(scene.no_reference);
  if (!scene.reference.digits) {
    throw std::invalid_argument(
        fmt::format("--digits = {}: scene {} has no exact solution in digits, only what is known in double",
                    digits, maker.id));
  }
  print_digits(scene, times, digits, streams.out);
}

}  // namespace

void add_reference_commands(CLI::App& app, const Streams& streams, const Scenes& known) {
  auto of_exact = std::make_shared<ExactArguments>();
  Subcommand command(app, "exact", "What is known about a scene: its columns and a bound; CSV");
  command.required("scene", of_exact->scene, "id of the scene");
  command.required("--at", of_exact->at, "times T1,T2,...");
  command.list("--set", of_exact->settings, "a parameter of the scene, NAME=VALUE");
  command.option("--digits", of_exact->digits, "number of decimal digits; default double");
  command.callback([=, &known] { exact(*of_exact, streams, known); });
}

}  // namespace fde
