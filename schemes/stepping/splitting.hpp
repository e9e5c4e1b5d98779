#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "stepping/scheme.hpp"

namespace fde {

// Splits orders into smaller ones: D^1.5 y = f becomes D^1 y = v, D^0.5 v = f. Each new component is a
// derivative of an old one of some node order nu; it starts from the initial value of y where nu is whole,
// otherwise from 0.

// links[i]: the increments, each at most 1, that add up to the order of component i; of an algebraic row the
// one link of order 0.
using Links = std::vector<std::vector<double>>;

// Orders above 1 as 1 + rest, the others whole: for schemes made for orders up to 1.
Links links_up_to_one(const Problem& problem);

// All orders above 0 as multiples of one 1/M, with M at most 64 (Diethelm & Ford 2002); nullopt: there is no
// such M.
std::optional<Links> commensurate_links(const Problem& problem);

// The problem of all links. The right-hand side of component i drives its last link.
Problem split(const Problem& problem, const Links& links);

// How the components of the split problem start.
Smoothness split(const Problem& problem, const Smoothness& smoothness, const Links& links);

// A scheme's solve that splits the problem into these links, solves that and returns the original components.
Solve split_into(std::function<Links(const Problem&)> links, Solve solve);

}  // namespace fde
