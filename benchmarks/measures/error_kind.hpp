// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "fdebench/schemes/stepping/scheme.hpp"
#include "fdebench/schemes/stepping/trajectory.hpp"

namespace fde::bench {

// The divisor of the error e of a value with reference r. Relative: |r|, but at least a thousandth of its
// maximum over [0.9 t, t], for a reference that passes through 0 at t; errors are left out if that maximum is
// 0. Mixed: 1 + |r|, the scale of mescd, the significant digits of the IVP test set (Bari) and FDE-Testset
// (Brugnano et al. 2025). Peak: the largest |r| of the column over all compared times, which does not depend
// on the unit; errors of a column that is 0 at all times are left out.
enum class Scale { absolute, relative, mixed, peak };

inline constexpr std::array error_scales{Scale::absolute, Scale::relative, Scale::mixed, Scale::peak};

// The norm in time, at the end or the maximum over all times, and the scale.
struct ErrorKind {
  Norm norm = Norm::maximum;
  Scale scale = Scale::mixed;

  bool operator==(const ErrorKind&) const = default;
};

// All combinations of norm and scale.
inline constexpr std::array error_kinds{
    ErrorKind{Norm::end, Scale::absolute},     ErrorKind{Norm::end, Scale::relative},
    ErrorKind{Norm::end, Scale::mixed},        ErrorKind{Norm::end, Scale::peak},
    ErrorKind{Norm::maximum, Scale::absolute}, ErrorKind{Norm::maximum, Scale::relative},
    ErrorKind{Norm::maximum, Scale::mixed},    ErrorKind{Norm::maximum, Scale::peak}};

// "end", "maximum"; "absolute", "relative", "mixed", "peak"; and the inverses, which throw
// std::invalid_argument naming the command-line option and what is allowed.
std::string_view name(Norm norm);
std::string_view name(Scale scale);
Norm parse_norm(std::string_view text);
Scale parse_scale(std::string_view text);
std::vector<std::string> scale_names();

// The id of the measure of this error, "error_end", "error_maximum_mixed", ..., and of its constant-solution
// baseline, "baseline_end", ...
constexpr std::string_view error_measure(const ErrorKind& kind) {
  constexpr std::array<std::string_view, error_kinds.size()> ids{
      "error_end",     "error_end_relative",     "error_end_mixed",     "error_end_peak",
      "error_maximum", "error_maximum_relative", "error_maximum_mixed", "error_maximum_peak"};
  return ids[static_cast<std::size_t>(std::ranges::find(error_kinds, kind) - error_kinds.begin())];
}
constexpr std::string_view baseline_measure(const ErrorKind& kind) {
  constexpr std::array<std::string_view, error_kinds.size()> ids{
      "baseline_end",     "baseline_end_relative",     "baseline_end_mixed",     "baseline_end_peak",
      "baseline_maximum", "baseline_maximum_relative", "baseline_maximum_mixed", "baseline_maximum_peak"};
  return ids[static_cast<std::size_t>(std::ranges::find(error_kinds, kind) - error_kinds.begin())];
}

// The id of the measure of the variation that a maximum over the steps of a grid misses (TotalVariation).
constexpr std::string_view unresolved_measure(Scale scale) {
  constexpr std::array<std::string_view, error_scales.size()> ids{
      "unresolved_maximum", "unresolved_maximum_relative", "unresolved_maximum_mixed",
      "unresolved_maximum_peak"};
  return ids.at(static_cast<std::size_t>(scale));
}

// The divisors of errors, one row a column of the scene, one column a time; infinity if an error is left out.
// Precondition: the times increase.
Rows divisors(Scale scale, const std::vector<double>& times, const Rows& reference);

// |values - reference| / divisor of each column of the scene, at the last time or the maximum over all times.
Vec errors_of(Norm norm, const Rows& values, const Rows& reference, const Rows& divisors);

// Whether the reference equals its first value at all times, to its bounds and rounding: the constant y =
// y(0) is then right, and a run is no worse for being as good.
bool is_constant(const Rows& reference, const Rows& bounds);

// The constant-solution baseline: the largest error over the columns of the better of y = 0 and y = y(0). A
// run that is no better is useless.
double constant_solution_error(Norm norm, const std::vector<double>& times, const Rows& reference,
                               const Rows& divisors);

// The errors of each column of the scene alone: one row a column, one column a kind in the order of
// error_kinds. Of a run, and for t > 0 of y = 0 and, if the times begin at 0, of y = y(0); otherwise `start`
// repeats `zero`. Empty without a reference.
struct ErrorTable {
  Matrix run{}, zero{}, start{};
};
ErrorTable error_table(const std::vector<double>& times, const Rows& values, const Rows& reference);

}  // namespace fde::bench
