#include "measures/accuracy.hpp"
#include "measures/measures.hpp"

namespace fde {
namespace {

using Value = std::optional<double>;

bool has_reference(const FinishedRun& run) { return run.reference.cols() > 0; }
bool has_rounding(const FinishedRun& run) { return run.observed.rounded.cols() > 0; }

template <double (*error)(const Rows& values, const Rows& reference)>
Value against_reference(const FinishedRun& run) {
  return has_reference(run) ? Value(error(run.values, run.reference)) : std::nullopt;
}

Value relative(const FinishedRun& run) {
  return has_reference(run) ? relative_error(run.values, run.reference, run.reference_bound) : std::nullopt;
}

Value rounding_at_end(const FinishedRun& run) {
  if (!has_rounding(run)) return std::nullopt;
  return error_end(run.values, run.observed.rounded);
}

Value rounding_decides_from(const FinishedRun& run) {
  if (!has_reference(run) || !has_rounding(run)) return std::nullopt;
  const auto column = rounding_dominates(run.values, run.observed.rounded, run.reference);
  if (!column) return std::nullopt;
  return run.path.time(*column);
}

Value bound_of_reference(const FinishedRun& run) {
  return has_reference(run) ? Value(run.reference_bound.maxCoeff()) : std::nullopt;
}

}  // namespace

constinit const Measure measure::error_end{"error_end", "", against_reference<fde::error_end>};
constinit const Measure measure::error_maximum{"error_maximum", "", against_reference<fde::error_maximum>};
constinit const Measure measure::error_relative{"error_relative", "", relative};
constinit const Measure measure::rounding{"rounding", "", rounding_at_end};
constinit const Measure measure::rounding_from{"rounding_from", "t", rounding_decides_from};
constinit const Measure measure::mescd{"mescd", "digits", against_reference<fde::mescd>};
constinit const Measure measure::reference_bound{"reference_bound", "", bound_of_reference};

}  // namespace fde
