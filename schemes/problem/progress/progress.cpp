#include "fdebench/schemes/problem/progress/progress.hpp"

#include <utility>

namespace fde {
namespace {

thread_local ProgressScope* newest = nullptr;

}  // namespace

ProgressScope::ProgressScope(ProgressCallback listener)
    : listener_(std::move(listener)), outer_(std::exchange(newest, this)) {}

ProgressScope::~ProgressScope() { newest = outer_; }

void report_progress(std::size_t done, std::size_t total) {
  for (const auto* listening = newest; listening != nullptr; listening = listening->outer_)
    listening->listener_(done, total);
}

}  // namespace fde
