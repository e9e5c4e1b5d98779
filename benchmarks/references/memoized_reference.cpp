// SPDX-License-Identifier: MIT
#include "fdebench/benchmarks/references/memoized_reference.hpp"

#include <numeric>
#include <stdexcept>
#include <utility>

#include "fdebench/benchmarks/references/reference_of.hpp"

namespace fde::bench {
namespace {

// The matrix with columns at(t).
template <class At>
Rows by_time(Eigen::Index rows, const std::vector<double>& times, const At& at) {
  Rows columns(rows, std::ssize(times));
  for (Eigen::Index c = 0; c < columns.cols(); ++c) columns.col(c) = at(times[static_cast<std::size_t>(c)]);
  return columns;
}

}  // namespace

std::vector<Eigen::Index> all_columns(const Scene& scene) {
  std::vector<Eigen::Index> all(scene.outputs.names.size());
  std::iota(all.begin(), all.end(), Eigen::Index{0});
  return all;
}

MemoizedReference::MemoizedReference(const Scene& scene) : MemoizedReference(scene, all_columns(scene)) {}

MemoizedReference::MemoizedReference(const Scene& scene, std::vector<Eigen::Index> columns)
    : scene_(scene), columns_(std::move(columns)) {}

Rows MemoizedReference::at(const std::vector<double>& times) {
  return by_time(std::ssize(columns_), times, [&](double t) -> const Vec& { return reference(t).value; });
}

Rows MemoizedReference::bounds(const std::vector<double>& times) {
  return by_time(std::ssize(columns_), times, [&](double t) -> const Vec& { return reference(t).bound; });
}

const reference::ReferenceValue& MemoizedReference::reference(double t) {
  const auto found = known_.find(t);
  return found == known_.end() ? known_.emplace(t, evaluated(t)).first->second : found->second;
}

const reference::Reference& MemoizedReference::exact() {
  if (failure_) std::rethrow_exception(failure_);
  try {
    if (!exact_.at) exact_ = reference_of(scene_);
    return exact_;
  } catch (const std::runtime_error&) {
    failure_ = std::current_exception();
    throw;
  }
}

reference::ReferenceValue MemoizedReference::evaluated(double t) {
  try {
    const auto [value, bound] = exact().at(t);
    return {value(columns_), bound(columns_)};
  } catch (const std::runtime_error&) {
    failure_ = std::current_exception();
    throw;
  }
}

}  // namespace fde::bench
