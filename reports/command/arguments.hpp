#pragma once

#include <string>
#include <string_view>

#include "scenes/variant.hpp"
#include "stepping/scheme.hpp"

namespace fde {

// Texts of the command line into values. Each throws std::invalid_argument naming the argument, the text and
// what is allowed.

// "1", "-2.5i", "1e-3+i" into the texts of real and imaginary part; the parts are not checked.
struct ComplexText {
  std::string re, im;
};
ComplexText split_complex(std::string_view text);

// "uniform" or "graded:R", R >= 1.
Grid parse_grid(std::string_view text, double end, int steps);

const Scheme& scheme_named(std::string_view id);

inline constexpr int most_digits = 100'000;
inline constexpr int most_steps = 1'000'000'000;  // weights are checked up to this lag

}  // namespace fde
