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

// One way to solve a scene: with any number of steps over grids of one grading, or to any accuracy by a
// scheme that chooses its steps.
struct Way {
  const Scheme* scheme = nullptr;
  double grading = 1.0;

  [[nodiscard]] bool chooses_steps() const { return !scheme->needs.takes_grid; }
};

// One run of a way.
struct Attempt {
  int steps = 0;                                           // of the grid, or those taken
  std::optional<double> asked{};                           // accuracy, of a scheme that chooses its steps
  double error = std::numeric_limits<double>::infinity();  // infinite: it did not come to its end
  double trivial = 0.0;     // that y = 0 or y = y(0) has; infinity where the solution is constant
  Eigen::Index column = 0;  // of the scene, the one with the largest error, at this time
  double time = 0.0;
  double signed_error = 0.0;  // at the end, of the column that counts, where it is one
  bool within =
      false;  // the accuracy, what is not known of the reference included; better than what is trivial
  double seconds = 0.0;  // of the solve, roughly
  RunEnding ending{};
  Rows values{};  // the columns that count, at the watched times
};

// With which the attempt was made.
StepsOrAccuracy resolution_of(const Attempt& attempt);

// Makes attempts at a scene and judges them by its reference. The scene must live as long.
class Examiner {
 public:
  Examiner(const Scene& scene, Question question);

  // The run is compared at `watched` steps or less, at the last one only where the norm is the end, and
  // ends after so many seconds. Throws std::runtime_error where there is no finite reference.
  Attempt examine(const Way& way, const StepsOrAccuracy& resolution, int watched, double budget);

  // Whether runs of two ways over grids give the same values, bit for bit.
  bool same_values(const Way& one, const Way& other, int steps);

  // Only solves.
  void solve_to_end(const Way& way, const StepsOrAccuracy& resolution) const;

  // Evaluates the reference at so many times, spread evenly.
  void know_reference(int times);

  [[nodiscard]] const Scene& scene() const { return scene_; }
  [[nodiscard]] const Question& question() const { return question_; }

  // Whether the solution is y(0) at all times, as far as that is known: then y = y(0) is right, not trivial.
  bool is_constant();

  // What is not known of the reference at the end, on the scale asked for. An error is taken to be more by
  // this.
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
  // On the scale asked for, at times that no grid has.
  const TotalVariation& variation();
  std::optional<TotalVariation> variation_{};
};

}  // namespace fde
