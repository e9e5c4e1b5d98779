#include "two_sided/linearisation.hpp"

#include <algorithm>
#include <cmath>

#include "implicit/differences.hpp"
#include "two_sided/gmres.hpp"

namespace fde {
namespace {

constexpr double linear_tolerance = 1e-10;

// Vectors that GMRES may keep: as many as hold a quarter of a gigabyte, within bounds.
Eigen::Index most_applications(Eigen::Index length) {
  constexpr Eigen::Index most_values = 1 << 25;
  return std::clamp<Eigen::Index>(most_values / length, 20, 200);
}

}  // namespace

void Linearisation::update(Run& run, const Guess& guess, const Residual& residual) {
  const auto& problem = equations_.problem();
  const auto size = problem.size();
  if (residual.conditions.size() > 0) differentiate_conditions(guess, residual.conditions);
  if (linear(problem) && jacobians_.size() > 0) return;
  jacobians_.resize(size * size, linear(problem) ? 1 : guess.y.cols());
  const Vec sizes = guess.y.cwiseAbs().rowwise().maxCoeff();
  for (Eigen::Index n = 0; n < jacobians_.cols(); ++n) {
    const double t = equations_.grid().time(static_cast<int>(n));
    Eigen::Map<Matrix> jacobian(jacobians_.col(n).data(), size, size);
    if (evaluate_jacobian(problem, t, guess.y.col(n), jacobian)) continue;
    difference_rhs(run, problem, t, guess.y.col(n), residual.f.col(n), sizes, jacobian);
  }
  left_inverses_ = equations_.left().inverses(jacobians_);
  right_inverses_ = equations_.right().inverses(jacobians_);
}

void Linearisation::differentiate_conditions(const Guess& guess, const Vec& conditions) {
  const Vec start = guess.y.col(0), end = guess.y.rightCols<1>();
  const Vec sizes = guess.y.cwiseAbs().rowwise().maxCoeff();
  const auto& problem = equations_.problem();
  Vec result(conditions.size());
  by_start_.resize(conditions.size(), problem.size());
  by_end_.resize(conditions.size(), problem.size());
  const auto from_start = [&](const Vec& y) -> const Vec& {
    problem.conditions(y, end, result);
    return result;
  };
  const auto from_end = [&](const Vec& y) -> const Vec& {
    problem.conditions(start, y, result);
    return result;
  };
  const auto everywhere = [](const Vec&) { return true; };
  differences(from_start, everywhere, start, conditions, sizes, by_start_);
  differences(from_end, everywhere, end, conditions, sizes, by_end_);
}

Guess Linearisation::increment(const Residual& residual) const {
  Rows y = Rows::Zero(residual.rows.rows(), residual.rows.cols());
  Vec unknown = Vec::Zero(equations_.unknown());
  forward_backward_sweep(residual.rows, y);
  const Vec b = unknowns(y, -residual.conditions - conditions(y));
  if (b.size() > 0) {
    const Vec z =
        gmres([this](const Vec& x) { return applied(x); }, b, linear_tolerance, most_applications(b.size()));
    unknown = z.tail(unknown.size()) / scale();
    Rows given = residual.rows;
    equations_.add_unknown(unknown, given);
    y = right_part(z);
    forward_backward_sweep(given, y);
  }
  return {.y = std::move(y), .unknown = std::move(unknown)};
}

Vec Linearisation::applied(const Vec& z) const {
  Rows y = right_part(z), given = Rows::Zero(y.rows(), y.cols());
  equations_.add_unknown(z.tail(equations_.unknown()) / scale(), given);
  forward_backward_sweep(given, y);
  Vec result = unknowns(y, conditions(y));
  result.head(open_values()) = z.head(open_values()) - result.head(open_values());
  return result;
}

void Linearisation::forward_backward_sweep(const Rows& given, Rows& y) const {
  equations_.left().solve(given, jacobians_, left_inverses_, y);
  equations_.right().solve(given, jacobians_, right_inverses_, y);
}

Vec Linearisation::conditions(const Rows& y) const {
  if (equations_.unknown() == 0) return {};
  return by_start_ * y.col(0) + by_end_ * y.rightCols<1>();
}

// A number that is the same at all times weighs as much as a row of them.
double Linearisation::scale() const { return std::sqrt(equations_.grid().steps + 1.0); }

Eigen::Index Linearisation::open_values() const {
  if (equations_.left().empty()) return 0;
  return static_cast<Eigen::Index>(equations_.right().rows().size()) * (equations_.grid().steps + 1);
}

Vec Linearisation::unknowns(const Rows& y, In conditions) const {
  Vec z(open_values() + conditions.size());
  if (open_values() > 0) z.head(open_values()) = y(equations_.right().rows(), Eigen::all).reshaped();
  z.tail(conditions.size()) = scale() * conditions;
  return z;
}

Rows Linearisation::right_part(const Vec& z) const {
  Rows y = Rows::Zero(equations_.problem().size(), equations_.grid().steps + 1);
  if (open_values() > 0) {
    const auto& rows = equations_.right().rows();
    y(rows, Eigen::all) = z.head(open_values()).reshaped(static_cast<Eigen::Index>(rows.size()), y.cols());
  }
  return y;
}

std::size_t Linearisation::bytes() const {
  const auto length = open_values() + equations_.unknown();
  const auto vectors = length > 0 ? length * std::min(most_applications(length), length) : 0;
  return sizeof(double) * static_cast<std::size_t>(jacobians_.size() + left_inverses_.size() +
                                                   right_inverses_.size() + vectors);
}

}  // namespace fde
