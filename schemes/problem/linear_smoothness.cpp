#include "linear_smoothness.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>

namespace fde {
namespace {

// Coefficients of t^p / Gamma(p+1) in all components, by p. Integration of any order then only shifts p.
class Series {
 public:
  explicit Series(Eigen::Index size) : size_(size) {}
  Vec& operator[](double power) {
    const auto near = terms_.lower_bound(power - 1e-9);
    if (near != terms_.end() && same_order(near->first, power)) return near->second;
    return terms_.emplace(power, Vec::Zero(size_)).first->second;
  }
  [[nodiscard]] const std::map<double, Vec>& terms() const { return terms_; }

 private:
  Eigen::Index size_;
  std::map<double, Vec> terms_;
};

}  // namespace

Smoothness linear_smoothness(const std::vector<Component>& components, const Matrix& matrix,
                             const Vec& constants) {
  const Eigen::Index size = matrix.rows();
  Series series(size);
  double last = 2.0;
  for (Eigen::Index i = 0; i < size; ++i) {
    const auto& component = components[static_cast<std::size_t>(i)];
    if (algebraic(component)) {
      throw std::invalid_argument("smoothness: component " + std::to_string(i) +
                                  " has order 0, orders have to be above 0");
    }
    const auto& initial = component.initial;
    last = std::max(last, component.order + 2.0);
    for (std::size_t k = 0; k < initial.size(); ++k) series[static_cast<double>(k)][i] = initial[k];
  }
  Smoothness smoothness;
  smoothness.powers.resize(components.size());
  // All that leads to a power is smaller: by increasing powers every coefficient is complete when it is met.
  for (auto term = series.terms().begin(); term != series.terms().end() && term->first <= last; ++term) {
    const auto& [power, coefficients] = *term;
    Vec driven = matrix * coefficients;
    if (power == 0.0) driven += constants;
    for (Eigen::Index i = 0; i < size; ++i) {
      const auto& order = components[static_cast<std::size_t>(i)].order;
      const bool given = power < order;  // by the initial values
      if (!given && coefficients[i] != 0.0) smoothness.powers[static_cast<std::size_t>(i)].push_back(power);
      if (driven[i] != 0.0) series[power + order][i] += driven[i];
    }
  }
  return smoothness;
}

}  // namespace fde
