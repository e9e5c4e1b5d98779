#pragma once

#include <cstddef>
#include <memory>
#include <string_view>
#include <vector>

#include "problem/grid.hpp"
#include "problem/problem.hpp"
#include "weights/weights.hpp"

namespace fde {

// The past of one run: samples x_0, x_1, ... (one value a component) go in, discrete convolutions come out.
// Several sums share the samples: predictor and corrector weigh the same f with different tables.
class History {
 public:
  History() = default;
  History& operator=(const History&) = delete;
  virtual ~History() = default;

  // The same history with what it has been given so far. Copies of an empty one spare its making.
  [[nodiscard]] virtual std::unique_ptr<History> copy() const = 0;

  // Appends x_n after n earlier ones.
  virtual void push(In sample) = 0;

  // On a uniform grid start_weight_i(n) x_{0,i} + sum_{1<=j<n} w_i(n-j) x_{j,i} for every component i, where
  // n >= 1 samples have been pushed and the weights are those of tables[sum][i] of make_history. On other
  // grids the weights depend on both times: they are integrals over the intervals of the grid, in units in
  // which the newest sample has weight 1.
  virtual void convolve(std::size_t sum, Out result) const = 0;

  // Memory for samples and weights.
  [[nodiscard]] virtual std::size_t bytes() const = 0;

 protected:
  History(const History&) = default;
};

// tables[sum][i] is the weight table of component i in that sum.
using WeightTables = std::vector<std::vector<WeightTable>>;

enum class HistoryKind { automatic, direct, exponentials };

// The engine that a run on this grid uses: what `automatic` stands for, otherwise the kind itself.
HistoryKind resolve(HistoryKind kind, const Grid& grid);
std::string_view name(HistoryKind kind);

// The tolerance is the relative error allowed to each weight, at least rounding and at most a tenth; `direct`
// is always exact.
std::unique_ptr<History> make_history(HistoryKind kind, const WeightTables& tables, const Grid& grid,
                                      double tolerance);

}  // namespace fde
