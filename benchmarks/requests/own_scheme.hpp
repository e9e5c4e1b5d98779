// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde::bench {

// y at all times of a run over a grid, from 0 to the end: one row a component, one column a time. The first
// column is not read, as the problem has its initial values. A column that is not finite ends the run there.
using StatesOfRun = std::function<Rows(const Problem& problem, const std::vector<double>& times)>;

// A scheme of the caller that computes the states of a run at once, as a value: pass scheme() to choose() or
// to sweep() while the object lives. Without capabilities it takes left Caputo derivatives of orders up to 2
// on any grid. Its runs end as those of our schemes do, and throw std::invalid_argument where the states have
// another shape.
class OwnScheme {
 public:
  OwnScheme(std::string id, StatesOfRun states, const Capabilities& capabilities = {});
  OwnScheme(const OwnScheme&) = delete;
  OwnScheme& operator=(const OwnScheme&) = delete;

  [[nodiscard]] const Scheme& scheme() const { return scheme_; }

 private:
  std::string id_;
  Scheme scheme_;
};

// Throws Refusal naming `schemes` unless each has an id of its own, which prints.
void require_own_ids(const std::vector<const Scheme*>& own);

}  // namespace fde::bench
