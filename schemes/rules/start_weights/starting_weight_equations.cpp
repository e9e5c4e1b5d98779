// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/start_weights/starting_weight_equations.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fdebench/schemes/rules/start_weights/starting_weight_equations.cpp"
#include <hwy/foreach_target.h>  // includes this file once for each target
#include <hwy/highway.h>
// clang-format off: after the target is chosen
#include "fdebench/schemes/rules/start_weights/starting_weight_expansions-inl.hpp"
// clang-format on

HWY_BEFORE_NAMESPACE();
namespace fde::HWY_NAMESPACE {

// The relative rounding of a term of the equations.
template <class Real>
double rounding() {
  return std::pow(10.0, -Real::digits);
}

template <class Real>
class EquationsIn final : public StartingWeightEquations {
 public:
  static constexpr std::size_t near = 64;

  EquationsIn(const WeightTable& table, const std::vector<double>& powers)
      : table_(table), equations_(table, powers, near) {
    for (std::size_t k = 0; k < powers.size(); ++k) equations_.use_power(k);
    const auto rows = static_cast<Eigen::Index>(near), columns = static_cast<Eigen::Index>(powers.size());
    weights_.resize(rows, columns);
    Numbers<Real> weights(equations_.stride);
    for (std::size_t n = 0; n < near; ++n) {
      equations_.solve(equations_.moments, n * equations_.stride, powers.size(), weights);
      for (std::size_t j = 0; j < powers.size(); ++j)
        weights_(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(j)) = weights.rounded(j);
    }
    rounding_ = equations_.size_of_terms(near, powers.size(), weights) * rounding<Real>();
  }

  // Whether the weights are accurate to rounding although the terms of their equations cancel.
  [[nodiscard]] bool is_accurate() const {
    constexpr double negligible = 5e-17;
    return rounding_ <= negligible * weights_.row(weights_.rows() - 1).cwiseAbs().maxCoeff();
  }

  [[nodiscard]] Matrix tabulated_weights() const override { return weights_; }

  [[nodiscard]] StartingWeights::ChebyshevPiece asymptotic_weights(std::size_t piece) const override {
    std::call_once(expanded_, [this] {
      expansions_.emplace(table_, equations_);
      pieces_.emplace(equations_, *expansions_);
    });
    auto made = pieces_->at(near, piece);
    constexpr auto begin = static_cast<Eigen::Index>(near);
    if (expansions_->decaying) made.decaying = expansions_->decaying->rows(begin << piece, begin << piece);
    return made;
  }

 private:
  WeightTable table_;
  WeightEquations<Real> equations_;
  Matrix weights_;
  double rounding_;  // of W(near, j)
  mutable std::once_flag expanded_;
  mutable std::optional<Expansions<Real>> expansions_;
  mutable std::optional<PieceWeights<Real>> pieces_;
};

// Empty if this type of number has too few digits and there is a finer one; without a finer one, powers whose
// growth is not known are not usable.
template <class Real>
std::optional<UsablePowers> usable_in(const WeightTable& table, const std::vector<double>& powers,
                                      double most, bool has_finer) {
  constexpr std::size_t first_steps = 24;
  constexpr double needed = 1e-7;    // relative accuracy of the growth
  constexpr double smallest = 1e-8;  // growth that matters: for orders near 0 all W are near 0
  const std::size_t last = std::max(first_steps, powers.size());
  WeightEquations<Real> equations(table, powers, last);
  Numbers<Real> weights(equations.stride);
  UsablePowers usable{0, 0.0};
  for (std::size_t k = 0; k < powers.size(); ++k) {
    equations.use_power(k);
    double growth = 0.0;
    for (std::size_t n = 1; n <= last; ++n) {
      equations.solve(equations.moments, (n - 1) * equations.stride, k + 1, weights);
      double sum = 0.0;
      for (std::size_t j = 0; j <= k; ++j) sum += std::abs(weights.rounded(j));
      growth = std::max(growth, sum / std::max(1.0, std::pow(static_cast<double>(n), table.order - 1.0)));
    }
    const bool known = equations.size_of_terms(last, k + 1, weights) * rounding<Real>() <=
                       needed * std::max(growth, smallest);
    if (!known && has_finer) return std::nullopt;
    if (k > 0 && (!known || growth > most)) break;
    usable = {k + 1, growth};
  }
  return usable;
}

std::shared_ptr<const StartingWeightEquations> equations_kernel(const WeightTable& table,
                                                                const std::vector<double>& powers) {
  auto made = std::make_shared<const EquationsIn<MultipleDoubles<2>>>(table, powers);
  if (made->is_accurate()) return made;
  auto finer = std::make_shared<const EquationsIn<MultipleDoubles<3>>>(table, powers);
  if (finer->is_accurate()) return finer;
  return std::make_shared<const EquationsIn<MultipleDoubles<4>>>(table, powers);
}

UsablePowers usable_kernel(const WeightTable& table, const std::vector<double>& powers, double most) {
  if (const auto usable = usable_in<MultipleDoubles<2>>(table, powers, most, true)) return *usable;
  if (const auto usable = usable_in<MultipleDoubles<3>>(table, powers, most, true)) return *usable;
  return usable_in<MultipleDoubles<4>>(table, powers, most, false).value();
}

}  // namespace fde::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace fde {

HWY_EXPORT(equations_kernel);
HWY_EXPORT(usable_kernel);

std::shared_ptr<const StartingWeightEquations> starting_weight_equations(const WeightTable& table,
                                                                         const std::vector<double>& powers) {
  return HWY_DYNAMIC_DISPATCH(equations_kernel)(table, powers);
}

UsablePowers count_usable(const WeightTable& table, const std::vector<double>& powers, double most) {
  return HWY_DYNAMIC_DISPATCH(usable_kernel)(table, powers, most);
}

}  // namespace fde
#endif
