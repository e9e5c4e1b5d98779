// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <compare>
#include <concepts>

namespace fde::bench::mechanics {

// A number with its derivatives in `count` directions: forward automatic differentiation. With a Dual as
// Scalar it has second derivatives. A plain type: nested expressions of Eigen's AutoDiffScalar take several
// times as long to compile.
template <class Scalar, int count>
class Dual {
  template <class Other>
  static constexpr bool constant = std::same_as<Other, Scalar> || std::same_as<Other, double>;

 public:
  using Value = Scalar;
  static constexpr int directions = count;

  Dual() = default;
  // A constant: all derivatives are 0.
  Dual(double value) : value_(value) { derivatives_.fill(Scalar(0.0)); }
  Dual(const Scalar& value) requires(!std::same_as<Scalar, double>) : value_(value) {
    derivatives_.fill(Scalar(0.0));
  }

  [[nodiscard]] const Scalar& value() const { return value_; }
  [[nodiscard]] const Scalar& derivative(int direction) const { return derivatives_[at(direction)]; }
  void set_derivative(int direction, const Scalar& value) { derivatives_[at(direction)] = value; }

  // f(x) by the chain rule, for a function with value f and derivative `slope` at x.
  [[nodiscard]] Dual chain_rule(const Scalar& value, const Scalar& slope) const {
    Dual result;
    result.value_ = value;
    for (std::size_t i = 0; i < count; ++i) result.derivatives_[i] = derivatives_[i] * slope;
    return result;
  }

  friend Dual operator-(const Dual& x) {
    Dual result;
    result.value_ = -x.value_;
    for (std::size_t i = 0; i < count; ++i) result.derivatives_[i] = -x.derivatives_[i];
    return result;
  }
  friend Dual operator+(const Dual& x, const Dual& y) {
    Dual result;
    result.value_ = x.value_ + y.value_;
    for (std::size_t i = 0; i < count; ++i) result.derivatives_[i] = x.derivatives_[i] + y.derivatives_[i];
    return result;
  }
  friend Dual operator-(const Dual& x, const Dual& y) {
    Dual result;
    result.value_ = x.value_ - y.value_;
    for (std::size_t i = 0; i < count; ++i) result.derivatives_[i] = x.derivatives_[i] - y.derivatives_[i];
    return result;
  }
  friend Dual operator*(const Dual& x, const Dual& y) {
    Dual result;
    result.value_ = x.value_ * y.value_;
    for (std::size_t i = 0; i < count; ++i)
      result.derivatives_[i] = x.derivatives_[i] * y.value_ + y.derivatives_[i] * x.value_;
    return result;
  }
  friend Dual operator/(const Dual& x, const Dual& y) {
    const Scalar scale = 1.0 / (y.value_ * y.value_);
    Dual result;
    result.value_ = x.value_ / y.value_;
    for (std::size_t i = 0; i < count; ++i)
      result.derivatives_[i] = (x.derivatives_[i] * y.value_ - y.derivatives_[i] * x.value_) * scale;
    return result;
  }

  template <class Other>
  requires constant<Other>
  friend Dual operator+(const Dual& x, const Other& c) {
    Dual result;
    result.value_ = x.value_ + c;
    for (std::size_t i = 0; i < count; ++i) result.derivatives_[i] = x.derivatives_[i];
    return result;
  }
  template <class Other>
  requires constant<Other>
  friend Dual operator+(const Other& c, const Dual& x) { return x + c; }
  template <class Other>
  requires constant<Other>
  friend Dual operator-(const Dual& x, const Other& c) {
    Dual result;
    result.value_ = x.value_ - c;
    for (std::size_t i = 0; i < count; ++i) result.derivatives_[i] = x.derivatives_[i];
    return result;
  }
  template <class Other>
  requires constant<Other>
  friend Dual operator-(const Other& c, const Dual& x) {
    Dual result;
    result.value_ = c - x.value_;
    for (std::size_t i = 0; i < count; ++i) result.derivatives_[i] = -x.derivatives_[i];
    return result;
  }
  template <class Other>
  requires constant<Other>
  friend Dual operator*(const Dual& x, const Other& c) {
    Dual result;
    result.value_ = x.value_ * c;
    for (std::size_t i = 0; i < count; ++i) result.derivatives_[i] = x.derivatives_[i] * c;
    return result;
  }
  template <class Other>
  requires constant<Other>
  friend Dual operator*(const Other& c, const Dual& x) { return x * c; }
  template <class Other>
  requires constant<Other>
  friend Dual operator/(const Other& c, const Dual& x) {
    return x.chain_rule(c / x.value_, -c / (x.value_ * x.value_));
  }

  template <class Other>
  Dual& operator+=(const Other& y) {
    return *this = *this + y;
  }
  template <class Other>
  Dual& operator-=(const Other& y) {
    return *this = *this - y;
  }
  template <class Other>
  Dual& operator*=(const Other& y) {
    return *this = *this * y;
  }
  template <class Other>
  Dual& operator/=(const Other& y) {
    return *this = *this / y;
  }

  // Compares the values only.
  friend std::partial_ordering operator<=>(const Dual& x, double bound) { return x.value_ <=> bound; }

  friend Dual sin(const Dual& x) {
    using std::cos, std::sin;
    return x.chain_rule(sin(x.value_), cos(x.value_));
  }
  friend Dual cos(const Dual& x) {
    using std::cos, std::sin;
    return x.chain_rule(cos(x.value_), -sin(x.value_));
  }

 private:
  static std::size_t at(int direction) { return static_cast<std::size_t>(direction); }

  Scalar value_;
  std::array<Scalar, directions> derivatives_;
};

}  // namespace fde::bench::mechanics
