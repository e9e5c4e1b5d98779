#pragma once

#include "equation_files/equation_system.hpp"
#include "reference.hpp"

namespace fde {

// The columns as [exact] gives them, with a bound of what rounding does. A derivative of an unknown that is
// not given follows from the unknown where its order is whole, or where the unknown is a sum of powers of t.
// Throws std::invalid_argument naming file, line and column of what is no formula of t, and the column that
// is not given.
Reference exact_columns(const EquationText& text, const Parameters& parameters,
                        const std::vector<SystemColumn>& columns);

}  // namespace fde
