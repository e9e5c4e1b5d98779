// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <ostream>

#include "fdebench/benchmarks/references/decimal_bound.hpp"
#include "fdebench/benchmarks/requests/exact.hpp"
#include "fdebench/benchmarks/sweep/measured_run.hpp"
#include "fdebench/benchmarks/text/number_text.hpp"
#include "fdebench/benchmarks/text/printable.hpp"
#include "fdebench/reports/command/command.hpp"
#include "fdebench/reports/command/reference_progress.hpp"

namespace fde::bench {
namespace {

// What a table of exact values has besides the values at its times.
struct TableForm {
  bool each_bound, plain_names;
};

// "t,x,y,bound", with ",bound_x,bound_y" if each bound is printed; `bounded` are the columns with a bound.
std::string header(const std::vector<std::string>& names, const std::vector<std::string>& bounded,
                   const TableForm& form) {
  std::vector<std::string> all = names;
  all.push_back(bound_column());
  if (form.each_bound)
    for (const auto& name : bounded) all.push_back(bound_column(name));
  if (form.plain_names) std::ranges::transform(all, all.begin(), plain_name);
  return fmt::format("t,{}\n", csv_names(all));
}

// The largest bound, followed by all bounds if `each`.
std::string bounds_text(const std::vector<std::string>& all, bool each) {
  std::string largest = "0";
  for (const auto& bound : all) largest = larger_bound(largest, bound);
  return each ? fmt::format("{},{}", largest, fmt::join(all, ",")) : largest;
}

std::string rows_in_double(const ExactTable& table, const std::vector<double>& times, const TableForm& form) {
  const auto bounded = table.bounds.rows();
  std::string rows = header(table.names, {table.names.begin(), table.names.begin() + bounded}, form);
  for (Eigen::Index i = 0; const double t : times) {
    std::vector<std::string> bounds;
    for (Eigen::Index c = 0; c < bounded; ++c)
      bounds.push_back(bound_text(bound_of_decimal(table.values(c, i), table.bounds(c, i))));
    rows += fmt::format("{:.17g},{:.17g},{}\n", t, fmt::join(Vec(table.values.col(i++)), ","),
                        bounds_text(bounds, form.each_bound));
  }
  return rows;
}

std::string rows_in_digits(const std::vector<std::vector<reference::Decimal>>& table,
                           const std::vector<std::string>& names, const std::vector<double>& times,
                           const TableForm& form) {
  std::string rows = header(names, names, form);
  for (std::size_t i = 0; i < times.size(); ++i) {
    rows += fmt::format("{}", times[i]);
    std::vector<std::string> bounds;
    for (const auto& [value, bound] : table[i]) {
      rows += "," + value;
      bounds.push_back(bound);
    }
    rows += fmt::format(",{}\n", bounds_text(bounds, form.each_bound));
  }
  return rows;
}

// The table of the scene as CSV.
std::string exact_rows(const SceneVariant& variant, const Given& given, ReferenceProgress& work) {
  const Scene scene = make_scene_unchecked(variant);
  const auto times = increasing(given.numbers("--at"));
  const auto before = [&](double t) { work.set_place(fmt::format("t = {}", t)); };
  const TableForm form{given.has("--bounds"), given.has("--plain-names")};
  try {
    const auto digits = given.find_count("--digits");
    if (!digits) return rows_in_double(exact(scene, times, before), times, form);
    return rows_in_digits(exact_in_digits(scene, variant.factory->id, times, *digits, before),
                          scene.outputs.names, times, form);
  } catch (const Refusal& refusal) {
    given.refuse(refusal, {{"times", "--at"}});
  }
}

void print_exact(const Given& given, const Streams& streams, const SceneRegistry& known) {
  const auto variant = read_variant(given, known);
  ReferenceProgress work(streams, given.find_number("--budget"), "the reference");
  try {
    streams.out << exact_rows(variant, given, work);
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
        plain_names_argument(),
        evaluation_budget_argument()},
       {{"fdebench exact pendulum --at 1,20", "prints the solution at two times and the largest bound."},
        {"fdebench exact relaxation:gamma=0.3 --at 1 --digits 40", "prints forty digits of a linear scene."}},
       {"solve", "mittag-leffler", "accuracy"}},
      print_exact};
}

}  // namespace fde::bench
