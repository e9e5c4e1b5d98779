// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "fdebench/schemes/stepping/scheme.hpp"

namespace fde {

// Splits orders into smaller ones: D^1.5 y = f becomes D^1 y = v, D^0.5 v = f. Each new component is D^nu y
// of an original component y; its initial value is y^(nu)(0) for integer nu, otherwise 0.

// links[i]: the increments, each at most 1, that add up to the order of component i; {0} for an algebraic
// row.
using OrderSplitting = std::vector<std::vector<double>>;

// Splits orders above 1 into 1 and the rest and keeps the others: for schemes for orders up to 1.
OrderSplitting splitting_up_to_one(const Problem& problem);

// Splits every order above 0 into multiples of one 1/M with the smallest M <= 64 (Diethelm & Ford 2002);
// nullopt: there is no such M.
std::optional<OrderSplitting> commensurate_splitting(const Problem& problem);

// The problem with one component per link. The last link of component i has the right-hand side f_i, the
// others the next link.
Problem split_orders(const Problem& problem, const OrderSplitting& links);

// The expansion at t = 0 of the components of the split problem.
Smoothness split_orders(const Problem& problem, const Smoothness& smoothness, const OrderSplitting& links);

// Scheme::solve that splits the problem into these links, calls `solve` and returns the original components.
Solve with_split_orders(std::function<OrderSplitting(const Problem&)> links, Solve solve);

}  // namespace fde
