#pragma once

#include <cstddef>
#include <memory>
#include <string_view>
#include <vector>

#include "problem.hpp"
#include "weights.hpp"

namespace fde {

// The past of one run: samples x_0, x_1, ... (one value a component) go in, discrete convolutions come out.
// Several sums share the samples: predictor and corrector weigh the same f with different tables.
class History {
 public:
  History() = default;
  History(const History&) = delete;
  History& operator=(const History&) = delete;
  virtual ~History() = default;

  // Appends x_n after n earlier ones.
  virtual void push(In sample) = 0;

  // start_weight_i(n) x_{0,i} + sum_{1<=j<n} w_i(n-j) x_{j,i} for every component i, where n >= 1 samples
  // have been pushed and the weights are those of tables[sum][i] of make_history.
  virtual void convolve(std::size_t sum, Out result) const = 0;

  // Memory for samples and weights.
  [[nodiscard]] virtual std::size_t bytes() const = 0;
};

// tables[sum][i] is the weight table of component i in that sum.
using WeightTables = std::vector<std::vector<WeightTable>>;

enum class HistoryKind { automatic, direct };

// The engine a run of this many steps uses: what `automatic` stands for, otherwise the kind itself.
HistoryKind resolve(HistoryKind kind, int steps);
std::string_view name(HistoryKind kind);

std::unique_ptr<History> make_history(HistoryKind kind, const WeightTables& tables, int steps);

}  // namespace fde
