// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/load_times.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <utility>

#include "fdebench/benchmarks/equation_files/table_times.hpp"
#include "fdebench/benchmarks/expressions/sampled_function.hpp"
#include "fdebench/benchmarks/expressions/time_function.hpp"

namespace fde::bench {
namespace {

constexpr double first_part = 0x1p-64;  // of [0, end], left out: sin(t) is 0 at 0

// Two times of the same change that rounding separates.
bool same_time(double a, double b) {
  constexpr double few = 4.0 * std::numeric_limits<double>::epsilon();
  return b - a <= few * b;
}

// The largest subexpressions that depend on t and on no unknown, each once; t itself and constants are none.
std::vector<Expression> time_parts(const std::vector<Expression>& rows, const ExpressionPool& pool) {
  const auto used = pool.subexpressions(rows);
  std::vector<bool> of_time(used.size()), of_unknowns(used.size()), is_part(used.size());
  for (std::size_t e = 0; e < used.size(); ++e) {
    if (!used[e]) continue;
    const auto& node = pool[static_cast<Expression>(e)];
    if (node.operation == Operation::variable) (node.variable == 0 ? of_time : of_unknowns)[e] = true;
    for (const Expression a : node.arguments) {
      if (a == ExpressionPool::none) continue;
      of_time[e] = of_time[e] || of_time[static_cast<std::size_t>(a)];
      of_unknowns[e] = of_unknowns[e] || of_unknowns[static_cast<std::size_t>(a)];
    }
  }
  const auto add = [&](Expression e) {
    const auto i = static_cast<std::size_t>(e);
    is_part[i] = of_time[i] && !of_unknowns[i] && pool[e].operation != Operation::variable;
  };
  std::ranges::for_each(rows, add);
  for (std::size_t e = 0; e < used.size(); ++e) {
    if (!used[e] || !of_unknowns[e]) continue;
    for (const Expression a : pool[static_cast<Expression>(e)].arguments)
      if (a != ExpressionPool::none) add(a);
  }
  std::vector<Expression> parts;
  for (std::size_t e = 0; e < used.size(); ++e)
    if (is_part[e]) parts.push_back(static_cast<Expression>(e));
  return parts;
}

// Those of tables are known without a search.
bool jumps_without_table(const ExpressionPool::Node& node) { return jumps(node) && !node.function; }

// The values of tables in the rows whose arguments depend on t alone.
std::vector<Expression> table_values(const std::vector<Expression>& rows, const ExpressionPool& pool) {
  std::vector<Expression> found;
  const auto used = pool.subexpressions(rows);
  for (std::size_t e = 0; e < used.size(); ++e) {
    const auto value = static_cast<Expression>(e);
    if (used[e] && pool[value].function && !pool.depends_on_unknowns(value)) found.push_back(value);
  }
  return found;
}

// Whether it is a polynomial of t of low degree between the samples of tables, where it then hides nothing.
bool is_polynomial(Expression of_time, ExpressionPool& pool) {
  constexpr int most = 5;
  for (int degree = 0; degree <= most; ++degree) {
    of_time = pool.derivative(of_time, 0);
    if (of_time == pool.number(0)) return true;
  }
  return false;
}

// Functions of t whose sign changes are kinks of the rows.
std::vector<Expression> kinks_in(const std::vector<Expression>& rows, ExpressionPool& pool) {
  std::vector<Expression> found;
  const auto used = pool.subexpressions(rows);
  for (std::size_t e = 0; e < used.size(); ++e) {
    const auto [operation, arguments] =
        std::pair(pool[static_cast<Expression>(e)].operation, pool[static_cast<Expression>(e)].arguments);
    const bool is_abs = operation == Operation::abs;
    if (!used[e] || !(is_abs || operation == Operation::min || operation == Operation::max) ||
        pool.depends_on_unknowns(static_cast<Expression>(e)))
      continue;
    found.push_back(is_abs ? arguments[0]
                           : pool.make_expression(Operation::subtract, arguments[0], arguments[1]));
  }
  return found;
}

// A function of t, and its derivative, whose sign changes are its turning points.
struct Curve {
  TimeFunction value, slope;
};

// An interval in which a curve only rises or only falls, or is flat: as good as constant.
struct Run {
  double from, to;
  bool flat;
  [[nodiscard]] double length() const { return to - from; }
};

// The parts of a run that are flat, at its start and at its end, and the part between. Flat parts that are
// short beside the other belong to it.
std::vector<Run> parts_of(const TimeFunction& curve, double from, double to, double negligible) {
  constexpr double most = 0.8;
  // The last time, from one end of the run, until which the curve is flat.
  const auto flat_until = [&](double near, double far) {
    const double value = curve(near);
    if (!(std::abs(curve(far) - value) > negligible)) return far;
    double within = near, beyond = far;
    for (int halving = 0; halving < 60; ++halving) {
      const double middle = within + (beyond - within) / 2.0;
      (std::abs(curve(middle) - value) <= negligible ? within : beyond) = middle;
    }
    return within;
  };
  const double rise = flat_until(from, to), end_of_rise = flat_until(to, from);
  if (rise == to) return {{from, to, true}};
  if ((rise - from) + (to - end_of_rise) < most * (to - from)) return {{from, to, false}};
  std::vector<Run> parts{{from, rise, true}, {rise, end_of_rise, false}, {end_of_rise, to, true}};
  const double shortest = end_of_rise - rise;
  if (parts.back().length() < shortest) parts = {parts[0], {rise, to, false}};
  if (parts.front().length() < shortest) parts.erase(parts.begin()), parts.front().from = from;
  return parts;
}

// The curve between its turning points `ends`.
std::vector<Run> runs_of(const TimeFunction& curve, const std::vector<double>& ends, double negligible) {
  std::vector<Run> runs;
  for (std::size_t k = 1; k < ends.size(); ++k) {
    for (const Run& part : parts_of(curve, ends[k - 1], ends[k], negligible)) {
      if (part.flat && !runs.empty() && runs.back().flat) {
        runs.back().to = part.to;
      } else {
        runs.push_back(part);
      }
    }
  }
  return runs;
}

// Limits of the runs that are short beside a neighbour, or beside the next one, and of the first, before
// which the load is unknown.
void add_limits(const std::vector<Run>& runs, std::vector<StepLimit>& limits) {
  constexpr double much = 4.0, samples = 4.0, rounding = 1e-13;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    double neighbour = 0.0;
    for (std::size_t other = k < 2 ? 0 : k - 2; other < std::min(k + 3, runs.size()); ++other)
      neighbour = std::max(neighbour, runs[other].length());
    const double length = runs[k].length();
    if (runs[k].flat || length <= rounding * runs[k].to) continue;
    if (neighbour >= much * length) {
      limits.push_back({runs[k].from, runs[k].to, length / samples});
    } else if (k == 0 && runs.size() > 1) {
      limits.push_back({runs[k].from, runs[k].to, length});
    }
  }
}

// Near 0 a curve may be infinitely steep, which says nothing about later times: the part of [0, to] from
// which sizes are taken.
constexpr double later = 0x1p-12;

// The ends of the interval, and the times between them at which the curve turns.
std::vector<double> turning_points(const Curve& curve, double from, double to) {
  constexpr double rounding = 1e-14;
  const double negligible = rounding * curve.slope.largest(std::max(from, later * to), to);
  std::vector<double> ends{from};
  double before = 0.0;
  for (const auto& piece : curve.slope.signs(from, to, negligible)) {
    if (piece.sign == 0.0) continue;
    if (piece.sign * before < 0.0) ends.push_back(piece.from);
    before = piece.sign;
  }
  ends.push_back(to);
  return ends;
}

// The limits between two jumps; both ends are inside.
void add_limits(const Curve& curve, double from, double to, std::vector<StepLimit>& limits) {
  constexpr double negligible = 1e-12;
  const auto ends = turning_points(curve, from, to);
  double size = 0.0;
  for (const double t : ends) {
    if (const double value = std::abs(curve.value(std::max(t, later * to))); std::isfinite(value))
      size = std::max(size, value);
  }
  add_limits(runs_of(curve.value, ends, negligible * size), limits);
}

// The functions of t whose changes of sign are jumps or kinks of the rows, and the tables that have these.
struct Breaks {
  std::vector<TimeFunction> functions{};
  std::vector<TableTimes> tables{};
};

// Whether a function is 0 at the start, and up to where it leaves 0 by the rounding of its time: no jump.
bool is_start(const SignedPiece& piece, double end) {
  constexpr double rounding = 1e-10;
  return piece.sign == 0.0 && piece.to <= rounding * end;
}

// The given times, and those at which a function changes its sign.
std::vector<double> times_until(double end, const Breaks& breaks, std::vector<double> times) {
  for (const auto& table : breaks.tables) std::ranges::copy(table.until(end), std::back_inserter(times));
  for (const auto& argument : breaks.functions) {
    const auto pieces = argument.signs(first_part * end, end);
    for (std::size_t k = 1; k < pieces.size(); ++k) {
      if (pieces[k - 1].to == pieces[k].from && !is_start(pieces[k - 1], end))
        times.push_back(pieces[k].from);
    }
  }
  return increasing(std::move(times), same_time);
}

std::vector<StepLimit> limits_until(double end, const std::vector<Curve>& curves,
                                    const std::vector<double>& breaks) {
  std::vector<StepLimit> limits;
  double from = first_part * end;
  const auto add_until = [&](double to) {
    for (const auto& curve : curves) add_limits(curve, from, std::nextafter(to, 0.0), limits);
    from = std::nextafter(to, end);
  };
  for (const double time : breaks)
    if (time > from && time < end) add_until(time);
  add_until(end);
  return limits;
}

// Limits by which no step passes over two zeros of a function.
void add_limits_between_zeros(const TimeFunction& function, double end, std::vector<StepLimit>& limits) {
  const auto zeros = times_until(end, {.functions = {function}}, {});
  for (std::size_t k = 1; k < zeros.size(); ++k)
    limits.push_back({zeros[k - 1], zeros[k], (zeros[k] - zeros[k - 1]) / 2.0});
}

}  // namespace

