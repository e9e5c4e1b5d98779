// SPDX-License-Identifier: MIT
#include "fdebench/schemes/problem/initial_guess.hpp"

#include <cmath>
#include <numbers>
#include <random>
#include <utility>

namespace fde {

InitialGuess::InitialGuess(const Problem& problem, Matrix amplitudes)
    : end_(problem.end), taylor_(problem), amplitudes_(std::move(amplitudes)) {
  for (const auto& component : problem.components) sides_.push_back(component.side);
}

Vec InitialGuess::at(double t) const {
  Vec left(amplitudes_.rows()), right(amplitudes_.rows());
  taylor_.at(t, left);
  taylor_.at(end_ - t, right);
  for (std::size_t i = 0; i < sides_.size(); ++i)
    if (sides_[i] == Side::right) left[static_cast<Eigen::Index>(i)] = right[static_cast<Eigen::Index>(i)];
  for (Eigen::Index j = 0; j < amplitudes_.cols(); ++j)
    left += std::cos(static_cast<double>(j) * std::numbers::pi * t / end_) * amplitudes_.col(j);
  return left;
}

std::vector<InitialGuess> initial_guesses(const Problem& problem, int count) {
  constexpr Eigen::Index frequencies = 4;
  constexpr int sizes = 6;
  std::mt19937_64 bits;  // NOLINT(bugprone-random-generator-seed,cert-msc51-cpp): the same starts each time
  std::vector<InitialGuess> starts;
  for (int k = 0; k < count; ++k) {
    const double size = std::ldexp(1.0, k % sizes - 2);
    Matrix amplitudes(problem.size(), frequencies);
    for (auto& amplitude : amplitudes.reshaped())
      amplitude = size * (std::ldexp(static_cast<double>(bits()), -63) - 1.0);
    starts.emplace_back(problem, std::move(amplitudes));
  }
  return starts;
}

}  // namespace fde
