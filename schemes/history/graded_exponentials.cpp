#include "history/graded_exponentials.hpp"

#include <algorithm>
#include <cmath>

#include "history/block_kernels.hpp"
#include "weights/interval_weights.hpp"
#include "weights/weight_transform.hpp"

namespace fde {
namespace {

// phi_k(x) = sum_i (-x)^i / (i + k)!, k = 1, 2, 3: the integrals of exp(-x (1 - w)) w^(k-1) / (k-1)! over w
// in [0, 1]. They follow from each other by phi_k = 1/k! - x phi_(k+1), upwards without loss for small x,
// downwards for large. x increases.
void phi_functions(const Vec& x, Matrix& phi, Vec& decay_minus_one) {
  constexpr int last = 18;  // 1/22! is rounding
  const Eigen::Index few = std::lower_bound(x.begin(), x.end(), 1.0) - x.begin(), many = x.size() - few;
  const auto small = x.head(few).array(), large = x.tail(many).array();
  auto low = phi.topRows(few).array(), high = phi.middleRows(few, many).array();
  low.col(2).setOnes();
  for (int i = last; i >= 0; --i) low.col(2) = 1.0 - small * low.col(2) * (1.0 / (i + 4));
  low.col(2) *= 1.0 / 6.0;
  low.col(1) = 0.5 - small * low.col(2);
  low.col(0) = 1.0 - small * low.col(1);
  decay_minus_one.head(few) = -small * low.col(0);

  decay_minus_one.segment(few, many) = (-large).exp() - 1.0;
  high.col(0) = -decay_minus_one.segment(few, many).array() / large;
  high.col(1) = (1.0 - high.col(0)) / large;
  high.col(2) = (0.5 - high.col(1)) / large;
}

}  // namespace

GradedExponentialHistory::GradedExponentialHistory(const WeightTables& tables, const Grid& grid,
                                                   double tolerance)
    : grid_(grid) {
  for (const auto& of_sum : tables) {
    auto& tracks = tracks_.emplace_back();
    for (std::size_t i = 0; i < of_sum.size(); ++i) {
      if (integral_order(of_sum[i]) == 0.0) continue;  // L1 of order 1 has no past
      const auto kernel = kernel_of(of_sum[i], tolerance);
      auto& states = kernels_[kernel].states;
      tracks.push_back({static_cast<Eigen::Index>(i), of_sum[i], kernel, states.cols()});
      states.conservativeResize(Eigen::NoChange, states.cols() + 1);
    }
  }
  for (auto& kernel : kernels_) {
    kernel.states.setZero();
    kernel.carries = kernel.input = kernel.states;
    kernel.polynomials.setZero(3, kernel.states.cols());
  }
}

std::size_t GradedExponentialHistory::kernel_of(const WeightTable& table, double tolerance) {
  const long double exponent = kernel_exponent(table);
  const auto found = std::ranges::find(kernels_, exponent, &Kernel::exponent);
  const auto index = static_cast<std::size_t>(found - kernels_.begin());
  if (found != kernels_.end()) return index;
  const auto sum = exponential_sum(exponent, grid_.step(1), 2.0 * grid_.end, tolerance);
  const double last = sum.nodes[sum.nodes.size() - 1];
  Kernel kernel{.exponent = exponent,
                .fastest = last * grid_.step(1),
                .nodes = padded(sum.nodes, last),
                .coefficients = padded(sum.coefficients, 0.0)};
  kernel.active = kernel.nodes.size();
  kernel.decay_minus_one.resize(kernel.active);
  kernel.weights.resize(kernel.active);
  kernel.phi.resize(kernel.active, 3);
  kernel.states.resize(kernel.active, 0);
  kernels_.push_back(std::move(kernel));
  return index;
}

void GradedExponentialHistory::push(In sample) {
  if (pushed_ > 0) advance(grid_.step(pushed_), sample);
  newest_ = sample;
  ++pushed_;
  prepare(grid_.step(pushed_));
}

GradedExponentialHistory::Polynomial GradedExponentialHistory::integrand(const Track& track, double before,
                                                                         double after, double length) {
  const auto [begin, end] = ends(track.table.family, before, after, length);
  if (!weighs_running_sums(track.table)) return {begin, end - begin, 0.0};
  return {track.integral[0], length * begin, length * (end - begin)};
}

// Over the interval from the newest sample to this one, whose phi functions are prepared.
void GradedExponentialHistory::advance(double length, In sample) {
  for (auto& tracks : tracks_) {
    for (auto& track : tracks) {
      const double before = newest_[track.component], after = sample[track.component];
      kernels_[track.kernel].polynomials.col(track.column) = length * integrand(track, before, after, length);
      if (!weighs_running_sums(track.table)) continue;
      const auto [begin, end] = ends(track.table.family, before, after, length);
      track.integral.add(0, length * (begin + end) / 2.0);
    }
  }
  for (auto& kernel : kernels_) {
    kernel.input.topRows(kernel.active).setZero();
    multiply_add(kernel.active, kernel.phi.cols(), kernel.states.cols(), kernel.phi, kernel.polynomials,
                 kernel.input);
    fde::advance(kernel.active, kernel.states.cols(), kernel.decay_minus_one.data(), kernel.input,
                 kernel.states, kernel.carries);
  }
}

void GradedExponentialHistory::prepare(double length) {
  for (auto& kernel : kernels_) {
    // exponential_sum may leave out the nodes from the one after its last on: one more than up to `fastest`.
    const auto end = kernel.nodes.begin() + kernel.active;
    const auto slower =
        std::upper_bound(kernel.nodes.begin(), end, kernel.fastest / length) - kernel.nodes.begin();
    kernel.active = std::min((slower + 1 + lanes - 1) / lanes * lanes, kernel.active);
    const Vec x = length * kernel.nodes.head(kernel.active);
    phi_functions(x, kernel.phi, kernel.decay_minus_one);
    kernel.weights.head(kernel.active) = kernel.coefficients.head(kernel.active).array() *
                                         (1.0 + kernel.decay_minus_one.head(kernel.active).array());
    const auto a = static_cast<double>(kernel.exponent);
    double near = std::pow(length, a) / std::tgamma(a + 1.0);
    for (int k = 0; k < 3; ++k) {
      kernel.near[static_cast<std::size_t>(k)] = near;
      near /= a + k + 1.0;
    }
  }
  const Track* last = nullptr;  // neighbours often have the same table
  for (auto& tracks : tracks_) {
    for (auto& track : tracks) {
      track.to_sums = last != nullptr && last->table == track.table ? last->to_sums
                                                                    : integrals_to_sums(track.table, length);
      last = &track;
    }
  }
}

void GradedExponentialHistory::convolve(std::size_t sum, Out result) const {
  const double length = grid_.step(pushed_);
  result.setZero();
  for (const auto& track : tracks_[sum]) {
    const auto& kernel = kernels_[track.kernel];
    const double far =
        dot_product(kernel.weights.data(), kernel.states.col(track.column).data(), kernel.active);
    const Polynomial newest = integrand(track, newest_[track.component], 0.0, length);
    const double near = newest[0] * kernel.near[0] + newest[1] * kernel.near[1] + newest[2] * kernel.near[2];
    result[track.component] = (far + near) * track.to_sums;
  }
}

std::size_t GradedExponentialHistory::bytes() const {
  Eigen::Index doubles = newest_.size();
  for (const auto& kernel : kernels_) {
    doubles +=
        4 * kernel.nodes.size() + kernel.phi.size() + 3 * kernel.states.size() + kernel.polynomials.size();
  }
  return sizeof(double) * static_cast<std::size_t>(doubles);
}

}  // namespace fde