std::function<LoadTimes(double end)> load_times(const std::vector<Expression>& rows,
                                                std::vector<double> declared_jumps, ExpressionPool& pool,
                                                const std::vector<Expression>& event_functions) {
  Breaks of_jumps, of_kinks;
  for (const auto argument : pool.switches(rows, jumps_without_table))
    if (!pool.depends_on_unknowns(argument)) of_jumps.functions.emplace_back(argument, pool);
  for (const auto argument : kinks_in(rows, pool)) of_kinks.functions.emplace_back(argument, pool);
  for (const auto value : table_values(rows, pool)) {
    const bool is_jump = pool[value].function->jumping_derivative() == 0;
    (is_jump ? of_jumps : of_kinks).tables.emplace_back(value, pool);
  }
  std::vector<Curve> curves;
  for (const auto part : time_parts(rows, pool)) {
    try {
      if (!table_values({part}, pool).empty() && is_polynomial(part, pool)) continue;
      const auto slope = pool.derivative(part, 0), curvature = pool.derivative(slope, 0);
      const TimeFunction value(part, pool), first(slope, pool), second(curvature, pool);
      curves.push_back({value, first});
      curves.push_back({first, second});
    } catch (const std::invalid_argument&) {
      continue;  // the argument of gamma, for example: such a part is known at points only
    }
  }
  std::vector<TimeFunction> events;
  for (const auto function : event_functions)
    if (!pool.depends_on_unknowns(function)) events.emplace_back(function, pool);
  return [=, declared = std::move(declared_jumps)](double end) {
    LoadTimes times{.jumps = times_until(end, of_jumps, declared), .kinks = times_until(end, of_kinks, {})};
    times.limits = limits_until(end, curves, times_until(end, {.tables = of_kinks.tables}, times.jumps));
    for (const auto& function : events) add_limits_between_zeros(function, end, times.limits);
    return times;
  };
}

std::function<std::vector<double>(double end)> times_between_zeros(Expression function,
                                                                   ExpressionPool& pool) {
  return [breaks = Breaks{.functions = {TimeFunction(function, pool)}}](double end) {
    const auto zeros = times_until(end, breaks, {});
    std::vector<double> times;
    for (std::size_t k = 1; k < zeros.size(); ++k)
      times.push_back(zeros[k - 1] + (zeros[k] - zeros[k - 1]) / 2.0);
    return times;
  };
}

}  // namespace fde::bench
