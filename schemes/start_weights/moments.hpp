#pragma once

#include <memory>
#include <vector>

#include "start_weights/start_weights.hpp"

namespace fde {

// The equations of the start weights in multiprecision (number_series.hpp), whose headers are read behind
// this alone.
class Moments {
 public:
  // The points, 1 <= point <= 2, are where far_weights tells them.
  Moments(const WeightTable& table, const std::vector<double>& powers, const std::vector<double>& points);
  ~Moments();
  Moments(const Moments&) = delete;
  Moments& operator=(const Moments&) = delete;
  Moments(Moments&&) = delete;
  Moments& operator=(Moments&&) = delete;

  // W(n, j) for n = 1 ... K, one row a step, from the sums as they stand. From K on the expansions are as
  // good as doubles: all other singularities of the generating function have decayed.
  [[nodiscard]] Matrix near_weights() const;

  // W(x, j) at x = K 2^piece point, one row a point: continued to real x by the expansions at 1 and at -1.
  [[nodiscard]] StartWeights::Piece far_weights(std::size_t piece) const;

  // See usable_powers.
  static UsablePowers usable(const WeightTable& table, const std::vector<double>& powers, double most);

 private:
  struct Numbers;
  struct Expansions;
  struct PowersAt;
  std::unique_ptr<Numbers> numbers_;
  std::unique_ptr<Expansions> expansions_;
  std::vector<PowersAt> points_;
};

}  // namespace fde
