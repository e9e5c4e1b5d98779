// SPDX-License-Identifier: MIT
#pragma once

#include <map>

#include "fdebench/reference/special_functions/numbers/rational.hpp"

namespace fde::reference {

// The powers s^e for a set of exponents e. Exponentials dominate the cost of an evaluation, so a power that
// is the product of two others is computed as the product.
class PowerTable {
 public:
  PowerTable();

  // Index of s^exponent, which is added if it is new.
  std::size_t index(const Rational& exponent);

  // How a power is computed. Its relative error is at most fixed + growing * |log s| ulps.
  struct Entry {
    Rational exponent;
    enum class Method { one, identity, inverse, exponential, product } method;
    std::size_t left = 0, right = 0;  // of a product
    double fixed = 0.0, growing = 0.0;
  };
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }

  // All powers at one s, real or complex; `exponents` are the exponents of the entries, rounded.
  template <class Real, class Number>
  void evaluate(const std::vector<Real>& exponents, const Number& log_s, const Number& s,
                std::vector<Number>& powers) const {
    using std::exp;
    powers.clear();
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      switch (const Entry& entry = entries_[i]; entry.method) {
        case Entry::Method::one:
          powers.emplace_back(1);
          break;
        case Entry::Method::identity:
          powers.push_back(s);
          break;
        case Entry::Method::inverse:
          powers.push_back(Real(1) / s);
          break;
        case Entry::Method::exponential:
          powers.push_back(exp(Number(exponents[i] * log_s)));
          break;
        case Entry::Method::product:
          powers.push_back(powers[entry.left] * powers[entry.right]);
          break;
      }
    }
  }

 private:
  [[nodiscard]] Entry cheapest_entry(const Rational& exponent) const;

  std::vector<Entry> entries_;
  std::map<Rational, std::size_t> places_;
};

}  // namespace fde::reference
