#pragma once

#include <optional>
#include <span>
#include <vector>

namespace fde {

struct ErrorWith {
  int steps = 0;
  double error = 0.0;
};

// A number that is expected, and between which it is uncertain.
struct Expected {
  double value = 0.0, low = 0.0, high = 0.0;
};

// The slope of the finest of these errors, at most five, by the fit of all rates; nullopt: too few above
// rounding.
std::optional<double> observed_rate(std::span<const ErrorWith> measured);

// How the error of a line falls with its steps: e(N) = a N^-p + b N^-q, p < q. All pairs of powers whose
// curve goes through the measured errors about as well as the best are kept; what they differ by is the
// uncertainty.
class ErrorModel {
 public:
  // Of the finest of these errors, at most five. Fewer than two that are above 0, or none that falls: no
  // model.
  explicit ErrorModel(std::span<const ErrorWith> measured);

  [[nodiscard]] bool empty() const { return curves_.empty(); }

  // Preconditions: not empty.
  [[nodiscard]] Expected error(double steps) const;
  [[nodiscard]] Expected steps(double error) const;  // the fewest with this error

 private:
  struct Curve {
    double p = 0.0, q = 0.0, a = 0.0, b = 0.0;  // of N / scale_
    double misfit = 0.0;                        // relative to the errors, root of the mean square

    [[nodiscard]] double at(double n) const;
  };
  [[nodiscard]] double steps_of(const Curve& curve, double error) const;

  double scale_ = 1.0;
  std::vector<Curve> curves_{};
  std::size_t best_ = 0;
};

}  // namespace fde
