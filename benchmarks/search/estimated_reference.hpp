#pragma once

#include <optional>
#include <string>

#include "scenes/scene.hpp"
#include "search/attempt.hpp"
#include "search/question.hpp"

namespace fde {

// What stands for a reference where none can be had: the finer of two runs of different schemes, the second
// with half the steps, so that an error that both rules share shows in their difference too. It is no bound.
struct Estimate {
  std::string missing{};  // why there is no reference
  Way first{}, second{};  // the first is the one whose values stand for the solution
  int first_steps = 0, second_steps = 0;
  double difference = 0.0;  // the largest of the columns that count, on the scale asked for
  double factor = 0.0;      // times the difference: what is taken for the error of the first run

  [[nodiscard]] double error() const { return factor * difference; }
};

// The factor where the difference has become `ratio` times smaller with each doubling of the steps: an error
// like N^-p that moves by d from N/2 to N is d / (2^p - 1), and no less than d is taken; four times that.
// Infinite where it does not fall.
double estimate_factor(double ratio);

// The part of an accuracy that the error of an estimate may be.
inline constexpr double estimate_part = 0.1;

// What a search measures errors against: known, or estimated.
struct SearchReference {
  Reference reference{};
  std::optional<Estimate> estimate{};
};

// The reference of the scene, or, where that cannot be had, an estimate that is far enough below the accuracy
// asked for, made within so many seconds. Of all schemes and gradings that come to their end with few steps
// the two of different schemes, an implicit and an explicit one where there are both, are taken whose results
// move least with their steps. They double their steps until they agree, the slower of the last two falls of
// their difference counting. For errors at the end they are compared in the last tenth of the times. Throws a
// Singularity where that is why there is no reference, and std::runtime_error with both reasons where the two
// do not agree in time.
SearchReference reference_or_estimate(const Scene& scene, const Question& question, double seconds,
                                      const Tell& tell);

// The same of a scene without a reference for this reason.
SearchReference estimated_reference(const Scene& scene, const Question& question, const std::string& missing,
                                    double seconds, const Tell& tell);

}  // namespace fde
