#pragma once

#include <cstddef>
#include <exception>
#include <functional>

// Solves and long evaluations say how far they are; who listens may end them there.
namespace fde {

// Hears of each step: how many are done of how many, 0 where that is not known.
using WorkListener = std::function<void(std::size_t done, std::size_t total)>;

// What a listener throws to end the work. Evaluations do not take it for a failure of theirs.
struct WorkEnded : std::exception {
  [[nodiscard]] const char* what() const noexcept override { return "the work was ended"; }
};

// The work of this thread is listened to while it lives, also by those who listened before.
class ListeningToWork {
 public:
  explicit ListeningToWork(WorkListener listener);
  ~ListeningToWork();
  ListeningToWork(const ListeningToWork&) = delete;
  ListeningToWork& operator=(const ListeningToWork&) = delete;
  ListeningToWork(ListeningToWork&&) = delete;
  ListeningToWork& operator=(ListeningToWork&&) = delete;

 private:
  friend void report_work(std::size_t done, std::size_t total);
  WorkListener listener_;
  ListeningToWork* before_;
};

// A step of long work is done. Throws what a listener throws.
void report_work(std::size_t done, std::size_t total = 0);

}  // namespace fde
