#include "collocation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>

#include "collocation_march.hpp"

namespace fde {

namespace {

void check(const Problem& problem) {
  const auto require = [](bool holds, const std::string& what) {
    if (!holds) {
      throw std::invalid_argument("reference solution: " + what);
    }
  };
  require(problem.end > 0.0 && std::isfinite(problem.end), "the end must be positive and finite");
  require(problem.size() > 0, "no components");
  for (std::size_t i = 0; i < problem.components.size(); ++i) {
    const auto& [order, initial] = problem.components[i];
    const std::string component = "component " + std::to_string(i);
    require(order > 0.0 && order <= 2.0, component + " needs an order in (0, 2]");
    require(initial.size() == initial_count(order), component + " needs ceil(order) initial values");
  }
}

class Reference {
 public:
  Reference(const Problem& problem, double tolerance)
      : end_(problem.end), fine_(problem, {.points = 20, .first_panel = 1e-32, .tolerance = tolerance}) {
    const PiecewiseSolution other(problem, {.points = 16, .first_panel = 3e-32, .tolerance = tolerance});
    for (const Panel& panel : fine_.panels()) {
      differences_.push_back(largest_difference(panel, other));
    }
  }

  [[nodiscard]] Truth at(double t) const {
    if (!(t >= 0.0 && t <= end_)) {
      throw std::invalid_argument("reference solution: t = " + std::to_string(t) + " is outside [0, " +
                                  std::to_string(end_) + "]");
    }
    return {fine_.at(t), t > 0.0 ? bound_at(t) : Vec::Zero(differences_.front().size())};
  }

 private:
  [[nodiscard]] Vec largest_difference(const Panel& panel, const PiecewiseSolution& other) const {
    constexpr int samples = 40;
    Vec largest = Vec::Zero(panel.values.cols());
    for (int k = 1; k <= samples; ++k) {
      const double t = k == samples ? panel.to : panel.from + panel.length() * k / samples;
      largest = largest.cwiseMax((fine_.at(t) - other.at(t)).cwiseAbs());
    }
    return largest;
  }

  // An error may change sign, so the estimate is the largest difference over the last decade of time. Earlier
  // ones are left out: the first panels are the worst and their error dies out. Rounding of f is the same in
  // both solutions.
  [[nodiscard]] Vec bound_at(double t) const {
    constexpr double safety = 2.0, window = 10.0;
    constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();
    const std::size_t last = fine_.panel_of(t);
    Vec difference = differences_[last];
    for (std::size_t k = fine_.panel_of(t / window); k < last; ++k) {
      difference = difference.cwiseMax(differences_[k]);
    }
    return safety * difference + rounding * fine_.panels()[last].size;
  }

  double end_;
  PiecewiseSolution fine_;
  std::vector<Vec> differences_;  // to the other solution, a panel each
};

}  // namespace

Exact reference_solution(const Problem& problem, const CollocationOptions& options) {
  check(problem);
  const auto reference = std::make_shared<const Reference>(problem, options.tolerance);
  return {.at = [reference](double t) { return reference->at(t); }};
}

}  // namespace fde
