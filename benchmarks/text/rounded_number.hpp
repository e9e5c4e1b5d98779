// SPDX-License-Identifier: MIT
#pragma once

namespace fde::bench {

// The double nearest to the value rounded to this many significant digits, which JSON prints with as few.
double rounded(double value, int digits);

}  // namespace fde::bench
