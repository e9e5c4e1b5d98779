#include "progress/work.hpp"

#include <utility>

namespace fde {
namespace {

thread_local ListeningToWork* newest = nullptr;

}  // namespace

ListeningToWork::ListeningToWork(WorkListener listener)
    : listener_(std::move(listener)), before_(std::exchange(newest, this)) {}

ListeningToWork::~ListeningToWork() { newest = before_; }

void report_work(std::size_t done, std::size_t total) {
  for (const auto* listening = newest; listening != nullptr; listening = listening->before_)
    listening->listener_(done, total);
}

}  // namespace fde
