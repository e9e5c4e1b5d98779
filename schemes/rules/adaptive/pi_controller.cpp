// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/adaptive/pi_controller.hpp"

#include <algorithm>
#include <cmath>

namespace fde {
namespace {

constexpr double integral = 0.7, proportional = 0.4;  // exponents times the rate
constexpr double aim = 0.8;                           // of the length that would make the error 1
constexpr double least = 0.1, most = 4.0;             // of the previous length
constexpr double unsolved = 0.25;
constexpr double worthwhile = 1.2;  // a smaller increase keeps the length, so that factors can be reused
constexpr double smallest_error = 1e-6;

}  // namespace

bool PiController::update(double error, double length) {
  if (!(error <= 1.0)) {
    const double factor =
        std::isfinite(error) ? std::max(aim * std::pow(error, -1.0 / rate_), least) : unsolved;
    length_ = factor * length;
    rejected_ = true;
    return false;
  }
  const double now = std::max(error, smallest_error);
  const double factor = aim * std::pow(now, -integral / rate_) * std::pow(last_error_, proportional / rate_);
  const double longest = rejected_ ? 1.0 : most;
  const double bounded = std::clamp(factor, least, longest);
  length_ = bounded >= 1.0 && bounded < worthwhile ? length : bounded * length;
  last_error_ = now;
  rejected_ = false;
  return true;
}

}  // namespace fde
