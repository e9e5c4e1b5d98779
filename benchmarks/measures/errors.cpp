#include "fdebench/benchmarks/measures/accuracy.hpp"
#include "fdebench/benchmarks/measures/error_kind.hpp"
#include "fdebench/benchmarks/measures/measures.hpp"

namespace fde {
namespace {

using Value = std::optional<double>;

bool has_reference(const FinishedRun& run) { return run.reference.cols() > 0; }
bool has_rounding(const FinishedRun& run) { return run.observed.rounded.cols() > 0; }

template <Norm norm, Scale scale>
Value error(const FinishedRun& run) {
  if (!has_reference(run)) return std::nullopt;
  return error_of(norm, run.values, run.reference, divisors(scale, run.path.times, run.reference));
}

// The constant-solution baseline, if the run is not better.
template <Norm norm, Scale scale>
Value trivial(const FinishedRun& run) {
  if (!has_reference(run)) return std::nullopt;
  const auto& times = run.path.times;
  const double least =
      constant_solution_error(norm, times, run.reference, divisors(scale, times, run.reference));
  return least <= *error<norm, scale>(run) ? Value(least) : std::nullopt;
}

Value digits(const FinishedRun& run) {
  return has_reference(run) ? Value(mescd(run.values, run.reference)) : std::nullopt;
}

Value relative(const FinishedRun& run) {
  return has_reference(run) ? relative_error(run.values, run.reference, run.reference_bounds.rightCols(1))
                            : std::nullopt;
}

Value rounding_at_end(const FinishedRun& run) {
  if (!has_rounding(run)) return std::nullopt;
  return (run.values - run.observed.rounded).rightCols(1).cwiseAbs().maxCoeff();
}

Value rounding_dominates_from(const FinishedRun& run) {
  if (!has_reference(run) || !has_rounding(run)) return std::nullopt;
  const auto column = rounding_dominates(run.values, run.observed.rounded, run.reference);
  if (!column) return std::nullopt;
  return run.path.time(*column);
}

template <Norm norm>
Value bound(const FinishedRun& run) {
  if (!has_reference(run)) return std::nullopt;
  const auto columns = norm == Norm::end ? 1 : run.reference_bounds.cols();
  return run.reference_bounds.rightCols(columns).maxCoeff();
}

}  // namespace

constinit const Measure measure::error_end{"error_end", "", error<Norm::end, Scale::absolute>};
constinit const Measure measure::error_end_relative{"error_end_relative", "",
                                                    error<Norm::end, Scale::relative>};
constinit const Measure measure::error_end_mixed{"error_end_mixed", "", error<Norm::end, Scale::mixed>};
constinit const Measure measure::error_maximum{"error_maximum", "", error<Norm::maximum, Scale::absolute>};
constinit const Measure measure::error_maximum_relative{"error_maximum_relative", "",
                                                        error<Norm::maximum, Scale::relative>};
constinit const Measure measure::error_maximum_mixed{"error_maximum_mixed", "",
                                                     error<Norm::maximum, Scale::mixed>};
constinit const Measure measure::trivial_end{"trivial_end", "", trivial<Norm::end, Scale::absolute>};
constinit const Measure measure::trivial_end_relative{"trivial_end_relative", "",
                                                      trivial<Norm::end, Scale::relative>};
constinit const Measure measure::trivial_end_mixed{"trivial_end_mixed", "", trivial<Norm::end, Scale::mixed>};
constinit const Measure measure::trivial_maximum{"trivial_maximum", "",
                                                 trivial<Norm::maximum, Scale::absolute>};
constinit const Measure measure::trivial_maximum_relative{"trivial_maximum_relative", "",
                                                          trivial<Norm::maximum, Scale::relative>};
constinit const Measure measure::trivial_maximum_mixed{"trivial_maximum_mixed", "",
                                                       trivial<Norm::maximum, Scale::mixed>};
constinit const Measure measure::error_relative{"error_relative", "", relative};
constinit const Measure measure::rounding{"rounding", "", rounding_at_end};
constinit const Measure measure::rounding_from{"rounding_from", "t", rounding_dominates_from};
constinit const Measure measure::mescd{"mescd", "digits", digits};
constinit const Measure measure::reference_bound{"reference_bound", "", bound<Norm::end>};
constinit const Measure measure::reference_bound_maximum{"reference_bound_maximum", "", bound<Norm::maximum>};

}  // namespace fde
