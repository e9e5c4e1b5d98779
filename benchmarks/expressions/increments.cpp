// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/expressions/increments.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fde::bench {
namespace {

// An expression as a sum of a part that varies, or 0, and a constant.
struct Sum {
  Expression varying;
  long double constant;
};

class Rewriting {
 public:
  Rewriting(const Vec& origin, ExpressionPool& pool) : origin_(origin), pool_(pool), zero_(pool.number(0)) {}

  [[nodiscard]] bool has_cancelled() const { return has_cancelled_; }

  Expression whole(const Sum& sum) {
    if (sum.constant == 0.0L) return sum.varying;
    return pool_.make_expression(Operation::add, sum.varying,
                                 pool_.number(fmt::format("{}", static_cast<double>(sum.constant))));
  }

  // The sum of an operation on these sums; the node is that of expression e.
  Sum rewritten(Expression e, const ExpressionPool::Node& node, const std::array<Sum, 3>& of) {
    switch (node.operation) {
      case Operation::number:
        return {zero_, node.value};
      case Operation::variable:
        return {e, node.variable == 0 ? 0.0L : origin_[node.variable - 1]};
      case Operation::add:
      case Operation::subtract:
        return combined(node.operation, of[0], of[1]);
      case Operation::negate:
        return {pool_.make_expression(Operation::negate, of[0].varying), -of[0].constant};
      case Operation::multiply:
        if (of[0].varying == zero_ || of[1].varying == zero_) return scaled(of[0], of[1]);
        break;
      case Operation::divide:
        if (of[1].varying == zero_) {
          return {pool_.make_expression(Operation::divide, of[0].varying, whole(of[1])),
                  of[0].constant / of[1].constant};
        }
        break;
      default:
        break;
    }
    return {pool_.make_expression(node.operation, whole(of[0]), whole(of[1]), whole(of[2])), 0.0L};
  }

 private:
  // Constants cancel where they are equal to half a unit in the last place of double: an origin is rounded.
  Sum combined(Operation operation, const Sum& a, const Sum& b) {
    constexpr long double rounding = std::numeric_limits<double>::epsilon() / 2.0L;
    const Expression varying = pool_.make_expression(operation, a.varying, b.varying);
    const long double constant =
        operation == Operation::add ? a.constant + b.constant : a.constant - b.constant;
    const long double largest = std::max(std::abs(a.constant), std::abs(b.constant));
    const bool cancel = largest > 0.0L && std::abs(constant) <= rounding * largest;
    has_cancelled_ = has_cancelled_ || (cancel && varying != zero_);
    return {varying, cancel ? 0.0L : constant};
  }

  // A product in which one factor is constant.
  Sum scaled(const Sum& a, const Sum& b) {
    const Expression x = a.varying == zero_ ? whole(a) : a.varying,
                     y = b.varying == zero_ ? whole(b) : b.varying;
    const bool varies = a.varying != zero_ || b.varying != zero_;
    return {varies ? pool_.make_expression(Operation::multiply, x, y) : zero_, a.constant * b.constant};
  }

  const Vec& origin_;
  ExpressionPool& pool_;
  Expression zero_;
  bool has_cancelled_ = false;
};

}  // namespace

std::optional<std::vector<Expression>> in_increments(const std::vector<Expression>& of, const Vec& origin,
                                                     ExpressionPool& pool) {
  Rewriting rewriting(origin, pool);
  const auto sums =
      values_from_parts(pool, of, Sum{ExpressionPool::none, 0.0L},
                        [&](Expression e, const ExpressionPool::Node& node, const auto& parts) {
                          return rewriting.rewritten(e, node, std::array{parts(0), parts(1), parts(2)});
                        });
  if (!rewriting.has_cancelled()) return std::nullopt;
  std::vector<Expression> results;
  for (const auto& sum : sums) results.push_back(rewriting.whole(sum));
  return results;
}

}  // namespace fde::bench
