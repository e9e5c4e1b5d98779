#include "progress/work.hpp"

#include <utility>

namespace fde {
namespace {

WorkListener& listener_of_thread() {
  thread_local WorkListener listener;
  return listener;
}

}  // namespace

ListeningToWork::ListeningToWork(WorkListener listener)
    : before_(std::exchange(listener_of_thread(), std::move(listener))) {}

ListeningToWork::~ListeningToWork() { listener_of_thread() = std::move(before_); }

void report_work(std::size_t done, std::size_t total) {
  if (const auto& listener = listener_of_thread()) listener(done, total);
}

}  // namespace fde
