// SPDX-License-Identifier: MIT
#pragma once

#include "fdebench/schemes/problem/archive.hpp"
#include "fdebench/schemes/stepping/run.hpp"
#include "fdebench/schemes/stepping/trajectory.hpp"

namespace fde {

// How a step has ended: with a result at t, or why the step to t has none.
struct StepOutcome {
  double t;
  SolveStatus status = SolveStatus::finished;
};

// The base of what integrate() takes: a scheme on one problem that starts, takes one step after another, and
// chooses where each ends. Such a class has
//   bool is_at_end() const       whether there is no next step,
//   StepOutcome advance()        takes the next step,
//   const Vec& result() const    y at the end of the last step,
//   void state(Archive&)         saves or restores the state between two steps,
// and redefines those functions below that it needs. None is virtual: six virtual calls would take a tenth of
// the time of the cheapest step.
class Stepper {
 public:
  Stepper& operator=(Stepper&&) = delete;

  // Computes what precedes the first step. Not called where the run resumes from a checkpoint.
  static StepOutcome start() { return {0.0}; }

  // The interpolant of the last step; nullptr: there is none.
  [[nodiscard]] static constexpr const StepInterpolant* interpolant() { return nullptr; }

  // Called after the result of the step to t has been recorded, also where an event within the step has ended
  // the run.
  static void accept(double /*t*/) {}

  // y at a time from 0 to the end of the last step, with Options::wants_past.
  void at(double t, Out y) const { y = run_.interpolated(t); }

  // Completes the cost of the run and, with dense output, its trajectory.
  static void finish(Trajectory& /*path*/) {}

 protected:
  // `problem` and `options` must outlive this object. For `steps` see Run.
  Stepper(const Problem& problem, const Options& options, int steps = 0)
      : problem_(problem), options_(options), run_(problem, options, steps) {}
  ~Stepper() = default;

  const Problem& problem_;
  const Options& options_;
  Run run_;

  template <class Scheme>
  friend Trajectory integrate(Scheme&& scheme);
};

// The loop of every time-stepping scheme: integrates to the end of the problem, or until a step has no result
// or the run ends otherwise. Resumes from a checkpoint where there is one, and offers one between steps.
template <class Scheme>
Trajectory integrate(Scheme&& scheme) {
  Run& run = scheme.run_;
  const StateArchiver state = [&](Archive& archive) { scheme.state(archive); };
  const auto has_result = [&](const StepOutcome& step) {
    if (step.status != SolveStatus::finished) run.fail(step.status, step.t);
    return step.status == SolveStatus::finished;
  };
  const auto is_accepted = [&](double t) {
    const bool continues = run.accept(t, scheme.result(), scheme.interpolant());
    if (continues || run.ended_by_event()) scheme.accept(t);
    return continues;
  };
  if (scheme.options_.wants_past) scheme.options_.wants_past([&](double t, Out y) { scheme.at(t, y); });
  run.start_clock();
  bool continues = run.resume_from_checkpoint(state) || has_result(scheme.start());
  while (continues && !scheme.is_at_end()) {
    run.offer_checkpoint(state);
    const StepOutcome step = scheme.advance();
    continues = has_result(step) && is_accepted(step.t);
  }
  Trajectory path = run.finish();
  scheme.finish(path);
  return path;
}

}  // namespace fde
