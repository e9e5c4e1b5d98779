// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/table_times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "fdebench/benchmarks/expressions/formula_text.hpp"
#include "fdebench/benchmarks/expressions/sampled_function.hpp"

namespace fde::bench {
namespace {

// a and b of an expression a + b t; nullopt for another one.
std::optional<std::pair<double, double>> affine(Expression of, ExpressionPool& pool) {
  if (!pool.arguments({of}, jumps).empty()) return std::nullopt;
  try {
    const auto rate = pool.value(pool.derivative(of, 0)), start = pool.value(pool.without_variables(of, 0));
    if (!rate || !start || !std::isfinite(*start)) return std::nullopt;
    return std::pair(static_cast<double>(*start), static_cast<double>(*rate));
  } catch (const std::invalid_argument&) {  // it has no derivative
    return std::nullopt;
  }
}

// The argument of a table and how far it is beyond the last sample, or before the first one.
struct Excess {
  TimeFunction argument, beyond;
  std::string table, text, allowed;
  FormulaText formula;
  std::size_t byte;
  bool is_constant, is_time;
  double start;
};

void require_none(const std::string& file, const Excess& excess, double margin, double end) {
  for (const auto& piece : excess.beyond.signs(0.0, end, margin)) {
    if (piece.sign <= 0.0) continue;
    const double t = excess.beyond(piece.to) >= excess.beyond(piece.from) ? piece.to : piece.from;
    const double value = excess.argument(t);
    const auto place = excess.is_constant ? fmt::format("{}", value)
                       : excess.is_time
                           ? fmt::format("t = {}", value)
                           : fmt::format("{} = {} at t = {}", excess.text, value, excess.start + t);
    reject_in(file, excess.formula, excess.byte,
              fmt::format("{}({}): {}: must be {}", excess.table, excess.text, place, excess.allowed));
  }
}

}  // namespace

TableTimes::TableTimes(Expression value, ExpressionPool& pool)
    : table_(pool[value].function), argument_(pool[value].arguments[0], pool) {
  const auto argument = pool[value].arguments[0];
  if (const auto line = affine(argument, pool)) {
    std::tie(start_, rate_) = *line;
  } else {
    alternation_ = TimeFunction(pool.sampled(table_->alternation(), argument), pool);
  }
}

// The first number, near this time, at which the argument has passed a sample; what is before the sample
// belongs to it where the argument decreases.
double TableTimes::first_behind(double sample, double time) const {
  const double never = std::numeric_limits<double>::infinity();
  const auto is_behind = [&](double t) {
    return rate_ > 0.0 ? argument_(t) >= sample : argument_(t) < sample;
  };
  constexpr int most = 64;
  for (int i = 0; i < most && !is_behind(time); ++i) time = std::nextafter(time, never);
  for (int i = 0; i < most && is_behind(std::nextafter(time, 0.0)); ++i) time = std::nextafter(time, 0.0);
  return time;
}

std::vector<double> TableTimes::until(double end) const {
  std::vector<double> times;
  if (alternation_) {
    const auto pieces = alternation_->signs(0.0, end);
    for (std::size_t k = 1; k < pieces.size(); ++k)
      if (pieces[k - 1].to == pieces[k].from) times.push_back(pieces[k].from);
    return times;
  }
  if (rate_ == 0.0) return times;
  for (const double sample : table_->breaks()) {
    const double time = (sample - start_) / rate_;
    if (time > 0.0 && time <= end) times.push_back(first_behind(sample, time));
  }
  if (rate_ < 0.0) std::ranges::reverse(times);
  return times;
}

std::function<void(double end)> samples_check(FileFormulas& formulas) {
  auto& pool = formulas.pool();
  std::vector<std::pair<Excess, double>> all;
  for (const auto& [value, formula, byte] : formulas.sampled_values()) {
    if (!pool[value].function || pool.depends_on_unknowns(value)) continue;
    const auto table = pool[value].function;
    const auto argument = pool[value].arguments[0];
    const double start = formulas.start();
    std::string now = start == 0.0 ? "t" : fmt::format("(t - {})", start);
    const bool is_time = argument == formulas.time();
    const auto text = is_time ? "t" : formula_text(pool, argument, [&](int /*t*/) { return now; });
    const auto add = [&, &place = formula, at = byte](double sample, bool is_last) {
      const auto bound = pool.number(fmt::format("{}", sample));
      const auto beyond = is_last ? pool.make_expression(Operation::subtract, argument, bound)
                                  : pool.make_expression(Operation::subtract, bound, argument);
      const auto allowed = fmt::format("at {} {}, the {} sample of {}", is_last ? "most" : "least", sample,
                                       is_last ? "last" : "first", table->source());
      all.push_back({{TimeFunction(argument, pool), TimeFunction(beyond, pool), table->name(), text, allowed,
                      place, at, !pool.depends_on(argument, 0), is_time, start},
                     table->margin()});
    };
    add(table->last(), true);
    add(table->first(), false);
  }
  if (all.empty()) return {};
  return [all = std::move(all), file = formulas.text().file](double end) {
    for (const auto& [excess, margin] : all) require_none(file, excess, margin, end);
  };
}

}  // namespace fde::bench
