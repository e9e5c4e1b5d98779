#pragma once

#include <cstddef>
#include <exception>
#include <functional>

// Long evaluations say how far they are; who listens may end them there.
namespace fde {

// Hears of each step: how many are done of how many, 0 where that is not known.
using WorkListener = std::function<void(std::size_t done, std::size_t total)>;

// What a listener throws to end the work. Evaluations do not take it for a failure of theirs.
struct WorkEnded : std::exception {
  [[nodiscard]] const char* what() const noexcept override { return "the work was ended"; }
};

// The evaluations of this thread are listened to while it lives.
class ListeningToWork {
 public:
  explicit ListeningToWork(WorkListener listener);
  ~ListeningToWork();
  ListeningToWork(const ListeningToWork&) = delete;
  ListeningToWork& operator=(const ListeningToWork&) = delete;
  ListeningToWork(ListeningToWork&&) = delete;
  ListeningToWork& operator=(ListeningToWork&&) = delete;

 private:
  WorkListener before_;
};

// A step of long work is done. Throws what the listener throws.
void report_work(std::size_t done, std::size_t total = 0);

}  // namespace fde
