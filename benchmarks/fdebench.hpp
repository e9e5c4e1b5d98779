// SPDX-License-Identifier: MIT
#pragma once

// A problem or a scene, solved, known, fitted and compared: what most programs need.
// fdebench/schemes/problem/problem.hpp declares the problem.
#include "fdebench/benchmarks/requests/choice.hpp"
#include "fdebench/benchmarks/requests/exact.hpp"
#include "fdebench/benchmarks/requests/fit.hpp"
#include "fdebench/benchmarks/requests/own_problem.hpp"
#include "fdebench/benchmarks/requests/own_scheme.hpp"
#include "fdebench/benchmarks/requests/recorded_sweep.hpp"
#include "fdebench/benchmarks/requests/solve.hpp"
#include "fdebench/benchmarks/scenes/variant.hpp"
