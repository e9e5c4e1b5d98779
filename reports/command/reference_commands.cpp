// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <ostream>

#include "fdebench/benchmarks/references/decimal_bound.hpp"
#include "fdebench/benchmarks/references/reference_of.hpp"
#include "fdebench/benchmarks/scenes/registry.hpp"
#include "fdebench/benchmarks/sweep/measured_run.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/benchmarks/text/printable.hpp"
#include "fdebench/reports/command/command.hpp"
#include "fdebench/reports/command/reference_progress.hpp"

namespace fde::bench {
namespace {

std::string time_text(double t) { return fmt::format("t = {}", t); }

// Throws NumericalFailure unless `finite`. An energy or a bound may overflow where the columns do not.
void require_finite(bool finite, std::string_view what, std::string_view range, double t) {
  if (!finite) throw NumericalFailure(fmt::format("the {} is beyond {} at t = {}", what, range, t));
}

// "t,x,y,bound", with ",bound_x,bound_y" if `bounds`; `bounded` are the columns with a bound.
std::string header(const std::vector<std::string>& names, const std::vector<std::string>& bounded,
                   bool bounds) {
  std::vector<std::string> all = names;
  all.emplace_back("bound");
  if (bounds)
    for (const auto& name : bounded) all.push_back("bound_" + name);
  return fmt::format("t,{}\n", csv_names(all));
}

// The largest bound, followed by all bounds if `each`.
std::string bounds_text(const std::vector<std::string>& all, bool each) {
  std::string largest = "0";
  for (const auto& bound : all) largest = larger_bound(largest, bound);
  return each ? fmt::format("{},{}", largest, fmt::join(all, ",")) : largest;
}

// The bounds of the printed values, including the rounding of their texts; `values` may be longer than
// `bounds`.
std::vector<std::string> bound_texts(In values, In bounds, double t) {
  std::vector<std::string> texts;
  for (Eigen::Index c = 0; c < bounds.size(); ++c) {
    texts.push_back(bound_text(bound_of_decimal(values[c], bounds[c])));
    require_finite(is_finite_bound(texts.back()), "bound of the exact solution", "double", t);
  }
  return texts;
}

std::string rows_in_double(const Scene& scene, const std::vector<double>& times, bool each_bound,
                           ReferenceProgress& work) {
  auto names = printed_names(scene);
  if (scene.reactions.has_exact_multipliers())
    std::ranges::copy(reaction_names(scene), std::back_inserter(names));
  std::string rows = header(names, scene.outputs.names, each_bound);
  work.set_place(time_text(scene.problem.end));
  const reference::Reference exact = reference_of(scene);
  for (const double t : times) {
    work.set_place(time_text(t));
    const auto [value, bounds] = exact.at(t);
    report_progress(1, 1);
    require_finite(value.allFinite(), "exact solution", "double", t);
    const Vec values = printed_values(scene, t, value);
    for (Eigen::Index c = value.size(); c < values.size(); ++c)
      require_finite(std::isfinite(values[c]), "exact " + names[static_cast<std::size_t>(c)], "double", t);
    rows += fmt::format("{:.17g},{:.17g}", t, fmt::join(values, ","));
    if (scene.reactions.has_exact_multipliers())
      rows += fmt::format(",{:.17g}", fmt::join(exact_reactions(scene, t, value), ","));
    rows += fmt::format(",{}\n", bounds_text(bound_texts(value, bounds, t), each_bound));
  }
  return rows;
}

// Energies and constraints are computed in double only, so --digits has no columns for them.
std::string rows_in_digits(const Scene& scene, const std::vector<double>& times, int digits, bool each_bound,
                           ReferenceProgress& work) {
  std::string rows = header(scene.outputs.names, scene.outputs.names, each_bound);
  for (const double t : times) {
    work.set_place(time_text(t));
    const auto decimals = scene.reference.digits(t, digits);
    report_progress(1, 1);
    rows += fmt::format("{}", t);
    std::vector<std::string> written;
    for (std::size_t c = 0; c < scene.outputs.names.size(); ++c) {
      rows += "," + decimals[c].value;
      written.push_back(decimals[c].bound);
      require_finite(is_finite_bound(written.back()), "exact solution", "all exponents of --digits", t);
    }
    rows += fmt::format(",{}\n", bounds_text(written, each_bound));
  }
  return rows;
}

// The number of --digits; nullopt for double.
std::optional<int> parse_digits(const Given& given, const Scene& scene, std::string_view id) {
  const auto digits = given.find_count("--digits");
  if (!digits || scene.reference.digits) return digits;
  throw std::invalid_argument(fmt::format(
      "--digits = {}: scene {} has no exact solution in digits, only what is known in double", *digits, id));
}

void exact(const Given& given, const Streams& streams, const SceneRegistry& known) {
  const auto variant = read_variant(given, known);
  Scene scene = make_scene_unchecked(*variant.maker, variant.values);
  const auto times = increasing(given.numbers("--at"));
  const double last = times.back();
  const auto budget = given.find_number("--budget");
  const bool two_ends = is_two_sided(scene.problem), each_bound = given.has("--bounds");
  if (two_ends && last > scene.problem.end)
    reject("--at", last, fmt::format("in [0, {}], the time of the scene", scene.problem.end));
  const auto digits = parse_digits(given, scene, variant.maker->id);
  if (!digits && !two_ends && last > 0.0) set_end(scene, last);
  ReferenceProgress work(streams, budget, "the reference");
  try {
    if (digits && scene.from_file) require_agreement(scene, scene.reference);
    streams.out << (digits ? rows_in_digits(scene, times, *digits, each_bound, work)
                           : rows_in_double(scene, times, each_bound, work));
  } catch (const Cancelled&) {
    work.fail();
  }
}

}  // namespace

Command exact_command() {
  return {
      {"exact",
       "Look up",
       "Print the reference of a scene: its columns and a bound; CSV",
       {scene_argument(),
        set_argument(),
        {"--at T1,T2,...", "times to print", not_negative},
        digits_argument(),
        {"[--bounds]", "print a bound of each column, after the largest"},
        evaluation_budget_argument()},
       {{"fdebench exact pendulum --at 1,20", "prints the solution at two times and the largest bound."},
        {"fdebench exact relaxation:gamma=0.3 --at 1 --digits 40", "prints forty digits of a linear scene."}},
       {"solve", "mittag-leffler", "accuracy"}},
      exact};
}

}  // namespace fde::bench
