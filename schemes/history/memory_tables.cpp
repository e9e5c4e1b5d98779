#include "history/memory_tables.hpp"

#include <cmath>

namespace fde {
namespace {

// w(1), w(2), ..., or their differences.
Vec exact_weights(const WeightTable& table, Eigen::Index count) {
  return Vec::NullaryExpr(count, [&](Eigen::Index k) {
    return weighs_running_sums(table) ? weight_increment(table, k + 1) : weight(table, k + 1);
  });
}

}  // namespace

MemoryTables::MemoryTables(const std::vector<WeightTable>& tables, const ExponentialSum& sum)
    : count(std::ssize(tables)), exponentials(sum.nodes.size()), nodes(padded(sum.nodes, 0.0)) {
  decay_minus_one = (-double{block} * nodes).array().expm1();
  gather.setZero(nodes.size(), block);
  for (Eigen::Index k = 0; k < block; ++k)
    gather.col(k).head(exponentials) = (-double(block - 1 - k) * sum.nodes).array().exp();
  inner.setZero(count * recent, recent);
  near.resize(count * block, recent);
  far.resize(count * block, nodes.size());
  for (Eigen::Index row = 0; row < far.rows(); ++row)
    far.row(row) = (-double(recent + 1 + row % block) * nodes).array().exp();
  for (Eigen::Index table = 0; table < count; ++table)
    fill(tables[static_cast<std::size_t>(table)], table, sum);
}

void MemoryTables::fill(const WeightTable& weights, Eigen::Index table, const ExponentialSum& sum) {
  const Vec exact = exact_weights(weights, block + recent - 1);
  for (Eigen::Index k = 0; k < recent; ++k) {
    const auto shorter = recent - 1 - k;
    inner.block((table + 1) * recent - shorter, k, shorter, 1) = exact.head(shorter);
    near.block(table * block, k, block, 1) = exact.segment(shorter, block);
  }
  far.middleRows(table * block, block) *= padded(weight_coefficients(weights, sum), 0.0).asDiagonal();
}

}  // namespace fde
