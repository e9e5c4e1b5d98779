// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "fdebench/schemes/problem/problem.hpp"

namespace fde::reference {

// An event at which y jumps (Problem::resets): y is as before up to t and has `jump` more behind it.
struct ResetEvent {
  double t;
  Vec jump;
  bool depends_on_y;  // the time is that of a zero along the solution, otherwise known to the last bit
};

// Finds the events at which y jumps along one run of one method, piece by piece (panel or step). A piece that
// an event cuts is computed again up to the event; then the run goes on with the state behind it.
//
// An event function has a side, the sign that it had last. It has none at t = 0, and behind an event that
// leaves y at a zero of the function, while its value is as small as rounding of y.
class ResetLocator {
 public:
  using Path = std::function<Vec(double t)>;  // y on a piece

  explicit ResetLocator(const Problem& problem);

  // The first event on (from, to] of the piece along `y`: the last double before which no function that
  // counts has changed its sign. nullopt: there is none, or it is next to the end. An event that is found is
  // not looked for again.
  std::optional<double> find(double from, double to, const Path& y);

  // The time of the event that has been found and not been passed; infinite if there is none.
  [[nodiscard]] double next() const { return next_; }

  // To be called at the end of each piece: takes the sides that the functions have at `to`. Throws
  // std::runtime_error where a function without a side returns to the value from which it started: y bounces
  // within its rounding.
  void accept(double from, double to, const Path& y);

  // y at next() becomes the state behind the event. Throws std::runtime_error beyond most_events, and where
  // the last event of the same function is nearer than 1e-9 of the time.
  void pass(Vec& y);

  [[nodiscard]] const std::vector<ResetEvent>& events() const { return events_; }

  // An event that a continuation of y has within 1e-12 of the end, on one side of it or the other, and that
  // has not been passed. y: along the last piece, and a little farther.
  [[nodiscard]] std::optional<ResetEvent> next_to(double end, const Path& y) const;

  static constexpr std::size_t most_events = 100;  // half a minute

 private:
  struct Side {
    int sign = 0;          // -1, 1, or 0: none
    double origin = 0.0;   // the value where it lost its side
    int direction = 0;     // the sign of the value less origin
    bool returns = false;  // to origin
  };
  struct Crossed {
    std::optional<double> at;  // the first zero that counts
    Side side;                 // at the end
  };
  [[nodiscard]] Crossed follow(std::size_t k, double from, double to, const Path& y) const;
  static void leave(Side& side, double value, double noise);
  [[nodiscard]] double noise(std::size_t k, double t, const Vec& y) const;
  [[nodiscard]] bool depends_on_y(std::size_t k, double t, const Vec& y) const;
  [[nodiscard]] bool counts(std::size_t k, int sign) const;

  const Problem& problem_;
  std::vector<Side> sides_{};
  std::vector<double> last_{};          // the time of the last event of each function
  Vec sizes_;                           // the largest |y_i| so far
  std::vector<std::size_t> at_next_{};  // the functions that change their sign at next_
  double next_ = std::numeric_limits<double>::infinity();
  std::vector<ResetEvent> events_{};
};

}  // namespace fde::reference
