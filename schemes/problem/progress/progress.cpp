// SPDX-License-Identifier: MIT
#include "fdebench/schemes/problem/progress/progress.hpp"

#include <utility>

namespace fde {
namespace {

thread_local ProgressScope* newest = nullptr;

}  // namespace

ProgressScope::ProgressScope(ProgressCallback callback)
    : callback_(std::move(callback)), outer_(std::exchange(newest, this)) {}

ProgressScope::~ProgressScope() { newest = outer_; }

void report_progress(std::size_t done, std::size_t total) {
  for (const auto* scope = newest; scope != nullptr; scope = scope->outer_) scope->callback_(done, total);
}

}  // namespace fde
