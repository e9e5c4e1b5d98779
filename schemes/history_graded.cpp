#include "history_graded.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "interval_weights.hpp"
#include "weight_transform.hpp"

namespace fde {
namespace {

// L1 of order 1 has no past.
bool has_past(const WeightTable& table) { return integral_order(table) > 0.0; }

}  // namespace

GradedDirectHistory::GradedDirectHistory(WeightTables tables, const Grid& grid)
    : tables_(std::move(tables)),
      grid_(grid),
      samples_(grid.steps + 1, static_cast<Eigen::Index>(tables_.front().size())) {}

void GradedDirectHistory::push(In sample) { samples_.row(pushed_++) = sample; }

void GradedDirectHistory::convolve(std::size_t sum, Out result) const {
  for (Eigen::Index i = 0; i < result.size(); ++i) {
    result[i] = convolved(tables_[sum][static_cast<std::size_t>(i)], i);
  }
}

double GradedDirectHistory::convolved(const WeightTable& table, Eigen::Index component) const {
  if (!has_past(table)) return 0.0;
  const auto n = static_cast<int>(pushed_);
  const double now = grid_.time(n), order = integral_order(table);
  double integral = 0.0;
  for (int j = 1; j <= n; ++j) {
    const double length = grid_.step(j), after = j < n ? samples_(j, component) : 0.0;
    const auto [left, right] = interval_weights(order, now - grid_.time(j), length);
    const auto [begin, end] = ends(table.family, samples_(j - 1, component), after, length);
    integral += left * begin + right * end;
  }
  return integral * integrals_to_sums(table, grid_.step(n));
}

std::size_t GradedDirectHistory::bytes() const {
  return sizeof(double) * static_cast<std::size_t>(samples_.size());
}

namespace {

// exp(-x) - 1 and phi_k = sum_i (-x)^i / (i + k)!, k = 1, 2, 3: the integrals of exp(-x (1 - w)) w^(k-1) /
// (k-1)! over w in [0, 1]. They follow from each other by phi_k = 1/k! - x phi_(k+1), upwards without loss
// for small x, downwards for large.
Eigen::RowVector4d phi_functions(double x) {
  double one = 0.0, two = 0.0, three = 0.0;
  if (x < 1.0) {
    constexpr int last = 18;
    for (int i = last; i >= 0; --i) three = 1.0 - x * three / (i + 4);
    three /= 6.0;
    two = 0.5 - x * three;
    one = 1.0 - x * two;
  } else {
    one = -std::expm1(-x) / x;
    two = (1.0 - one) / x;
    three = (0.5 - two) / x;
  }
  return {-x * one, one, two, three};
}

}  // namespace

GradedExponentialHistory::GradedExponentialHistory(const WeightTables& tables, const Grid& grid,
                                                   double tolerance)
    : grid_(grid), newest_(static_cast<Eigen::Index>(tables.front().size())) {
  for (const auto& of_sum : tables) {
    auto& tracks = tracks_.emplace_back();
    for (const auto& table : of_sum) {
      if (!has_past(table)) {
        tracks.push_back({table, 0});
        continue;
      }
      const long double exponent = kernel_exponent(table);
      auto kernel = std::ranges::find(kernels_, exponent, &Kernel::exponent);
      if (kernel == kernels_.end()) {
        kernel = kernels_.insert(
            kernel, {exponent, exponential_sum(exponent, grid.step(1), 2.0 * grid.end, tolerance)});
      }
      const Vec zero = Vec::Zero(kernel->sum.nodes.size());
      tracks.push_back({table, static_cast<std::size_t>(kernel - kernels_.begin()), zero, zero});
    }
  }
}

void GradedExponentialHistory::push(In sample) {
  if (pushed_ > 0) {
    const double length = grid_.step(static_cast<int>(pushed_));
    for (auto& tracks : tracks_) {
      for (Eigen::Index i = 0; i < sample.size(); ++i) {
        auto& track = tracks[static_cast<std::size_t>(i)];
        if (has_past(track.table)) advance(track, newest_[i], sample[i], length);
      }
    }
  }
  newest_ = sample;
  ++pushed_;
  prepare(grid_.step(static_cast<int>(pushed_)));
}

void GradedExponentialHistory::prepare(double length) {
  for (auto& kernel : kernels_) {
    const auto& nodes = kernel.sum.nodes;
    // exponential_sum may leave out the nodes from the one after its last on: one more than up to `fastest`.
    const double fastest = nodes[nodes.size() - 1] * grid_.step(1) / length;
    const auto slower = std::upper_bound(nodes.begin(), nodes.end(), fastest) - nodes.begin();
    kernel.active = std::min<Eigen::Index>(slower + 1, nodes.size());
    kernel.step.resize(nodes.size(), 4);
    for (Eigen::Index m = 0; m < kernel.active; ++m) kernel.step.row(m) = phi_functions(nodes[m] * length);
  }
}

GradedExponentialHistory::Polynomial GradedExponentialHistory::integrand(const Track& track, double before,
                                                                         double after, double length) {
  const auto [begin, end] = ends(track.table.family, before, after, length);
  if (!weighs_running_sums(track.table)) return {begin, end - begin, 0.0};
  return {track.integral[0], length * begin, length * (end - begin)};
}

void GradedExponentialHistory::advance(Track& track, double before, double after, double length) const {
  const auto& kernel = kernels_[track.kernel];
  const Polynomial polynomial = length * integrand(track, before, after, length);
  for (Eigen::Index m = 0; m < kernel.active; ++m) {
    const double change =
        track.states[m] * kernel.step(m, 0) + kernel.step.row(m).tail<3>().dot(polynomial) + track.carries[m];
    const double old = track.states[m];
    track.states[m] = old + change;
    track.carries[m] = change - (track.states[m] - old);
  }
  if (weighs_running_sums(track.table)) {
    const auto [begin, end] = ends(track.table.family, before, after, length);
    track.integral.add(0, length * (begin + end) / 2.0);
  }
}

void GradedExponentialHistory::convolve(std::size_t sum, Out result) const {
  const double length = grid_.step(static_cast<int>(pushed_));
  for (Eigen::Index i = 0; i < result.size(); ++i) {
    const auto& track = tracks_[sum][static_cast<std::size_t>(i)];
    result[i] = 0.0;
    if (!has_past(track.table)) continue;
    const auto& [exponent, exponentials, active, step] = kernels_[track.kernel];
    const auto decayed = track.states.head(active).array() * (1.0 + step.col(0).head(active).array());
    const double far = (exponentials.coefficients.head(active).array() * decayed).sum();
    const auto power = static_cast<double>(exponent);
    const Polynomial newest = integrand(track, newest_[i], 0.0, length);
    double near = 0.0;
    for (int k = 2; k >= 0; --k) near += newest[k] / std::tgamma(power + k + 1.0);
    result[i] = (far + near * std::pow(length, power)) * integrals_to_sums(track.table, length);
  }
}

std::size_t GradedExponentialHistory::bytes() const {
  Eigen::Index doubles = newest_.size();
  for (const auto& kernel : kernels_) doubles += 6 * kernel.sum.nodes.size();
  for (const auto& tracks : tracks_) {
    for (const auto& track : tracks) doubles += 2 * track.states.size();
  }
  return sizeof(double) * static_cast<std::size_t>(doubles);
}

}  // namespace fde
