// SPDX-License-Identifier: MIT
#include "fdebench/schemes/rules/two_sided/condensed_system.hpp"

#include <algorithm>
#include <cmath>

#include "fdebench/schemes/solvers/gmres.hpp"

namespace fde {

CondensedSystem::CondensedSystem(const Linearisation& linearisation)
    : linearisation_(linearisation),
      equations_(linearisation.equations()),
      right_value_count_(equations_.left().empty()
                             ? 0
                             : static_cast<Eigen::Index>(equations_.right().rows().size()) *
                                   (equations_.grid().steps + 1)),
      scale_(std::sqrt(equations_.grid().steps + 1.0)) {}

GridFunction CondensedSystem::solution(const Residual& residual) const {
  Rows y = Rows::Zero(residual.rows.rows(), residual.rows.cols());
  Vec unknown = Vec::Zero(equations_.unknown_count());
  linearisation_.forward_backward_sweep(residual.rows, y);
  const Vec b = unknowns(y, -residual.conditions - linearisation_.conditions(y));
  if (b.size() > 0) {
    const Vec z =
        gmres([this](const Vec& x) { return applied(x); }, b, linear_tolerance, max_krylov_vectors(b.size()));
    unknown = z.tail(unknown.size()) / scale_;
    Rows given = residual.rows;
    equations_.add_unknown(unknown, given);
    y = right_part(z);
    linearisation_.forward_backward_sweep(given, y);
  }
  return {.y = std::move(y), .unknown = std::move(unknown)};
}

Vec CondensedSystem::applied(const Vec& z) const {
  Rows y = right_part(z), given = Rows::Zero(y.rows(), y.cols());
  equations_.add_unknown(z.tail(equations_.unknown_count()) / scale_, given);
  linearisation_.forward_backward_sweep(given, y);
  Vec result = unknowns(y, linearisation_.conditions(y));
  result.head(right_value_count_) = z.head(right_value_count_) - result.head(right_value_count_);
  return result;
}

Vec CondensedSystem::unknowns(const Rows& y, In conditions) const {
  Vec z(right_value_count_ + conditions.size());
  if (right_value_count_ > 0)
    z.head(right_value_count_) = y(equations_.right().rows(), Eigen::all).reshaped();
  z.tail(conditions.size()) = scale_ * conditions;
  return z;
}

Rows CondensedSystem::right_part(const Vec& z) const {
  Rows y = Rows::Zero(equations_.problem().size(), equations_.grid().steps + 1);
  if (right_value_count_ > 0) {
    const auto& rows = equations_.right().rows();
    y(rows, Eigen::all) =
        z.head(right_value_count_).reshaped(static_cast<Eigen::Index>(rows.size()), y.cols());
  }
  return y;
}

std::size_t CondensedSystem::bytes() const {
  const auto length = right_value_count_ + equations_.unknown_count();
  return length > 0 ? sizeof(double) * static_cast<std::size_t>(length * max_krylov_vectors(length)) : 0;
}

}  // namespace fde
