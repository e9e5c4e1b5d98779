#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "problem/grid.hpp"
#include "problem/problem.hpp"
#include "weights/weights.hpp"

namespace fde {

class Archive;

// The past of one run: samples x_0, x_1, ... (one value a component) go in, discrete convolutions come out.
// Several sums share the samples: predictor and corrector weigh the same f with different tables.
class History {
 public:
  History() = default;
  History& operator=(const History&) = delete;
  virtual ~History() = default;

  // The same history with what it has been given so far. Copies of an empty one spare its making.
  [[nodiscard]] virtual std::unique_ptr<History> copy() const = 0;

  // Appends the next sample, taken at time t. Times increase. Where all steps are equal, the number of
  // samples says the time, and t is not looked at; the same holds for convolve.
  virtual void push(double t, In sample) = 0;

  // What a step from the newest sample to the candidate time t sees of the past: for every component i, in
  // which n >= 1 samples have been pushed,
  //   start_weight_i(n) x_{0,i} + sum_{1<=j<n} w_i(n-j) x_{j,i}
  // with the weights of tables[sum][i] of make_history. Where steps differ, the weights are integrals over
  // them, in units in which the newest sample has weight 1. A rejected step is a call that no push follows:
  // candidates leave no trace. One thread at a time, as a history keeps what it computed for its last one.
  virtual void convolve(double t, std::size_t sum, Out result) const = 0;

  // Memory for samples and weights.
  [[nodiscard]] virtual std::size_t bytes() const = 0;

  // What it keeps of the samples.
  virtual void state(Archive& archive) = 0;

 protected:
  History(const History&) = default;
};

// tables[sum][i] is the weight table of component i in that sum.
using WeightTables = std::vector<std::vector<WeightTable>>;

// The steps that a history is made for. The first starts at time 0.
struct StepPlan {
  double end = 1.0;            // the last step ends here, or before
  double shortest = 1.0;       // no step is shorter, up to rounding
  bool equal = false;          // all steps are as long as the shortest
  std::optional<int> count{};  // how many they are, where that is known

  // The known count; otherwise the most that fit.
  [[nodiscard]] int most() const;
};
StepPlan step_plan(const Grid& grid);

enum class HistoryKind { automatic, direct, exponentials };

// The engine that a run with these steps uses: what `automatic` stands for, otherwise the kind itself.
HistoryKind resolve(HistoryKind kind, const StepPlan& steps);
std::string_view name(HistoryKind kind);

// The tolerance is the relative error allowed to each weight, at least rounding and at most a tenth; `direct`
// is always exact, and `automatic` takes it for families without exponentials. Throws std::invalid_argument
// that names the family where it has no exponentials or no weights for steps that differ. Exponentials of
// equal steps are shared among threads, with the same bits for any number of them.
std::unique_ptr<History> make_history(HistoryKind kind, const WeightTables& tables, const StepPlan& steps,
                                      double tolerance, int threads = 1);

}  // namespace fde
