#pragma once

#include <compare>
#include <limits>
#include <string>
#include <string_view>
#include <tuple>
#include <variant>

#include "problem/resolution.hpp"
#include "stepping/scheme.hpp"

namespace fde {

inline auto operator<=>(const Accuracy& a, const Accuracy& b) {
  return std::tie(a.relative, a.absolute) <=> std::tie(b.relative, b.absolute);
}
inline bool operator==(const Accuracy& a, const Accuracy& b) {
  return a.relative == b.relative && a.absolute == b.absolute;
}

using StepsOrAccuracy = std::variant<int, Accuracy>;

// How a run is made. With its scene and its scheme it names the run: a sweep does each one once.
struct Setup {
  StepsOrAccuracy resolution = 1;
  double grading = 1.0;  // of the grid
  HistoryKind history = HistoryKind::automatic;
  double tolerance = Options{}.tolerance;
  double budget = std::numeric_limits<double>::infinity();  // seconds for each solve

  auto operator<=>(const Setup&) const = default;

  [[nodiscard]] Options options() const;
};

// What the scheme is asked for up to this time.
Resolution resolution_of(const Setup& setup, double end);

// Whether two setups differ in their number of steps at most, or in their accuracy: their runs are of one
// line of a chart.
bool same_line(Setup a, const Setup& b);

// "uniform" or "graded:R"; "N = 64" or "accuracy 1e-6, 1e-9".
std::string grid_text(double grading);
std::string resolution_text(const Setup& setup);

// Of "uniform" or "graded:R" its grading; of "auto", "direct" or "exponentials" the history. Each throws
// std::invalid_argument naming the argument of the command line, the text and what is allowed.
double parse_grading(std::string_view text);
HistoryKind parse_history(std::string_view text);

}  // namespace fde
