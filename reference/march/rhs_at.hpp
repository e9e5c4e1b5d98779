#pragma once

#include "problem/problem.hpp"

namespace fde {

Vec rhs_at(const Problem& problem, double t, In y);

// A row each time: of y what is given, of f what is returned.
Matrix rhs_at(const Problem& problem, const Vec& times, const Matrix& y);

}  // namespace fde
