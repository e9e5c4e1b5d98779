#include "fdebench/benchmarks/search/largest_tolerance.hpp"

#include <cmath>
#include <utility>

namespace fde {
namespace {

constexpr double loosest = 0.1, tightest = 1e-15, least_part = 1e-6;

}  // namespace

std::optional<Attempt> largest_tolerance(double wanted, const std::function<Attempt(double asked)>& attempt) {
  double within = wanted, beyond = wanted;
  std::optional<Attempt> best;
  Attempt first = attempt(wanted);
  if (first.within) {
    best = std::move(first);
    for (beyond = 10.0 * within; beyond <= loosest; beyond *= 10.0) {
      Attempt made = attempt(beyond);
      if (!made.within) break;
      within = beyond;
      best = std::move(made);
    }
    if (beyond > loosest) return best;
  } else {
    bool continues = first.ending.kind != Ending::out_of_budget;
    while (!best && continues && within / 10.0 >= std::max(tightest, least_part * wanted)) {
      beyond = std::exchange(within, within / 10.0);
      Attempt made = attempt(within);
      continues = made.ending.kind != Ending::out_of_budget;
      if (made.within) best = std::move(made);
    }
    if (!best) return std::nullopt;
  }
  while (beyond > 2.0 * within) {
    const double middle = std::sqrt(within * beyond);
    Attempt made = attempt(middle);
    (made.within ? within : beyond) = middle;
    if (made.within) best = std::move(made);
  }
  return best;
}

}  // namespace fde
