#pragma once

#include <functional>
#include <vector>

#include "checkpoint/archive.hpp"
#include "stepping/events.hpp"

namespace fde {

// Finds the zeros of events on one step after the other, in which the path is known at any time. Each is
// located between neighbouring numbers, by the method 748 of Alefeld, Potra & Shi (ACM Trans. Math. Softw. 21
// (1995)). Values at the ends of some pieces of the step show it, which are halved until they show how the
// function goes; two zeros in one piece are found where |value| has a minimum there.
class EventSearch {
 public:
  using Path = std::function<Vec(double t)>;

  // The path is at y at t = 0. The events must live as long.
  EventSearch(const std::vector<Event>& events, In start);

  // Those on the step from the last time up to t, where the path is at y, in the order of time; the first
  // that ends the run is the last. The step is looked at in so many pieces.
  std::vector<Occurrence> step(double t, In y, const Path& path, int pieces);

  void state(Archive& archive) { archive(time_, values_, left_); }

 private:
  const std::vector<Event>& events_;
  double time_ = 0.0;
  std::vector<double> values_;  // of each event, the last that was not 0
  // Samples left to resolve what oscillates within steps; noise would take any number.
  std::uint64_t left_ = 1'000'000;
};

}  // namespace fde
