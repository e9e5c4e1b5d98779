#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "stepping/scheme.hpp"
#include "stepping/trajectory.hpp"

namespace fde {

// What the difference e between a value and its reference r is divided by. Relative errors divide by |r|; a
// reference that passes through 0 at t counts as a thousandth of its size in [0.9 t, t], and one that is 0
// all that time is left out. The mixed scale is that of mescd, the significant digits of the IVP test set
// (Bari) and FDE-Testset (Brugnano et al. 2025): |e| / (1 + |r|).
enum class Scale { absolute, relative, mixed };

// Where an error is taken, at the end or as the largest over all times, and on which scale.
struct ErrorKind {
  Norm norm = Norm::maximum;
  Scale scale = Scale::mixed;

  bool operator==(const ErrorKind&) const = default;
};

// All of them.
std::span<const ErrorKind> error_kinds();

// "end", "maximum"; "absolute", "relative", "mixed"; and back. The latter throw std::invalid_argument naming
// the argument of the command line and what is allowed.
std::string_view name(Norm norm);
std::string_view name(Scale scale);
Norm parse_norm(std::string_view text);
Scale parse_scale(std::string_view text);

// The measure of this kind of error: "error_end", "error_maximum_mixed", ...; and of what is trivial in it.
std::string_view error_measure(const ErrorKind& kind);
std::string_view trivial_measure(const ErrorKind& kind);

// What errors are divided by, one row a column of the scene, one column a time; infinity where an error is
// left out. The times increase.
Rows divisors(Scale scale, const std::vector<double>& times, const Rows& reference);

// max |values - reference| / divisor over the columns of the scene, at the last time or over all times.
double error_of(Norm norm, const Rows& values, const Rows& reference, const Rows& divisors);

// The error behind t = 0 that y = 0 would have, or y = y(0) where that is less and the times begin at 0: who
// does not do better has computed nothing.
double trivial_error(Norm norm, const std::vector<double>& times, const Rows& reference,
                     const Rows& divisors);

}  // namespace fde
