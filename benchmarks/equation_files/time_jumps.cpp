// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/equation_files/time_jumps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "fdebench/benchmarks/expressions/program.hpp"

namespace fde::bench {
namespace {

// The times at which the sign is compared, up to the end. 0 is left out, where for example sin(t) is 0.
std::vector<double> places(double end) {
  constexpr int equal = 8192, halved = 64;
  std::vector<double> times;
  for (int i = 1; i <= equal; ++i) times.push_back(end * i / equal);
  for (int i = 1; i <= halved; ++i) times.push_back(std::ldexp(end, -i));
  std::ranges::sort(times);
  return times;
}

class SignOfTime {
 public:
  explicit SignOfTime(Program program) : program_(std::move(program)) {}

  // -1, 0 or 1; NaN if the value is NaN.
  double operator()(double t) const {
    const double value = program_(t, Vec());
    return value > 0.0 ? 1.0 : value < 0.0 ? -1.0 : value;
  }

 private:
  Program program_;
};

// The first double after `from` at which the sign differs from that at `from`; the sign at `to` must differ.
double bisect_sign_change(const SignOfTime& sign, double from, double to) {
  const double before = sign(from);
  while (true) {
    const double middle = from + (to - from) / 2.0;
    if (middle <= from || middle >= to) return to;
    (sign(middle) == before ? from : to) = middle;
  }
}

void add_changes(const SignOfTime& sign, double end, std::vector<double>& found) {
  const auto times = places(end);
  double before = sign(times.front());
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double now = sign(times[i]);
    // False if either side is NaN.
    const bool changes = now < before || now > before;
    if (changes) found.push_back(bisect_sign_change(sign, times[i - 1], times[i]));
    before = now;
  }
}

// A zero exactly at one of the times is found in both adjacent steps.
bool same_time(double a, double b) {
  constexpr double few = 4.0 * std::numeric_limits<double>::epsilon();
  return b - a <= few * b;
}

}  // namespace

std::function<std::vector<double>(double end)> time_jumps(const std::vector<Expression>& rows,
                                                          std::vector<double> declared,
                                                          const ExpressionPool& pool) {
  std::vector<SignOfTime> signs;
  for (const auto argument : pool.arguments(rows, {Operation::sign, Operation::step}))
    if (!pool.depends_on_unknowns(argument)) signs.emplace_back(Program(pool, {argument}, 0));
  return [signs = std::move(signs), declared = std::move(declared)](double end) {
    auto jumps = declared;
    for (const auto& sign : signs) add_changes(sign, end, jumps);
    std::ranges::sort(jumps);
    jumps.erase(std::unique(jumps.begin(), jumps.end(), same_time), jumps.end());
    return jumps;
  };
}

}  // namespace fde::bench
