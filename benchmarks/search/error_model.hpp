// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace fde::bench {

// The error of a run with this number of steps.
struct TrialError {
  int steps = 0;
  double error = 0.0;
};

// A predicted number and its interval of uncertainty.
struct Prediction {
  double value = 0.0, low = 0.0, high = 0.0;
};

// The prediction of a number of steps that is known to be larger than `finest`.
Prediction steps_beyond(int finest, Prediction steps);

// The observed rate: slope of the fit_rate() line through the finest five (or fewer) of these errors. nullopt
// if too few errors are above rounding.
std::optional<double> observed_rate(std::span<const TrialError> measured);

// The error as a function of the number of steps, e(N) = a N^-p + b N^-q with p < q, fitted by least squares
// in the relative error. All pairs (p, q) whose misfit is close to the smallest are kept; their spread is the
// uncertainty of a prediction.
class ErrorModel {
 public:
  // Fits the finest five (or fewer) of these errors, given from coarse to fine. The model is empty if fewer
  // than two errors are finite and above 0, or no decreasing curve fits.
  explicit ErrorModel(std::span<const TrialError> measured);

  [[nodiscard]] bool empty() const { return curves_.empty(); }

  // Precondition: not empty().
  [[nodiscard]] Prediction error(double steps) const;
  [[nodiscard]] Prediction steps(double error) const;     // the smallest N with e(N) <= error
  [[nodiscard]] double likely_steps(double error) const;  // steps(error).value

 private:
  struct Curve {
    double p = 0.0, q = 0.0, a = 0.0, b = 0.0;  // as a function of N / scale_
    double misfit = 0.0;                        // root mean square of the relative residuals

    [[nodiscard]] double at(double x) const;  // x = log(N / scale_)
  };
  [[nodiscard]] double steps_of(const Curve& curve, double error) const;

  double scale_ = 1.0;
  std::vector<Curve> curves_{};
  std::size_t best_ = 0;
};

}  // namespace fde::bench
