#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "measures/ending.hpp"
#include "records/setup.hpp"
#include "references/watched_reference.hpp"
#include "search/question.hpp"
#include "search/total_variation.hpp"
#include "stepping/scheme.hpp"

namespace fde {

// A configuration of a search: a scheme with a grading of its grid, or a scheme with adaptive step size.
// The number of steps or the tolerance is free.
struct Way {
  const Scheme* scheme = nullptr;
  double grading = 1.0;

  [[nodiscard]] bool chooses_steps() const { return !scheme->needs.takes_grid; }
};

// One run of a configuration, compared with the reference.
struct Attempt {
  int steps = 0;                                           // of the grid, or taken by an adaptive step size
  std::optional<double> asked{};                           // requested tolerance, with adaptive step size
  double error = std::numeric_limits<double>::infinity();  // infinity: the run did not reach the end time
  double trivial = 0.0;  // error of the baseline y = 0 or y = y(0); infinity where the solution is constant
  Eigen::Index column = 0;    // index of the scene's column with the largest error
  double time = 0.0;          // of the largest error
  double signed_error = 0.0;  // at the end time, where exactly one column is compared
  bool within = false;        // error + bound of the reference <= accuracy, and error < trivial
  double seconds = 0.0;       // wall time of one solve
  RunEnding ending{};
  Rows values{};  // the compared columns at the comparison times, one row a column
};

// The number of steps or the tolerance of the run.
StepsOrAccuracy resolution_of(const Attempt& attempt);

// Runs configurations on a scene and measures their errors against its reference. The scene must outlive
// this object.
class Examiner {
 public:
  Examiner(const Scene& scene, Question question);

  // Compares the run with the reference at about `watched` times, for Norm::end at the end time only. The run
  // stops after `budget` seconds. Throws std::runtime_error if there is no finite reference.
  Attempt examine(const Way& way, const StepsOrAccuracy& resolution, int watched, double budget);

  // Whether both configurations, on grids with this number of steps, give the same bits at the comparison
  // times.
  bool same_values(const Way& one, const Way& other, int steps);

  // Solves without a comparison or a budget, for timing.
  void solve_to_end(const Way& way, const StepsOrAccuracy& resolution) const;

  // Evaluates the reference at this number of equally spaced times; later comparisons reuse the values.
  void know_reference(int times);

  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] const Question& question() const { return question_; }

  // Whether the solution equals y(0) at all sampled times, to rounding and the bounds of the reference. The
  // baseline y = y(0) is then correct, so `trivial` does not apply.
  bool is_constant();

  // Error bound of the reference at the end time, on the scale of the question. It is added to every error.
  double reference_bound() { return at_end().bound; }

 private:
  Rows finite_reference(const std::vector<double>& times);
  void judge_all(const std::vector<double>& times, Attempt& attempt);
  void judge_end(Attempt& attempt);
  [[nodiscard]] Rows counted(const Rows& columns) const;
  [[nodiscard]] std::vector<double> compared_times(const Way& way, const StepsOrAccuracy& resolution,
                                                   int watched) const;
  [[nodiscard]] Trajectory solve(const Way& way, const StepsOrAccuracy& resolution,
                                 const std::vector<double>& times, double budget) const;

  const Scene& scene_;
  Question question_;
  WatchedReference reference_;
  struct AtEnd {
    Rows reference, divisors;
    double trivial, bound;
  };
  const AtEnd& at_end();
  std::optional<AtEnd> at_end_{};
  std::optional<bool> is_constant_{};
  // Of the reference, on the scale of the question, at times that are independent of any grid.
  const TotalVariation& variation();
  std::optional<TotalVariation> variation_{};
};

}  // namespace fde
