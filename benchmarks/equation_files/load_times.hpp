// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "fdebench/benchmarks/expressions/expressions.hpp"
#include "fdebench/benchmarks/scenes/scene.hpp"

namespace fde::bench {

// A function of the end T that gives the LoadTimes of the rows up to T: as jumps the declared ones and the
// times at which the argument of a sign or a step changes its sign, or that of a floor passes a whole number,
// if it depends on t only; as kinks the same for abs and the difference of the arguments of min and max; the
// times at which a table passes a sample where it jumps, or where a derivative of it does, among the jumps
// and the kinks; as limits the intervals in which a part of t alone, or its derivative, rises or falls within
// a time that is short beside the time before or after, in which it hardly changes or goes on the other way.
// A quarter of such an interval is the longest step. Between two zeros of an event function that sets
// unknowns it is half of the time, if the function depends on t only: a step over both would see no change of
// its sign. All are found by interval arithmetic (TimeFunction::signs), not by samples.
std::function<LoadTimes(double end)> load_times(const std::vector<Expression>& rows,
                                                std::vector<double> declared_jumps, ExpressionPool& pool,
                                                const std::vector<Expression>& event_functions = {});

// A function of the end T that gives a time between any two zeros of a function of t alone in [0, T]. The
// zeros are those that interval arithmetic finds.
std::function<std::vector<double>(double end)> times_between_zeros(Expression function, ExpressionPool& pool);

}  // namespace fde::bench
