// SPDX-License-Identifier: MIT
#include "fdebench/reports/command/signal_cleanup.hpp"

#include <unistd.h>

#include <atomic>
#include <utility>

#include "fdebench/benchmarks/external/process_cleanup.hpp"

namespace fde::bench {
namespace {

std::atomic<const std::string*> last_words = nullptr;
static_assert(std::atomic<const std::string*>::is_always_lock_free);

// Async-signal-safe. SA_RESETHAND has restored the default action; the signal raised here is delivered after
// the handler has returned.
void say_and_end(int signal) {
  clean_up();
  if (const auto* text = last_words.load()) {
    [[maybe_unused]] const auto written = write(STDERR_FILENO, text->data(), text->size());
  }
  [[maybe_unused]] const int raised = raise(signal);
}

}  // namespace

SignalCleanup::SignalCleanup(std::string text) : text_(std::move(text)) {
  last_words = &text_;
  struct sigaction action {};
  action.sa_handler = say_and_end;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigemptyset(&action.sa_mask);
  for (std::size_t i = 0; i < signals.size(); ++i) {
    sigaction(signals[i], nullptr, &before_[i]);
    if (before_[i].sa_handler == SIG_DFL) sigaction(signals[i], &action, nullptr);
  }
}

SignalCleanup::~SignalCleanup() {
  for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &before_[i], nullptr);
  last_words = nullptr;
}

}  // namespace fde::bench
