// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/scenes/two_sided/sum_of_powers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/special_functions/gamma.hpp>
#include <cmath>
#include <utility>

namespace fde::bench {

SumOfPowers::SumOfPowers(std::vector<Term> terms) {
  std::ranges::sort(terms, {}, &Term::power);
  for (const auto& term : terms) {
    if (!terms_.empty() && same_order(terms_.back().power, term.power)) {
      terms_.back().coefficient += term.coefficient;
    } else {
      terms_.push_back(term);
    }
  }
  std::erase_if(terms_, [](const Term& term) { return term.coefficient == 0.0; });
}

SumOfPowers SumOfPowers::polynomial(const std::vector<double>& coefficients) {
  std::vector<Term> terms;
  for (const double coefficient : coefficients)
    terms.push_back({coefficient, static_cast<double>(terms.size())});
  return SumOfPowers(std::move(terms));
}

double SumOfPowers::at(double t) const {
  double sum = 0.0;
  for (const auto& [coefficient, power] : terms_) sum += coefficient * std::pow(t, power);
  return sum;
}

double SumOfPowers::bound(double t) const {
  constexpr double units = 16 * 0x1p-53;
  double sum = 0.0;
  for (const auto& [coefficient, power] : terms_) sum += std::abs(coefficient) * std::pow(t, power);
  return units * sum;
}

std::vector<double> SumOfPowers::powers() const {
  std::vector<double> all;
  for (const auto& term : terms_) {
    if (term.power > 0.0) all.push_back(term.power);
  }
  return all;
}

SumOfPowers SumOfPowers::derivative(double order) const {
  std::vector<Term> terms;
  for (const auto& [coefficient, power] : terms_) {
    if (power < order && is_integer_order(power)) continue;
    // For order 1 the factor is exact, so that terms cancel exactly.
    const double factor = order == 1.0 ? power : boost::math::tgamma_ratio(power + 1.0, power + 1.0 - order);
    terms.push_back({coefficient * factor, power - order});
  }
  return SumOfPowers(std::move(terms));
}

SumOfPowers SumOfPowers::reversed(double end) const {
  const auto left = polynomial({end, -1.0});
  SumOfPowers sum, of_left = polynomial({1.0});
  double reached = 0.0;
  for (const auto& [coefficient, power] : terms_) {
    for (; reached < power; reached += 1.0) of_left = of_left * left;
    sum = sum + coefficient * of_left;
  }
  return sum;
}

SumOfPowers operator+(const SumOfPowers& a, const SumOfPowers& b) {
  auto terms = a.terms_;
  terms.insert(terms.end(), b.terms_.begin(), b.terms_.end());
  return SumOfPowers(std::move(terms));
}

SumOfPowers operator*(const SumOfPowers& a, const SumOfPowers& b) {
  std::vector<SumOfPowers::Term> terms;
  for (const auto& x : a.terms_) {
    for (const auto& y : b.terms_) terms.push_back({x.coefficient * y.coefficient, x.power + y.power});
  }
  return SumOfPowers(std::move(terms));
}

SumOfPowers operator*(double factor, const SumOfPowers& a) { return SumOfPowers::polynomial({factor}) * a; }

reference::Reference manufactured_reference(const std::vector<ManufacturedColumn>& columns, double end) {
  const auto at = [=](double t) -> reference::ReferenceValue {
    if (!(t >= 0.0 && t <= end)) reject("t", t, fmt::format("in [0, {}]", end));
    const auto size = std::ssize(columns);
    reference::ReferenceValue known{Vec(size), Vec(size)};
    for (Eigen::Index c = 0; c < size; ++c) {
      const auto& [sum, side] = columns[static_cast<std::size_t>(c)];
      const double time = side == Side::left ? t : end - t;
      known.value[c] = sum.at(time);
      known.bound[c] = sum.bound(time);
    }
    return known;
  };
  return {.at = at, .evidence = reference::Evidence::closed_form};
}

}  // namespace fde::bench
